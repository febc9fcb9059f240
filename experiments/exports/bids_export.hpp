// A study as a dataset of BIDS 1.11 (bids-specification.readthedocs.io).
//
//   dataset_description.json, README, participants.tsv
//   sub-P01/ses-01/beh/..._events.tsv, _beh.tsv, _recording-eye1_physio.tsv.gz, each with its .json
//   stimuli/TASK_scene.json, TASK_protocol.json
//
// The frames and steps of a study have no place in BIDS: the CSV export has all of it.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "experiments/exports/csv_export.hpp"

namespace impetus::inline exports {

/// Writes into `folder`, which exists and is empty. Throws StoreError when the study cannot be read
/// or a file cannot be written.
ExportReport export_bids(StudyFile& study, const CodebookHead& head,
                         const std::filesystem::path& folder);

}  // namespace impetus::inline exports
