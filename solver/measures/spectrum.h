#pragma once

#include <span>

namespace trajan {

/// The frequency, in cycles per unit of time, of the highest peak of the windowed amplitude spectrum
/// between `lowest` and `highest`, with the mean removed and the peak interpolated between bins; 0 if the
/// values do not vary. If the spectrum has no peak in between, the end of the range at which it is higher.
///
/// Window: four-term Blackman-Harris (Harris, Proc. IEEE 66, 1978, table 1, -92 dB), so that what else is
/// in the signal matters only within four bins (4 / duration) of the peak. The signal should therefore
/// last four periods or more; with fewer the result is drawn towards the mirror image and the mean (3
/// periods: 3e-3 bins, 2 periods: 0.15 bins).
/// Precondition: at least 16 finite values, `interval` apart.
double dominant_frequency(std::span<const double> values, double interval, double lowest, double highest);

}  // namespace trajan
