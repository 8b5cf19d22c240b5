#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#if OVERTURN_MSEED
#include <libmseed.h>
#endif

#include "core/units.hpp"
#include "motion/detail/packed_files.hpp"
#include "motion/detail/record_readers.hpp"

namespace overturn {

bool recognises_miniseed(std::string_view content) { return is_miniseed(content); }

#if OVERTURN_MSEED

namespace {

constexpr double ticks_per_s = HPTMODULUS;
// Of a library whose own messages go to stderr: its return values report errors.
void say_nothing(char* /*text*/) {}

struct Free {
    void operator()(MSRecord* record) const { msr_free(&record); }
};
using SeedRecord = std::unique_ptr<MSRecord, Free>;

/// One channel, as far as it is read.
struct SeedChannel {
    std::string network_and_station, name;
    double rate_hz = 0;
    std::int64_t begin = 0;  ///< ticks
    bool counts = false;     ///< whole numbers
    std::vector<double> values;

    [[nodiscard]] double end_s() const { return static_cast<double>(values.size()) / rate_hz; }
};

class SeedReader {
  public:
    SeedReader(std::string_view content, RecordRequest const& request) : bytes_(content), request_(request) {
        ms_loginit(&say_nothing, nullptr, &say_nothing, nullptr);
    }

    std::vector<SeedChannel> read() && {
        for (std::size_t at = 0; at < bytes_.size();) {
            ++number_;
            auto const record = record_at(at);
            at += record->reclen;
            if (record->samplecnt > 0) {
                take(*record);
            }
        }
        return std::move(channels_);
    }

  private:
    [[noreturn]] void fail(std::string const& problem) const {
        throw InputError({request_.name}, fmt::format("record {} of the file: {}", number_, problem));
    }

    SeedRecord record_at(std::size_t at) {
        constexpr std::size_t longest = MAXRECLEN;
        buffer_.assign(bytes_.substr(at, longest));  // the library takes what it may write to
        MSRecord* made = nullptr;
        constexpr flag with_samples = 1;
        constexpr flag quiet = 0;
        auto const problem =
            msr_parse(buffer_.data(), static_cast<int>(buffer_.size()), &made, -1, with_samples, quiet);
        SeedRecord record(made);
        bool const whole = problem == MS_NOERROR && record != nullptr && record->reclen >= MINRECLEN
                           && static_cast<std::size_t>(record->reclen) <= buffer_.size();
        if (!whole) {
            fail(problem < 0 ? fmt::format("{} (the file is damaged). Fetch it anew", ms_errorstr(problem))
                             : std::string("ends too early (the file is cut short). Fetch it anew"));
        }
        return record;
    }

    void take(MSRecord const& record) {
        std::string const station = fmt::format("{}.{}.{}", record.network, record.station, record.location);
        if (!channels_.empty() && channels_.front().network_and_station != station) {
            fail(fmt::format("of {} behind {} (one station is one motion). Put each into a file of its own", station,
                             channels_.front().network_and_station));
        }
        if (!(record.samprate > 0)) {
            fail("no sample rate (it has one in every waveform). Fetch the file anew");
        }
        if (record.numsamples != record.samplecnt
            || (record.sampletype != 'i' && record.sampletype != 'f' && record.sampletype != 'd')) {
            fail("no whole block of numbers (text, or damaged). Fetch the file anew");
        }
        auto& channel = channel_of(record, station);
        double const gap_s = static_cast<double>(record.starttime - channel.begin) / ticks_per_s - channel.end_s();
        if (std::abs(gap_s) * channel.rate_hz > 0.5) {
            fail(fmt::format("{} goes on {:.6g} s {} (a gap, or an overlap). Take a record without one", channel.name,
                             std::abs(gap_s), gap_s > 0 ? "later" : "earlier"));
        }
        append(record, channel);
    }

    SeedChannel& channel_of(MSRecord const& record, std::string const& station) {
        auto const found = std::ranges::find(channels_, std::string(record.channel), &SeedChannel::name);
        bool const counts = record.sampletype == 'i';
        if (found == channels_.end()) {
            channels_.push_back({station, record.channel, record.samprate, record.starttime, counts, {}});
            return channels_.back();
        }
        constexpr double same = 1e-9;
        if (std::abs(found->rate_hz - record.samprate) > same * record.samprate || found->counts != counts) {
            fail(fmt::format("{} changes its rate or its kind of numbers. Take a record of one", found->name));
        }
        return *found;
    }

    static void append(MSRecord const& record, SeedChannel& channel) {
        auto const add = [&](auto const* samples) {
            channel.values.insert(channel.values.end(), samples, samples + record.numsamples);
        };
        if (record.sampletype == 'i') {
            add(static_cast<std::int32_t const*>(record.datasamples));
        } else if (record.sampletype == 'f') {
            add(static_cast<float const*>(record.datasamples));
        } else {
            add(static_cast<double const*>(record.datasamples));
        }
    }

    std::string_view bytes_;
    RecordRequest const& request_;
    std::string buffer_;
    std::vector<SeedChannel> channels_;
    int number_ = 0;
};

/// SEED's second letter is the instrument: N an accelerometer, G and L its older codes.
bool is_accelerometer(std::string_view channel) {
    return channel.size() > 1 && std::string_view("NLG").find(channel[1]) != std::string_view::npos;
}

/// Together they must be one motion. \throws InputError
void check_together(std::vector<SeedChannel> const& channels, RecordRequest const& request) {
    if (channels.empty()) {
        throw InputError({request.name}, "no samples in it (headers alone). Fetch the waveforms");
    }
    auto const& first = channels.front();
    for (auto const& channel : channels) {
        double const apart_s = static_cast<double>(channel.begin - first.begin) / ticks_per_s;
        if (channel.rate_hz != first.rate_hz || std::abs(apart_s) * first.rate_hz > 0.5) {
            throw InputError({request.name},
                             fmt::format("{} begins {:.6g} s from {}, at {:g} Hz and {:g} Hz (they must agree). Put "
                                         "them into files of their own",
                                         channel.name, apart_s, first.name, channel.rate_hz, first.rate_hz));
        }
        if (!is_accelerometer(channel.name)) {
            throw InputError(
                {request.name},
                fmt::format("channel {} (its second letter is none of N, L and G: no accelerometer's). Take "
                            "one of these of the same station, or convert it to columns of accelerations",
                            channel.name));
        }
    }
    bool const counts = std::ranges::any_of(channels, &SeedChannel::counts);
    if (!request.unit_mps2 || (counts && !request.unit_has_number)) {
        refuse_without_unit({request.name},
                            counts ? "counts of an instrument: no line says what one is; state it with a number, "
                                     "\"2.4e-6 m/s2\", from the station's response"
                                   : "miniSEED holds none",
                            request);
    }
    if (request.time_step_s) {
        check_stated_time_step(request, 1 / first.rate_hz, {request.name});
    }
}

}  // namespace

Recording read_miniseed(std::string_view content, RecordRequest const& request) {
    auto channels = SeedReader(content, request).read();
    check_together(channels, request);
    Recording recording{.time_step_s = 1 / channels.front().rate_hz, .components = {}};
    recording.unit_mps2 = *request.unit_mps2;
    for (auto& channel : channels) {
        for (double& value : channel.values) {
            if (!std::isfinite(value)) {
                throw InputError({request.name},
                                 fmt::format("{} holds a number that is none. Fetch the file anew", channel.name));
            }
            value *= recording.unit_mps2;
        }
        recording.components.push_back({channel.name, direction_of(channel.name), std::move(channel.values)});
    }
    return recording;
}

#else

Recording read_miniseed(std::string_view /*content*/, RecordRequest const& request) {
    throw InputError({request.name},
                     "miniSEED (this program was built without libmseed). Convert it to columns time,a_horizontal in "
                     "m/s2, for example with ObsPy after its remove_response(output=\"ACC\")");
}

#endif

}  // namespace overturn
