#include "campaign/results.hpp"

namespace overturn {

CampaignInput input_of(store::ResultsReader const& file) {
    CampaignInput input{file.text("campaign_name"), file.text("campaign"), {}, {}};
    auto const settings = file.text("settings");
    for (std::size_t begin = 0; begin < settings.size();) {
        auto const end = std::min(settings.find('\n', begin), settings.size());
        input.settings.push_back(settings.substr(begin, end - begin));
        begin = end + 1;
    }
    for (auto const& place : file.members("inputs")) {
        input.files.emplace(file.note("inputs/" + place, "description"), file.content("inputs/" + place));
    }
    return input;
}

Statistics recount(store::ResultsReader const& file, CampaignSpec const& spec) {
    Statistics statistics(spec);
    auto const failed = file.integers("waves/failed");
    auto const accepted = file.integers("waves/accepted");
    auto const id = file.integers("waves/id");
    auto const pga = file.reals("waves/pga");
    auto const pgv = file.reals("waves/pgv");
    for (std::size_t i = 0; i < failed.size(); ++i) {
        WaveRow row;
        row.id = id[i];
        row.pga_mps2 = pga[i];
        row.pgv_mps = pgv[i];
        row.failed = failed[i];
        row.accepted = accepted[i];
        statistics.add(row);
    }
    auto const wave = file.integers("trials/wave");
    auto const amplitude = file.reals("trials/amplitude");
    auto const scale = file.reals("trials/scale");
    auto const v_wes = file.reals("trials/v_wes");
    auto const ou_v_e = file.reals("trials/ou_v_e");
    auto const v_ereq = file.reals("trials/v_ereq");
    auto const body = file.integers("trials/body");
    auto const level = file.integers("trials/level");
    auto const verdict = file.integers("trials/verdict");
    auto const v_wes_safe = file.integers("trials/v_wes_safe");
    auto const ou_v_e_safe = file.integers("trials/ou_v_e_safe");
    auto const called = file.integers("trials/effects_called");
    auto const rung = file.integers("trials/rung");
    for (std::size_t i = 0; i < body.size(); ++i) {
        TrialRow row;
        row.wave = wave[i];
        row.amplitude = amplitude[i];
        row.scale = scale[i];
        row.v_wes_mps = v_wes[i];
        row.ou_v_e_mps = ou_v_e[i];
        row.v_ereq_mps = v_ereq[i];
        row.body = body[i];
        row.level = level[i];
        row.verdict = verdict[i];
        row.v_wes_safe = v_wes_safe[i];
        row.ou_v_e_safe = ou_v_e_safe[i];
        row.effects_called = called[i];
        row.rung = rung[i];
        statistics.add(row);
    }
    return statistics;
}

}  // namespace overturn
