#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "client/exact_histories.h"
#include "client/history_stream.h"
#include "client/unit_labels.h"

namespace trajan::client {

/// What a picture says beside the histories themselves.
struct PictureNotes {
  UnitLabels units{""};
  std::vector<ExactHistory> exact;
};

/// What a job's scene and measures say about its histories. `job` has its scene.
PictureNotes picture_notes(const v1::Job& job);

/// The columns that the job's measures are about; all probes if there are none.
History select_measured(const History& history, const v1::Job& job);

/// Draws histories over time, one panel for each kind of quantity.
void draw_histories(const History& history, const PictureNotes& notes, const std::filesystem::path& picture);

/// Draws the amplitude spectra of histories over frequency.
void draw_spectra(const History& history, const PictureNotes& notes, const std::filesystem::path& picture);

}  // namespace trajan::client
