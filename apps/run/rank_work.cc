// SPDX-License-Identifier: BSD-3-Clause
#include <apps/run/interrupt.h>
#include <apps/run/rank_work.h>
#include <fem/state_bytes.h>

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <thread>

namespace tamp::apps
{
namespace
{
using namespace std::chrono_literals;
// Ranks tell each other news so often: little beside a probe, and little work.
constexpr auto pause = 20ms;
// Who waits for the others to tell theirs looks so often whether they have.
constexpr auto nap = 1ms;

/// What a rank tells the others, in numbers that MPI knows.
enum News : std::size_t {
  free_threads,
  piece_done, ///< or -1
  signal_caught,
  checkpoints_asked,
  numbers
};

class Sharing
{
public:
  Sharing(const fem::Ranks &ranks, const RankWork &shared)
      : ranks_(ranks), shared_(shared), ends_(shared.order.size()),
        news_(numbers * ranks.size()), left_(shared.order.size())
  {
  }

  std::vector<RunEnd> work()
  {
    while (left_ > 0) {
      tell();
      const bool quiet = hear();
      hand_out();
      if (quiet)
        std::this_thread::sleep_for(pause);
    }
    exchange_ends();
    return ends_;
  }

private:
  struct Busy {
    std::size_t piece;
    std::future<RunEnd> end;
  };

  double &news(unsigned rank, News what)
  {
    return news_[numbers * rank + what];
  }

  void tell()
  {
    const unsigned own = ranks_.rank();
    news(own, signal_caught) = caught_signal();
    news(own, checkpoints_asked) = checkpoint_signals();
    news(own, piece_done) = -1;
    const auto ready = std::ranges::find_if(busy_, [](const Busy &busy) {
      return busy.end.wait_for(0s) == std::future_status::ready;
    });
    if (ready != busy_.end()) {
      news(own, piece_done) = static_cast<double>(ready->piece);
      ends_[ready->piece] = ready->end.get();
      own_.push_back(ready->piece);
      busy_.erase(ready);
    }
    news(own, free_threads) = static_cast<double>(shared_.threads) -
                              static_cast<double>(busy_.size());
    exchange_news();
  }

  // Leaves the core to those who work: waiting for others in MPI takes it all.
  void exchange_news()
  {
    if (ranks_.size() == 1)
      return;
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Iallgather(MPI_IN_PLACE,
                   0,
                   MPI_DATATYPE_NULL,
                   news_.data(),
                   numbers,
                   MPI_DOUBLE,
                   ranks_.communicator(),
                   &request);
    for (int all = 0;; std::this_thread::sleep_for(nap)) {
      MPI_Test(&request, &all, MPI_STATUS_IGNORE);
      if (all != 0)
        return;
    }
  }

  // Whether nobody has done anything.
  bool hear()
  {
    bool quiet = true;
    for (unsigned rank = 0; rank < ranks_.size(); ++rank) {
      catch_signals_of_others(static_cast<int>(news(rank, signal_caught)),
                              static_cast<int>(news(rank, checkpoints_asked)));
      if (news(rank, piece_done) < 0)
        continue;
      quiet = false;
      --left_;
      shared_.done(static_cast<std::size_t>(news(rank, piece_done)), rank);
    }
    return quiet;
  }

  // One to each rank, again and again, while any has a thread free.
  void hand_out()
  {
    for (bool free = true; free;) {
      free = false;
      for (unsigned rank = 0; rank < ranks_.size(); ++rank)
        if (next_ < shared_.order.size() && news(rank, free_threads) > 0) {
          --news(rank, free_threads);
          free = true;
          const std::size_t piece = shared_.order[next_++];
          if (rank == ranks_.rank())
            busy_.push_back({piece, begin(piece)});
        }
    }
  }

  std::future<RunEnd> begin(std::size_t piece) const
  {
    const auto work = [this, piece]() -> RunEnd {
      try {
        return shared_.work(piece);
      } catch (...) {
        return end_of(std::current_exception());
      }
    };
    try {
      return std::async(std::launch::async, work);
    } catch (...) { // no thread is to be had
      std::promise<RunEnd> failed;
      failed.set_value(end_of(std::current_exception()));
      return failed.get_future();
    }
  }

  void exchange_ends()
  {
    std::vector<char> bytes;
    for (const std::size_t piece : own_) {
      fem::append_state(bytes, piece);
      fem::append_state(bytes, ends_[piece].code);
      fem::append_state(bytes, ends_[piece].message);
    }
    const std::vector<char> all = ranks_.join(bytes);
    for (fem::StateBytes rest(all); !rest.rest().empty();) {
      std::size_t piece = 0;
      rest.take(piece);
      rest.take(ends_.at(piece).code);
      rest.take(ends_[piece].message);
    }
  }

  const fem::Ranks &ranks_;
  const RankWork &shared_;
  std::vector<RunEnd> ends_;
  std::vector<std::size_t> own_; ///< pieces that this rank has done
  std::vector<double> news_;     ///< numbers of each rank
  std::size_t next_ = 0, left_;  ///< in the order; not done yet
  std::vector<Busy> busy_;       ///< last: their threads end before the rest
};
} // namespace

std::vector<RunEnd> share_among_ranks(const fem::Ranks &ranks,
                                      const RankWork &shared)
{
  return Sharing(ranks, shared).work();
}
} // namespace tamp::apps
