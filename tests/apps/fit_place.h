// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_apps_fit_place_h
#define tests_apps_fit_place_h

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace tamp::apps
{
/// A folder of one test, removed at its end.
class FitPlace
{
public:
  FitPlace()
      : folder(std::filesystem::temp_directory_path() /
               ("tamp_fit_" + std::to_string(getpid()) + "_" +
                testing::UnitTest::GetInstance()->current_test_info()->name()))
  {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
  }
  ~FitPlace() { std::filesystem::remove_all(folder); }
  FitPlace(const FitPlace &) = delete;
  FitPlace &operator=(const FitPlace &) = delete;

  std::filesystem::path operator/(const std::string &name) const
  {
    return folder / name;
  }
  void write(const std::string &name, const std::string &text) const
  {
    std::filesystem::create_directories((folder / name).parent_path());
    std::ofstream(folder / name) << text;
  }

  std::filesystem::path folder;
};
} // namespace tamp::apps

#endif
