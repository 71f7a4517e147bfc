// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_continuum_points_h
#define fem_laws_continuum_points_h

#include <fem/material_points.h>

#include <chrono>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace tamp::fem
{
/// Makes any continuum law material points. A law is a value with
///   - `name`, a constant that tells its states from those of other laws,
///   - a nested trivially copyable `State`,
///   - `State initial_state() const`, and
///   - `Response respond(const State &old, State &now, const Deformation &,
///     Want) const`, which gives `now` a value in every case.
/// It may have `static std::vector<Variable> variables()` and `void
/// variables_of(const State &, std::span<double>) const`.
template <class Law>
class ContinuumPoints final : public MaterialPoints
{
public:
  using State = typename Law::State;
  static_assert(std::is_trivially_copyable_v<State>);
  static constexpr bool has_variables = requires { Law::variables(); };

  /// @param size  number of points, all in the law's initial state.
  ContinuumPoints(Law law, const std::size_t size)
      : law_(std::move(law)), committed_(size, law_.initial_state()),
        trial_(committed_)
  {
  }

  /// @param states  in which the points begin.
  ContinuumPoints(Law law, std::vector<State> states)
      : law_(std::move(law)), committed_(std::move(states)), trial_(committed_)
  {
  }

  std::size_t size() const override { return committed_.size(); }

  void evaluate(std::span<const Deformation> deformations,
                const Want want,
                std::span<Response> responses) override
  {
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < committed_.size(); ++i)
      responses[i] =
          law_.respond(committed_[i], trial_[i], deformations[i], want);
    const std::chrono::duration<double> spent =
        std::chrono::steady_clock::now() - start;
    mean_cost_ = committed_.empty() ? 0 : spent.count() / committed_.size();
  }

  void commit() override { committed_ = trial_; }

  void pack(const std::size_t point, std::vector<char> &bytes) const override
  {
    const auto state = as_bytes(&committed_[point], sizeof(State));
    const std::uint64_t head = header(state);
    bytes.insert(bytes.end(),
                 as_bytes(&head, sizeof head).begin(),
                 as_bytes(&head, sizeof head).end());
    bytes.insert(bytes.end(), state.begin(), state.end());
  }

  void unpack(const std::size_t point, std::span<const char> bytes) override
  {
    std::uint64_t head = 0;
    if (bytes.size() != sizeof head + sizeof(State))
      refuse("their number is wrong");
    std::memcpy(&head, bytes.data(), sizeof head);
    const std::string_view state(bytes.data() + sizeof head, sizeof(State));
    if (head != header(state))
      refuse("they belong to another law or are damaged");
    std::memcpy(&committed_[point], state.data(), sizeof(State));
    trial_[point] = committed_[point];
  }

  /// The same for all points: the mean of the last evaluate().
  double cost(std::size_t) const override { return mean_cost_; }

  std::vector<Variable> variables() const override
  {
    if constexpr (has_variables)
      return Law::variables();
    return {};
  }

  void variables_of([[maybe_unused]] const std::size_t point,
                    [[maybe_unused]] std::span<double> values) const override
  {
    if constexpr (has_variables)
      law_.variables_of(committed_[point], values);
  }

  const Law &law() const { return law_; }
  /// The committed state of a point.
  const State &state(const std::size_t point) const
  {
    return committed_[point];
  }

private:
  static std::string_view as_bytes(const void *data, const std::size_t size)
  {
    return {static_cast<const char *>(data), size};
  }

  /// FNV-1a hash of the law's name and the state.
  static std::uint64_t header(const std::string_view state)
  {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const std::string_view text : {std::string_view(Law::name), state})
      for (const char letter : text)
        hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3u;
    return hash;
  }

  [[noreturn]] static void refuse(const std::string &why)
  {
    throw std::runtime_error("these bytes are no state of the law '" +
                             std::string(Law::name) + "': " + why);
  }

  Law law_;
  std::vector<State> committed_, trial_;
  double mean_cost_ = 0;
};
} // namespace tamp::fem

#endif
