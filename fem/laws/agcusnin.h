// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_agcusnin_h
#define fem_laws_agcusnin_h

#include <fem/laws/drucker_prager_cap.h>

/// Density-dependent Drucker-Prager cap tables of a mixed metal powder, Ag57.6
/// Cu22.4 Sn10 In10, K = 1.
///
/// Source: retyped from the public repository m-aryayi/Abaqus-Projects
/// (ZhouEt_al2017, commit 3e8bbff), a replica of Zhou et al. (2017), Powder
/// Technology, doi 10.1016/j.powtec.2016.09.061. The hardening table is that of
/// the source. Its cohesion is taken as the exponential that fits it, d =
/// 24180.7 Pa exp(13.07 (D - 0.42)), in rows 0.02 apart, between which lines
/// are at most 0.9 % too high. Of friction angle, eccentricity, Young's modulus
/// and Poisson's ratio only the ends are kept, at D = 0.42 and 0.90: straight
/// lines between them are an assumption made here.
namespace tamp::fem::agcusnin
{
/// Where the powder starts and where its plastic strain is zero [-].
inline constexpr double initial_density = 0.42;

/// All constants of the law; alpha = 0.02. Dilation is bounded: with full
/// dilation plastic work is negative over most of the shear line below p_a / 2,
/// since p_a tan(beta) is twenty times the cohesion, and an emerging compact
/// breaks up.
DruckerPragerCapParameters parameters();
} // namespace tamp::fem::agcusnin

#endif
