#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/ranges.h>
#include <unistd.h>

#include "campaign/campaign_input.hpp"
#include "campaign/campaign_spec.hpp"
#include "campaign/plan.hpp"
#include "campaign/study_answers.hpp"
#include "campaign/study_text.hpp"
#include "campaign/warnings.hpp"
#include "cli/scene_files.hpp"
#include "cli/verbs.hpp"
#include "config/suggestion.hpp"
#include "core/error.hpp"
#include "core/input_files.hpp"
#include "core/print_note.hpp"
#include "motion/record.hpp"
#include "results/hazard_table.hpp"
#include "spectra/named_targets.hpp"
#include "store/durable.hpp"

namespace overturn::cli {
namespace {

namespace fs = std::filesystem;

struct NewOptions {
    std::string file;
    StudyAnswers answers;
    bool force = false;
};

void check_place(NewOptions const& options) {
    fs::path const path(options.file);
    validate(std::ranges::none_of(options.file, [](unsigned char c) { return c < ' '; }),
             "new: the name has a control character (the name is written into the file). Use for example study.toml");
    validate(path.extension() == ".toml",
             "{}: not the name of a campaign (must end in .toml). Use for example study.toml", options.file);
    validate(options.force || !fs::exists(path), "{}: exists already (it would be lost). Use another name, or --force",
             options.file);
    validate(!fs::is_directory(path), "{}: a folder (a file cannot have its name). Use another name", options.file);
    auto const folder = path.parent_path();
    validate(folder.empty() || fs::is_directory(folder), "{}: no folder {} (it must exist). Make it, or name another",
             options.file, folder.string());
    store::require_writable(path);
}

// The place of the question that an empty answer leads back to: of records that about the spectrum, as waves come from
// one of the two. Empty: there is none.
std::optional<std::size_t> way_back(StudyQuestion const& question) {
    auto const questions = study_questions();
    auto const spectrum = std::ranges::find(questions, &StudyAnswers::spectrum, &StudyQuestion::answer);
    return question.answer == &StudyAnswers::records ? std::optional<std::size_t>(spectrum - questions.begin())
                                                     : std::nullopt;
}

std::string published_targets() {
    auto names = config::names_of(named_targets());
    std::erase(names, "rg-1.60-vertical");  // which rg-1.60 brings along
    return config::joined(names);
}

// A person at a terminal, asked for what is missing until input ends or answers are in vain too often in a row.
class Interview {
  public:
    void ask_what_is_missing(StudyAnswers& answers) {
        auto const questions = study_questions();
        for (std::size_t place = 0; place < questions.size() && !over();) {
            auto const& question = questions[place];
            auto& answer = answers.*question.answer;
            bool const asked = !answer && question.applies(answers);
            if (asked) {
                answer = ask(question);
            }
            auto const back = asked && !answer && !over() ? way_back(question) : std::nullopt;
            if (back) {
                vain("one of the two is required. Published spectra: " + published_targets());
            }
            place = back.value_or(place + 1);
        }
    }
    /// Were answers in vain too often?
    [[nodiscard]] bool gave_up() const { return in_vain_ >= most_in_vain; }

  private:
    static constexpr int most_in_vain = 5;

    [[nodiscard]] bool over() const { return !std::cin || gave_up(); }
    void vain(std::string const& why) {
        ++in_vain_;
        print_note("  {}\n", why);
    }

    // Empty: none was given.
    std::optional<std::string> ask(StudyQuestion const& question) {
        bool const may_be_empty = !question.must || way_back(question);
        while (!over()) {
            print_note("{} ({}){}: ", question.words, question.example,
                       !question.must ? ", or Enter"
                       : may_be_empty ? ", or Enter to state a target spectrum"
                                      : "");
            std::string line;
            if (!std::getline(std::cin, line)) {
                return std::nullopt;
            }
            auto answer = std::string(trimmed(line));
            if (answer.size() > 1 && answer.front() == '\'' && answer.back() == '\'') {
                answer = answer.substr(1, answer.size() - 2);  // as the example has it
            }
            if (answer.empty() && may_be_empty) {
                return std::nullopt;
            }
            try {
                validate(!answer.empty(), "a value is required: none can be assumed");
                check_answer(question, answer);
                in_vain_ = 0;
                return answer;
            } catch (InputError const& error) {
                vain(error.what());
            }
        }
        return std::nullopt;
    }

    int in_vain_ = 0;  // in a row
};

// What to do about missing answers, with those that were given.
std::string way_on(NewOptions const& options, StudyAnswers const& answers, char const* them) {
    return fmt::format("Add {} to: {}{}", them, study_command(options.file, answers), options.force ? " --force" : "");
}

void require_all(NewOptions const& options, StudyAnswers const& answers, bool at_terminal) {
    auto const missing = missing_answers(answers);
    auto const* const them = missing.size() == 1 ? "it" : "them";
    validate(missing.empty(), "new: {} missing (required: no value can be assumed). {}", config::joined(missing),
             at_terminal ? way_on(options, answers, them) : fmt::format("Give {}, or answer at a terminal", them));
}

StudyAnswers complete_answers(NewOptions const& options) {
    auto answers = options.answers;
    check_answers(answers);
    bool const at_terminal = isatty(STDIN_FILENO) != 0;
    Interview interview;
    if (at_terminal) {
        interview.ask_what_is_missing(answers);
    }
    require_all(options, answers, at_terminal);
    validate(!interview.gave_up(), "new: no answer that can be used (asked too often). {}",
             way_on(options, answers, "the rest"));
    check_answers(answers);
    return answers;
}

// The name that a campaign in `folder` calls a file by.
std::string as_seen_from(fs::path const& folder, std::string const& file) {
    return folder.empty() || fs::path(file).is_absolute()
               ? file
               : fs::proximate(fs::absolute(file), fs::absolute(folder)).generic_string();
}

// What people keep in it, in the order of names.
std::vector<std::string> files_in(std::string const& folder) {
    std::vector<std::string> names;
    for (auto const& entry : fs::directory_iterator(folder)) {
        if (auto name = entry.path().filename().string(); entry.is_regular_file() && name.front() != '.') {
            names.push_back(std::move(name));
        }
    }
    validate(!names.empty(), "--records '{}' (a folder without files). Name the folder with the records", folder);
    std::ranges::sort(names);
    return names;
}

// A folder of single components, by station and event.
struct Stations {
    std::vector<std::string> found;  // of each the first horizontal one, which the others join
    std::vector<std::string> in_borehole;
    std::vector<std::string> vertical;
    std::string apart;  // why one of them is no such station; empty: all are
};

Stations stations_in(fs::path const& folder, std::vector<std::string> const& names) {
    Stations stations;
    InputFiles files(folder);
    std::map<std::string, std::vector<std::string>> of_station;
    for (auto const& name : names) {
        auto station = station_of_record(files.read(name));
        if (station.ends_with(in_borehole_mark)) {
            stations.in_borehole.push_back(name);
        }
        of_station[std::move(station)].push_back(name);
    }
    for (auto const& [station, components] : of_station) {
        std::string first;
        for (auto const& name : components) {
            auto const recording = read_recording(files.read(name), {.name = name});
            auto const direction =
                recording.components.size() == 1 ? recording.components.front().direction : Direction::unknown;
            first = first.empty() && direction == Direction::horizontal ? name : first;
            if (is_vertical(direction)) {
                stations.vertical.push_back(name);
            }
        }
        if (!station.empty() && components.size() > 1 && !first.empty()) {
            stations.found.push_back(first);
        } else if (stations.apart.empty()) {
            stations.apart = fmt::format("{}: {}", fmt::join(components, ", "),
                                         station.empty() ? "no station stated"
                                         : first.empty() ? "no horizontal component of its station"
                                                         : "no other component of its station");
        }
    }
    return stations;
}

// Where each file is one component of a station and event: of each of these the first horizontal one. Empty where a
// file states no station, or stands alone, and none is vertical: each is then a record.
std::vector<std::string> one_of_each_station(fs::path const& folder, std::vector<std::string> const& names) {
    Stations stations;
    try {
        stations = stations_in(folder, names);
    } catch (InputError const&) {  // said when the campaign is read
        return {};
    }
    validate(stations.in_borehole.empty(),
             "--records '{}' ({}: recorded in a borehole, not at the surface). Move them into another folder",
             folder.string(), fmt::join(stations.in_borehole, ", "));
    validate(
        stations.apart.empty() || stations.vertical.empty(),
        "--records '{}' ({}; beside vertical components, which join others of their station). Complete it, or move "
        "it into another folder",
        folder.string(), stations.apart);
    return stations.apart.empty() ? stations.found : std::vector<std::string>();
}

// Files are named from the folder of the campaign.
StudyAnswers located(StudyAnswers answers, fs::path const& folder) {
    if (answers.has_spectrum_file()) {
        answers.spectrum = as_seen_from(folder, *answers.spectrum);
    }
    if (answers.records) {
        answers.record_files =
            fs::is_directory(*answers.records) ? files_in(*answers.records) : std::vector<std::string>();
        if (auto stations = one_of_each_station(*answers.records, answers.record_files); !stations.empty()) {
            answers.records_of_stations = true;
            answers.record_files = std::move(stations);
        }
        answers.records = as_seen_from(folder, *answers.records);
    }
    if (answers.hazard) {
        answers.hazard = as_seen_from(folder, *answers.hazard);
    }
    return answers;
}

// Where the refusal of a record asks for its unit by the campaign's key: by the option that states it.
std::string by_option(std::string text, StudyAnswers const& answers) {
    constexpr std::string_view key = "State unit = ";
    auto const at = answers.records ? text.find(key) : std::string::npos;
    return at == std::string::npos ? text : text.replace(at, key.size(), "State --record-unit ");
}

int write_study(NewOptions const& options) {
    check_place(options);
    auto const answers = complete_answers(options);
    fs::path const path(options.file);
    auto const folder = path.parent_path();
    CampaignInput input{.name = options.file,
                        .text = study_text(path.filename().string(), located(answers, folder)),
                        .settings = {},
                        .files = {}};
    try {
        load_files(input, folder.empty() ? fs::path(".") : folder);
    } catch (InputError const& error) {
        throw InputError(fmt::format("new: nothing was written, because overturn plan refuses the campaign: {}",
                                     by_option(error.what(), answers)));
    }
    auto const spec = parse_campaign(input);
    (void)stated_hazard(input, spec.levels);
    auto const bytes = std::as_bytes(std::span(input.text));
    if (options.force) {
        store::write_durably(path, bytes);
    } else {
        validate(store::create_durably(path, bytes),
                 "{}: exists already (it would be lost). Use another name, or --force", options.file);
    }
    note_warnings(warnings_of(spec));
    print_note("{}: {} trials. Assumed values are marked \"assumed\". Next: overturn plan {}\n", options.file,
               Plan(spec).without_refusals().trials(), options.file);
    return done;
}

}  // namespace

void add_new(CommandLine& line) {
    auto verb = line.verb("new", "write a campaign file for your own cask; asks for missing values");
    auto options = std::make_shared<NewOptions>();
    verb.needs("file", options->file, "campaign file to write, NAME.toml");
    for (auto const& question : study_questions()) {
        verb.takes(question.option, options->answers.*question.answer, question.words, question.example);
    }
    verb.takes("--force", options->force, "overwrite an existing file");
    verb.does([options] { return write_study(*options); });
}

}  // namespace overturn::cli
