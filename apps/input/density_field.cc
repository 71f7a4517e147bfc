// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/density_field.h>
#include <apps/input/density_grid.h>
#include <apps/input/parameter_table.h>
#include <fem/kinematics.h>

#include <deal.II/base/function_parser.h>

#include <cmath>
#include <exception>
#include <fmt/format.h>
#include <map>
#include <memory>

namespace tamp::apps
{
namespace
{
constexpr const char *formula_entry = "Die/Initial density";
constexpr const char *file_entry = "Die/Initial density file";

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

DensityField field_of(const std::string &text)
{
  // Made at the first place: what is wrong with it may show there, too.
  std::shared_ptr<Formula> formula;
  return [text, formula](const dealii::Tensor<1, 3> &place) mutable {
    try {
      if (!formula)
        formula = std::make_shared<Formula>(text);
      return formula->at(place);
    } catch (const std::exception &) { // of several lines
      throw InputError("expected a formula of x, y, z and r in metres, such as "
                       "0.36 - 2*z + if(r < 0.002, 0.01, 0)");
    }
  };
}

double density_at(const dealii::Tensor<1, 3> &place, const DensityField &field)
{
  const double density = field(place);
  if (!(density > 0 && density < 1))
    throw InputError(fmt::format("it is {:.4g} at x = {:.4g} m, y = {:.4g} m, "
                                 "z = {:.4g} m; expected "
                                 "relative densities between 0 and 1",
                                 density,
                                 place[0],
                                 place[1],
                                 place[2]));
  return density;
}
} // namespace

std::string density_entry(const ParameterTable &table)
{
  for (const std::string entry : {file_entry, formula_entry})
    if (!table.word(entry).empty())
      return entry;
  return {};
}

std::vector<double> read_density_field(const ParameterTable &table,
                                       const fem::Mesh &mesh)
{
  const std::string entry = density_entry(table);
  if (entry.empty())
    return {};
  const bool from_file = entry == file_entry;
  if (from_file && !table.word(formula_entry).empty())
    table.complain(
        entry, std::string("expected it or ") + formula_entry + ", not both");
  std::vector<double> densities;
  try {
    const std::string text = table.word(entry);
    const DensityField field =
        from_file ? read_density_grid(table.folder(entry) / text)
                  : field_of(text);
    for (const dealii::Tensor<1, 3> &place : fem::point_positions(mesh))
      densities.push_back(density_at(place, field));
  } catch (const InputError &error) {
    table.complain(entry, error.what());
  }
  return densities;
}
} // namespace tamp::apps
