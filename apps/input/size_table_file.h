// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_size_table_file_h
#define apps_input_size_table_file_h

#include <dem/grain_sizes.h>

#include <filesystem>

namespace tamp::apps
{
/// Reads a measured size distribution: CSV with remarks after #, a header of
/// names with units, and numbers. One column is `diameter`; another one says
/// how many grains there are:
///
/// - `cumulative_share_by_number`, `..._by_volume`, `..._by_mass`: the share
///   that is smaller than the diameter, from 0 to all;
/// - `share_by_number`, `..._by_volume`, `..._by_mass`: the share that has this
///   diameter.
///
/// Other columns are passed over. Shares are divided by the last one or by
/// their sum, which must be 1 within one per cent. Mass is volume: grains of
/// one table are of one solid. Throws InputError, "FILE:LINE: ...".
dem::GrainSizes read_size_table(const std::filesystem::path &file);
} // namespace tamp::apps

#endif
