#include "generators/records.hpp"

#include <algorithm>
#include <vector>

#include "motion/record.hpp"

namespace overturn {
namespace {

struct Record {
    GroundMotion motion;
    std::string label;
};

class Records : public WaveSource {
  public:
    explicit Records(std::vector<Record> records) : records_(std::move(records)) {}

    [[nodiscard]] GeneratedWave make(std::uint64_t /*seed*/, std::uint64_t wave) const override {
        validate_wave(wave, records_.size());
        GeneratedWave made;
        made.motion = records_[wave].motion;
        made.label = records_[wave].label;
        return made;
    }

    [[nodiscard]] std::optional<std::uint64_t> available() const override { return records_.size(); }

    [[nodiscard]] std::string describe() const override {
        return fmt::format("{} record{}, the first {}", records_.size(), records_.size() == 1 ? "" : "s",
                           records_.front().label);
    }

  private:
    std::vector<Record> records_;
};

// What a table says about its files besides their names.
RecordRequest read_request(config::Table const& table) {
    RecordRequest request;
    request.format = table.text("format", "auto");
    if (table.has("unit")) {
        auto const unit = table.text("unit");
        request.unit_mps2 = table.located("unit", [&] { return unit_factor(unit, Dimension::acceleration); });
    }
    request.time_step_s = table.maybe_number("time_step", Dimension::time, config::Range::positive());
    return request;
}

GroundMotion read_motion(config::Table const& table, std::string_view key, std::string const& name,
                         RecordRequest request, InputFiles& files) {
    request.name = name;
    return table.located(key, [&] {
        auto motion = read_record(files.read(name), request);
        validate_motion(motion);
        return motion;
    });
}

void add_component(config::Table const& table, std::string_view key, RecordRequest const& request, InputFiles& files,
                   GroundMotion& motion, std::vector<double> GroundMotion::*place) {
    if (!table.has(key)) {
        return;
    }
    auto component = read_motion(table, key, table.text(key), request, files);
    if (component.time_step_s != motion.time_step_s) {
        table.fail(key,
                   fmt::format("time step {} s beside {} s of the horizontal component (they must agree). Resample one",
                               component.time_step_s, motion.time_step_s));
    }
    if (!(motion.*place).empty()) {
        table.fail(key, "a second file for a component that the first one holds already. Remove this key");
    }
    motion.*place = std::move(component.horizontal_mps2);
}

// Cuts all components to the shortest; true if that took anything away.
bool cut_to_shortest(GroundMotion& motion) {
    auto shortest = motion.samples();
    bool cut = false;
    for (auto const* component : {&motion.transverse_mps2, &motion.vertical_mps2}) {
        cut = cut || (!component->empty() && component->size() != shortest);
        shortest = component->empty() ? shortest : std::min(shortest, component->size());
    }
    for (auto* component : {&motion.horizontal_mps2, &motion.transverse_mps2, &motion.vertical_mps2}) {
        component->resize(std::min(component->size(), shortest));
    }
    return cut;
}

Record read_table(config::Table const& table, InputFiles& files) {
    auto const request = read_request(table);
    Record record;
    record.label = table.text("horizontal");
    record.motion = read_motion(table, "horizontal", record.label, request, files);
    add_component(table, "transverse", request, files, record.motion, &GroundMotion::transverse_mps2);
    add_component(table, "vertical", request, files, record.motion, &GroundMotion::vertical_mps2);
    if (cut_to_shortest(record.motion)) {
        record.label += fmt::format(" (components cut to {} samples)", record.motion.samples());
    }
    table.finish();
    return record;
}

}  // namespace

std::unique_ptr<WaveSource> make_records(config::Table const& waves, InputFiles& files) {
    if (waves.has("files") == waves.has("records")) {
        waves.fail({}, "no single list of records (state either files or records)");
    }
    std::vector<Record> records;
    if (waves.has("files")) {
        auto const request = read_request(waves);
        for (auto const& name : waves.texts("files")) {
            records.push_back({read_motion(waves, "files", name, request, files), name});
        }
    } else {
        for (auto const& table : waves.children("records")) {
            records.push_back(read_table(table, files));
        }
    }
    if (records.empty()) {
        waves.fail(waves.has("files") ? "files" : "records", "no record (the list is empty). Name at least one file");
    }
    return std::make_unique<Records>(std::move(records));
}

}  // namespace overturn
