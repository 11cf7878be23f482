// The internal table `lsos_checkpoints` of a log. GDAL does not list it as a layer. Only for use in
// this folder; errors are reported by a QuietErrors around the calls.
#pragma once

#include <optional>

#include "record/checkpoint.h"
#include "record/gpkg.h"
#include "record/sqlite.h"

namespace lsos::gpkg {

void make_checkpoint_table(GDALDataset& dataset);
// Adds one, and removes the oldest `recent` ones but a few.
void add_checkpoint(GDALDataset& dataset, StoredCheckpoint& checkpoint);
// Removes all but the kept ones, and the table when none is left.
void remove_passing_checkpoints(GDALDataset& dataset);
// Removes those written after this one; after 0: all.
void remove_checkpoints_after(GDALDataset& dataset, std::int64_t id);

// Oldest first; empty where there is no table. Throws InputError for one that none of ours holds.
std::vector<CheckpointEntry> checkpoint_entries(const sqlite::Database& database);
// nullopt: it is damaged, not there, or not of this form.
std::optional<StoredCheckpoint> read_checkpoint(const sqlite::Database& database, std::int64_t id);

// The one row of the internal table `lsos_branch`.
void write_branch(GDALDataset& dataset, const BranchOrigin& origin);
// Throws InputError where it holds something else.
std::optional<BranchOrigin> read_branch(const sqlite::Database& database);

}  // namespace lsos::gpkg
