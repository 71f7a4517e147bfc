// SPDX-License-Identifier: BSD-3-Clause
#include <apps/density_field.h>
#include <apps/parameter_table.h>
#include <fem/kinematics.h>

#include <deal.II/base/function_parser.h>

#include <cmath>
#include <exception>
#include <fmt/format.h>
#include <map>
#include <string>

namespace tamp::apps
{
namespace
{
constexpr const char *entry = "Die/Initial density";

/// A formula of x, y, z and r = sqrt(x^2 + y^2) [m].
class Formula
{
public:
  explicit Formula(const std::string &text)
  {
    // The library's name for a fourth variable is time.
    parser_.initialize("x,y,z,r", text, std::map<std::string, double>(), true);
  }

  double at(const dealii::Tensor<1, 3> &place)
  {
    parser_.set_time(std::hypot(place[0], place[1]));
    return parser_.value(dealii::Point<3>(place));
  }

private:
  dealii::FunctionParser<3> parser_;
};
} // namespace

std::vector<double> read_density_field(const ParameterTable &table,
                                       const fem::Mesh &mesh)
{
  const std::string text = table.word(entry);
  if (text.empty())
    return {};
  std::vector<double> densities;
  std::string problem;
  try {
    Formula formula(text);
    for (const dealii::Tensor<1, 3> &place : fem::point_positions(mesh)) {
      const double density = formula.at(place);
      densities.push_back(density);
      if (problem.empty() && !(density > 0 && density < 1))
        problem = fmt::format("it is {:.4g} at x = {:.4g} m, y = {:.4g} m, z = "
                              "{:.4g} m; expected "
                              "relative densities between 0 and 1",
                              density,
                              place[0],
                              place[1],
                              place[2]);
    }
  } catch (const std::exception &) { // of the library, of several lines
    problem = "expected a formula of x, y, z and r in metres, such as "
              "0.36 - 2*z + if(r < 0.002, 0.01, 0)";
  }
  if (!problem.empty())
    table.complain(entry, problem);
  return densities;
}
} // namespace tamp::apps
