/// The readers behind record_formats(), one source file each, and the checks that they share.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/error.hpp"
#include "motion/record.hpp"

namespace overturn {

/// PEER strong-motion AT2: a header with NPTS and DT in its first ten lines, then accelerations in g.
[[nodiscard]] bool recognises_peer_at2(std::string_view content);
[[nodiscard]] Recording read_peer_at2(std::string_view content, RecordRequest const& request);
[[nodiscard]] std::string station_of_peer_at2(std::string_view head);

/// K-NET and KiK-net ASCII (NIED): 17 header lines, then counts; the mean is removed.
[[nodiscard]] bool recognises_knet(std::string_view content);
[[nodiscard]] Recording read_knet(std::string_view content, RecordRequest const& request);
[[nodiscard]] std::string station_of_knet(std::string_view head);

/// JMA csv: NS,EW,UD in gal, 7 header lines. The format states no count, so a file cut at a line's end looks whole.
[[nodiscard]] bool recognises_jma_csv(std::string_view content);
[[nodiscard]] Recording read_jma_csv(std::string_view content, RecordRequest const& request);

/// COSMOS v1.20 strong-motion data format (2001): acceleration blocks of every channel, velocity and displacement left.
[[nodiscard]] bool recognises_cosmos(std::string_view content);
[[nodiscard]] Recording read_cosmos(std::string_view content, RecordRequest const& request);
[[nodiscard]] std::string station_of_cosmos(std::string_view head);

/// CSMIP/CDMG V2: corrected acceleration of every channel, velocity and displacement left.
[[nodiscard]] bool recognises_csmip_v2(std::string_view content);
[[nodiscard]] Recording read_csmip_v2(std::string_view content, RecordRequest const& request);

/// ESM and ITACA DYNA 1.x: one component, its count and peak checked against the header.
[[nodiscard]] bool recognises_esm_dyna(std::string_view content);
[[nodiscard]] Recording read_esm_dyna(std::string_view content, RecordRequest const& request);
[[nodiscard]] std::string station_of_esm_dyna(std::string_view head);

/// ITACA .acc: what none of the header's keys says must be stated by the user.
[[nodiscard]] bool recognises_itaca_acc(std::string_view content);
[[nodiscard]] Recording read_itaca_acc(std::string_view content, RecordRequest const& request);

/// GeoNet V1A and V2A (GNS Science, New Zealand): components in mm/s2, velocity and displacement left.
[[nodiscard]] bool recognises_geonet(std::string_view content);
[[nodiscard]] Recording read_geonet(std::string_view content, RecordRequest const& request);

/// Volume 1 of BHRC (Iran) and RENADIC (Chile): uncorrected, in G/10.
[[nodiscard]] bool recognises_vol1(std::string_view content);
[[nodiscard]] Recording read_vol1(std::string_view content, RecordRequest const& request);

/// ASA 2.0 (UNAM, Mexico): lines KEY : value, then a column in gal for each channel.
[[nodiscard]] bool recognises_asa2(std::string_view content);
[[nodiscard]] Recording read_asa2(std::string_view content, RecordRequest const& request);

/// BRI .ac (Building Research Institute, Japan): channels in gal, each with its peak, which is checked.
[[nodiscard]] bool recognises_bri_ac(std::string_view content);
[[nodiscard]] Recording read_bri_ac(std::string_view content, RecordRequest const& request);

/// Known formats without a reader: never returns. \throws InputError with what to do instead
[[nodiscard]] bool recognises_unread(std::string_view content);
[[nodiscard]] Recording refuse_unread(std::string_view content, RecordRequest const& request);

/// Tables of columns and lists of values, by what their names and text state; see table_columns.hpp.
[[nodiscard]] bool recognises_columns(std::string_view content);
[[nodiscard]] Recording read_columns(std::string_view content, RecordRequest const& request);

/// A table of the described format.
[[nodiscard]] bool has_marks(std::string_view content, TableFormat const& format);
[[nodiscard]] Recording read_described(std::string_view content, RecordRequest const& request,
                                       TableFormat const& format);
extern TableFormat const nsmn_table, csmnc_table, bbp_table;

/// miniSEED 2, by libmseed: counts or numbers of one station's channels, without their unit. Where the program is built
/// without that library it is refused by name.
[[nodiscard]] bool recognises_miniseed(std::string_view content);
[[nodiscard]] Recording read_miniseed(std::string_view content, RecordRequest const& request);

/// EarthScope (IRIS) ASCII, SLIST and TSPAIR: such a table of one series, whose channel its first line names.
[[nodiscard]] bool recognises_earthscope(std::string_view content);
[[nodiscard]] Recording read_earthscope(std::string_view content, RecordRequest const& request);

/// The same without a time, whatever the first column looks like; only where its name is stated.
[[nodiscard]] bool recognises_components(std::string_view content);
[[nodiscard]] Recording read_components(std::string_view content, RecordRequest const& request);

/// Values in reading order, any number to a line; only where its name is stated.
[[nodiscard]] bool recognises_list(std::string_view content);
[[nodiscard]] Recording read_list(std::string_view content, RecordRequest const& request);

/// SMC (USGS, Converse and Brady 1992): text, integer and real headers, comments, then accelerations in cm/s2.
[[nodiscard]] bool recognises_smc(std::string_view content);
[[nodiscard]] Recording read_smc(std::string_view content, RecordRequest const& request);
[[nodiscard]] std::string station_of_smc(std::string_view head);

/// CWA (Taiwan): lines `#Key: value`, then columns of time and components in gal in the order that the header states.
[[nodiscard]] bool recognises_cwa(std::string_view content);
[[nodiscard]] Recording read_cwa(std::string_view content, RecordRequest const& request);

/// Never returns. \throws InputError that asks for the unit under the name that its user writes.
[[noreturn]] void refuse_without_unit(Location const& where, std::string_view why, RecordRequest const& request);

/// \throws InputError if the user stated a unit other than the file's own.
void check_stated_unit(RecordRequest const& request, double file_unit_mps2, Location const& where);

/// \throws InputError if the user stated a time step that differs from the file's own by more than printed rounding.
void check_stated_time_step(RecordRequest const& request, double file_time_step_s, Location const& where);

/// \throws InputError unless a component's peak is the one that the file's header states, within `tolerance_mps2`.
void check_stated_peak(double peak_mps2, double stated_mps2, double tolerance_mps2, Location const& where);

/// For formats whose values all have the same decimals. \throws InputError if the content ends without a line end in a
/// value that has fewer of them than the one before: a file cut within its last number.
void check_last_value_is_whole(std::string_view content, Location const& where);

/// \throws InputError if the peak is beyond anything the ground has done: a wrong unit.
void check_believable_peak(std::span<double const> acceleration_mps2, Location const& where);

}  // namespace overturn
