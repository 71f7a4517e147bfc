// SPDX-License-Identifier: BSD-3-Clause
#include <apps/citations.h>
#include <apps/run/build_facts.h>

#include <algorithm>
#include <cassert>
#include <fmt/format.h>
#include <map>

namespace tamp::apps
{
namespace
{
using Keys = std::vector<std::string_view>;

struct Entry {
  std::string_view key, kind, fields;
};

// What could not be verified is left out: a field that is absent, for example.
constexpr Entry entries[] = {
    {"dealii94", "article", R"(
  author  = {Arndt, Daniel and others},
  title   = {The deal.II library, Version 9.4},
  journal = {Journal of Numerical Mathematics},
  volume  = {30},
  number  = {3},
  pages   = {231--246},
  year    = {2022},
  doi     = {10.1515/jnma-2022-0054})"},
    {"petsc", "inproceedings", R"(
  author    = {Balay, Satish and Gropp, William D. and McInnes, Lois Curfman
               and Smith, Barry F.},
  title     = {Efficient Management of Parallelism in Object Oriented
               Numerical Software Libraries},
  booktitle = {Modern Software Tools in Scientific Computing},
  editor    = {Arge, E. and Bruaset, A. M. and Langtangen, H. P.},
  pages     = {163--202},
  publisher = {Birkh{\"a}user Press},
  year      = {1997})"},
    {"trilinos", "article", R"(
  author  = {Heroux, Michael A. and Bartlett, Roscoe A. and Howle, Vicki E.
             and Hoekstra, Robert J. and Hu, Jonathan J. and Kolda, Tamara G.
             and Lehoucq, Richard B. and Long, Kevin R. and Pawlowski, Roger
             P. and Phipps, Eric T. and Salinger, Andrew G. and Thornquist,
             Heidi K. and Tuminaro, Ray S. and Willenbring, James M. and
             Williams, Alan and Stanley, Kendall S.},
  title   = {An Overview of the {Trilinos} Project},
  journal = {ACM Transactions on Mathematical Software},
  volume  = {31},
  number  = {3},
  pages   = {397--423},
  year    = {2005},
  doi     = {10.1145/1089014.1089021})"},
    {"openmpi", "inproceedings", R"(
  author    = {Gabriel, Edgar and others},
  title     = {{Open MPI}: Goals, Concept, and Design of a Next Generation
               {MPI} Implementation},
  booktitle = {Recent Advances in Parallel Virtual Machine and Message Passing
               Interface},
  series    = {LNCS},
  volume    = {3241},
  pages     = {97--104},
  publisher = {Springer},
  year      = {2004},
  doi       = {10.1007/978-3-540-30218-6_19})"},
    {"eigen", "misc", R"(
  author       = {Guennebaud, Ga{\"e}l and Jacob, Beno{\^i}t and others},
  title        = {Eigen v3},
  howpublished = {http://eigen.tuxfamily.org},
  year         = {2010})"},
    {"highway", "misc", R"(
  author       = {{The Highway authors}},
  title        = {Highway: performance-portable, length-agnostic SIMD},
  howpublished = {https://github.com/google/highway})"},
    {"vtk", "book", R"(
  author    = {Schroeder, Will and Martin, Ken and Lorensen, Bill},
  title     = {The Visualization Toolkit (4th ed.)},
  publisher = {Kitware},
  year      = {2006},
  isbn      = {978-1-930934-19-1})"},
    {"sheng2004", "article", R"(
  author  = {Sheng, Y. and Lawrence, C. J. and Briscoe, B. J. and Thornton, C.},
  title   = {Numerical studies of uniaxial powder compaction process by {3D}
             {DEM}},
  journal = {Engineering Computations},
  year    = {2004})"},
    {"bitzek2006", "article", R"(
  author  = {Bitzek, Erik and Koskinen, Pekka and G{\"a}hler, Franz and
             Moseler, Michael and Gumbsch, Peter},
  title   = {Structural Relaxation Made Simple},
  journal = {Physical Review Letters},
  volume  = {97},
  pages   = {170201},
  year    = {2006},
  doi     = {10.1103/PhysRevLett.97.170201})"},
    {"walker2011", "article", R"(
  author  = {Walker, H. F. and Ni, P.},
  title   = {{Anderson} acceleration for fixed-point iterations},
  journal = {SIAM Journal on Numerical Analysis},
  volume  = {49},
  number  = {4},
  pages   = {1715--1735},
  year    = {2011},
  doi     = {10.1137/10078356X})"},
    {"hertz1882", "article", R"(
  author  = {Hertz, Heinrich},
  title   = {Ueber die Ber{\"u}hrung fester elastischer K{\"o}rper},
  journal = {Journal f{\"u}r die reine und angewandte Mathematik},
  volume  = {92},
  pages   = {156--171},
  year    = {1882})"},
    {"thornton1997", "article", R"(
  author  = {Thornton, C.},
  title   = {Coefficient of restitution for collinear collisions of
             elastic-perfectly plastic spheres},
  journal = {Journal of Applied Mechanics},
  volume  = {64},
  number  = {2},
  pages   = {383},
  year    = {1997})"},
    {"thornton1998", "article", R"(
  author  = {Thornton, C. and Ning, Z.},
  title   = {A theoretical model for the stick/bounce behaviour of adhesive,
             elastic-plastic spheres},
  journal = {Powder Technology},
  volume  = {99},
  number  = {2},
  pages   = {154--162},
  year    = {1998},
  doi     = {10.1016/S0032-5910(98)00099-0})"},
    {"johnson1971", "article", R"(
  author  = {Johnson, K. L. and Kendall, K. and Roberts, A. D.},
  title   = {Surface energy and the contact of elastic solids},
  journal = {Proceedings of the Royal Society of London A},
  volume  = {324},
  number  = {1558},
  pages   = {301--313},
  year    = {1971},
  doi     = {10.1098/rspa.1971.0141})"},
    {"storakers1997", "article", R"(
  author  = {Stor{\aa}kers, B. and Biwa, S. and Larsson, P.-L.},
  title   = {Similarity analysis of inelastic contact},
  journal = {International Journal of Solids and Structures},
  volume  = {34},
  number  = {24},
  pages   = {3061},
  year    = {1997})"},
    {"zunker2024a", "article", R"(
  author  = {Zunker, William and Kamrin, Ken},
  title   = {A mechanically-derived contact model for adhesive
             elastic-perfectly plastic particles, Part {I}: Utilizing the
             method of dimensionality reduction},
  journal = {Journal of the Mechanics and Physics of Solids},
  volume  = {183},
  pages   = {105492},
  year    = {2024},
  doi     = {10.1016/j.jmps.2023.105492})"},
    {"zunker2024b", "article", R"(
  author  = {Zunker, William and Kamrin, Ken},
  title   = {A mechanically-derived contact model for adhesive
             elastic-perfectly plastic particles, Part {II}: Contact under
             high compaction -- modeling a bulk elastic response},
  journal = {Journal of the Mechanics and Physics of Solids},
  volume  = {183},
  pages   = {105493},
  year    = {2024},
  doi     = {10.1016/j.jmps.2023.105493})"},
    {"zunker2025", "article", R"(
  author  = {Zunker, William and Dunatunga, Sachith and Thakur, Subhash and
             Tang, Pingjun and Kamrin, Ken},
  title   = {Experimentally validated {DEM} for large deformation powder
             compaction: mechanically-derived contact model and screening of
             non-physical contacts},
  journal = {Powder Technology},
  pages   = {120972},
  year    = {2025},
  doi     = {10.1016/j.powtec.2025.120972})"},
    {"mindlin1949", "article", R"(
  author  = {Mindlin, R. D.},
  title   = {Compliance of elastic bodies in contact},
  journal = {Journal of Applied Mechanics},
  volume  = {16},
  pages   = {259--268},
  year    = {1949})"},
    {"thornton2013", "article", R"(
  author  = {Thornton, C. and Cummins, S. J. and Cleary, P. W.},
  title   = {An investigation of the comparative behaviour of alternative
             contact force models during inelastic collisions},
  journal = {Powder Technology},
  volume  = {233},
  pages   = {30--46},
  year    = {2013})"},
    {"mindlin1953", "article", R"(
  author  = {Mindlin, R. D. and Deresiewicz, H.},
  title   = {Elastic spheres in contact under varying oblique forces},
  journal = {Journal of Applied Mechanics},
  volume  = {20},
  number  = {3},
  pages   = {327--344},
  year    = {1953},
  doi     = {10.1115/1.4010702})"},
    {"ai2011", "article", R"(
  author  = {Ai, Jun and Chen, Jian-Fei and Rotter, J. Michael and Ooi, Jin Y.},
  title   = {Assessment of rolling resistance models in discrete element
             simulations},
  journal = {Powder Technology},
  volume  = {206},
  number  = {3},
  pages   = {269--282},
  year    = {2011},
  doi     = {10.1016/j.powtec.2010.09.030})"},
    {"drucker1957", "article", R"(
  author  = {Drucker, D. C. and Gibson, R. E. and Henkel, D. J.},
  title   = {Soil mechanics and work-hardening theories of plasticity},
  journal = {Transactions of the American Society of Civil Engineers},
  volume  = {122},
  pages   = {338--346},
  year    = {1957})"},
    {"roscoe1968", "incollection", R"(
  author    = {Roscoe, K. H. and Burland, J. B.},
  title     = {On the generalized stress-strain behaviour of `wet' clay},
  booktitle = {Engineering Plasticity},
  pages     = {535--609},
  year      = {1968})"},
    {"fleck1992", "article", R"(
  author  = {Fleck, N. A. and Kuhn, L. T. and McMeeking, R. M.},
  title   = {Yielding of metal powder bonded by isolated contacts},
  journal = {Journal of the Mechanics and Physics of Solids},
  volume  = {40},
  pages   = {1139--1162},
  year    = {1992})"},
    {"gurson1977", "article", R"(
  author  = {Gurson, A. L.},
  title   = {Continuum Theory of Ductile Rupture by Void Nucleation and
             Growth: Part {I} -- Yield Criteria and Flow Rules for Porous
             Ductile Media},
  journal = {Journal of Engineering Materials and Technology},
  volume  = {99},
  pages   = {2--15},
  year    = {1977},
  doi     = {10.1115/1.3443401})"},
    {"heckel1961", "article", R"(
  author  = {Heckel, R. W.},
  title   = {Density-pressure relationships in powder compaction},
  journal = {Transactions of the Metallurgical Society of AIME},
  volume  = {221},
  pages   = {671--675},
  year    = {1961})"},
    {"kawakita1971", "article", R"(
  author  = {Kawakita, K. and L{\"u}dde, K. H.},
  title   = {Some considerations on powder compression equations},
  journal = {Powder Technology},
  volume  = {4},
  number  = {2},
  pages   = {61--68},
  year    = {1971},
  doi     = {10.1016/0032-5910(71)80001-3})"},
    {"walker1923", "article", R"(
  author  = {Walker, E. E.},
  title   = {The properties of powders. Part {VI}. The compressibility of
             powders},
  journal = {Transactions of the Faraday Society},
  year    = {1923})"},
    {"panelli2001", "article", R"(
  author  = {Panelli, Renato and Ambrozio Filho, Francisco},
  title   = {A study of a new phenomenological compacting equation},
  journal = {Powder Technology},
  volume  = {114},
  pages   = {255--261},
  year    = {2001})"},
    {"adams1994", "article", R"(
  author  = {Adams, M. J. and Mullier, M. A. and Seville, J. P. K.},
  title   = {Agglomerate strength measurement using a uniaxial confined
             compression test},
  journal = {Powder Technology},
  volume  = {78},
  pages   = {5--13},
  year    = {1994})"},
};

/// What stands on what, by parameter and value.
const std::map<std::string_view, Keys> normal_laws{
    {"hertz", {"hertz1882"}},
    {"thornton-ning", {"hertz1882", "thornton1997", "thornton1998"}},
    {"jkr", {"johnson1971"}},
    {"thornton-ning-jkr", {"johnson1971", "thornton1998"}},
    {"storakers", {"storakers1997"}},
    {"mdr", {"zunker2024a", "zunker2024b", "zunker2025"}},
    {"thornton-ning-adjusted",
     {"hertz1882", "thornton1997", "thornton1998", "sheng2004"}}};
const std::map<std::string_view, Keys> tangential_laws{
    {"none", {}},
    {"mindlin", {"mindlin1949", "thornton2013"}},
    {"mindlin-deresiewicz", {"mindlin1953"}}};
const std::map<std::string_view, Keys> rolling_laws{{"none", {}},
                                                    {"epsd", {"ai2011"}}};
const std::map<std::string_view, Keys> continua{
    {"elastic", {}},
    {"drucker-prager cap", {"drucker1957"}},
    {"modified cam-clay", {"roscoe1968"}},
    {"fkm-gurson", {"fleck1992", "gurson1977"}}};
const std::map<std::string_view, Keys> methods{{"quasi-static", {"bitzek2006"}},
                                               {"dynamics", {}}};
const std::map<std::string_view, Keys> solvers{
    {"automatic", {}}, {"newton", {}}, {"anderson", {"walker2011"}}};
const std::map<std::string_view, Keys> algebras{{"petsc", {"petsc"}},
                                                {"trilinos", {"trilinos"}}};
} // namespace

std::vector<std::string_view> all_citations()
{
  Keys keys{"tamp"};
  for (const Entry &entry : entries)
    keys.push_back(entry.key);
  return keys;
}

std::vector<std::string_view> citations_of(const ParameterTable &table)
{
  Keys used{"tamp", "eigen"};
  const auto use = [&](const Keys &keys) {
    used.insert(used.end(), keys.begin(), keys.end());
  };
  const auto use_by = [&](const std::map<std::string_view, Keys> &works,
                          const std::string &path) {
    use(works.at(table.word(path)));
  };
  const bool die = table.given_below("Die") || table.given_below("Schedule");
  const bool pair = table.given_below("Pair");
  const std::string material = table.word("Material/Type");
  const bool cells = !pair && material == "unit cell";
  use({"dealii94"}); // its tensors everywhere
  if (die) {
    use({"openmpi"});
    use_by(algebras, "Solver/Linear algebra");
    use_by(solvers, "Solver/Nonlinear method");
    if (cells && table.word("Solver/Nonlinear method") == "automatic")
      use(solvers.at("anderson"));
  }
  if (cells) {
    use({"highway", "vtk", "sheng2004"});
    use_by(methods, "Cell/Method");
  }
  if (cells || pair) {
    use_by(normal_laws, "Contact/Normal law");
    use_by(tangential_laws, "Contact/Tangential law");
    use_by(rolling_laws, "Contact/Rolling law");
  } else
    use(continua.at(material));
  Keys keys = all_citations();
  std::erase_if(keys, [&](std::string_view key) {
    return !std::ranges::count(used, key);
  });
  return keys;
}

std::string citation(std::string_view key)
{
  if (key == "tamp")
    return "@software{tamp,\n"
           "  author  = {{The tamp authors}},\n"
           "  title   = "
           "{tamp: multiscale powder die compaction, finite elements over unit "
           "cells "
           "of grains},\n  version = {" +
           build_facts().version + "}\n}\n";
  const auto entry = std::ranges::find(entries, key, &Entry::key);
  assert(entry != entries.end());
  return fmt::format(
      "@{}{{{},{}\n}}\n", entry->kind, entry->key, entry->fields);
}
} // namespace tamp::apps
