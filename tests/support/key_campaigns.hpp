/// Campaigns that between them state every key there is.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace overturn::testing {

/// The files that they name.
inline std::map<std::string, std::string> key_campaign_files() {
    return {{"sa.csv", "0.1,3\n1,3\n10,1\n"},
            {"sa.json", R"({"a": {"periods": [0.1, 10], "ordinates": [0.3, 0.1]}, "b": {"periods": [0.1, 10],
                         "ordinates": [0.2, 0.1]}})"},
            {"psd.csv", "0.1,1\n10,1\n"},
            {"hazard.csv", "pga [g], annual_exceedance\n0.05,1e-2\n2,1e-6\n"},
            {"r/a.csv", "0,0\n0.01,10\n0.02,-20\n0.03,0\n0.04,4\n0.05,-3\n"},
            {"r/b.csv", "0,0\n0.01,1\n0.02,2\n0.03,0\n0.04,1\n0.05,0\n"},
            {"body.toml",
             "name='b'\nmass='10 t'\nbase_width=1.4\ncentre_height=1.0\ninertia='20 t m2'\ngravity=9.8\n"
             "restitution=0.8\nsimilarity={direction='to-model', length=0.5, mass_factor=1.4}\n"}};
}

/// Campaigns that state every key between them, each beside what it needs.
inline std::vector<std::string> key_campaigns() {
    constexpr auto levels = "[levels]\nmeasure='pga'\nvalues=['300 gal']\n";
    constexpr auto body = "[[bodies]]\nmass='10 t'\nbase_width=1.4\ncentre_height=1.0\ninertia='uniform-block'\n";
    constexpr auto drawn = "[waves]\nsource='spectrum-compatible'\ncount=2\nduration='20 s'\nmatch='none'\n";
    constexpr auto target = "[waves.target]\nspectrum='mlit-ch1'\n";
    constexpr auto harmonic = "[waves]\nsource='harmonic'\namplitude='100 gal'\n";
    std::string const usual = std::string(levels) + body;
    std::string const noise = "[waves]\nsource='filtered-noise'\ncount=2\nrms='50 gal'\nduration='20 s'\n";
    auto const enveloped = [&](std::string const& keys) {
        return noise + "model='kanai-tajimi'\n[waves.envelope]\n" + keys;
    };
    std::string const matched =
        "[waves]\nsource='spectrum-compatible'\ncount=2\nduration='20 s'\n" + std::string(target);
    std::string const steady = std::string(harmonic) + "period=1\ncycles=5\n";
    std::vector<std::string> waves{
        std::string(drawn) + "amplitudes='fixed'\n[waves.target]\nspectrum='rg-1.60'\npga='300 gal'\ndamping=0.03\n"
        "stated_damping=0.05\ndamping_rule='japan'\nscale=1.1\ntime_scale=0.9\nlongest='5 s'\n"
        "[waves.transverse]\nratio=0.9\ncorrelation=0.1\n[waves.vertical.target]\nspectrum='mlit-ch1'\n"
        "[waves.aftershock]\npause=2\nscale=0.5\n[waves.envelope]\nshape='jennings'\nrise=2\nlevel_end=8\nend=15\n",
        std::string(drawn) + "[waves.target]\nkind='acceleration'\nunit='gal'\nfile='sa.csv'\n",
        std::string(drawn) + "[waves.target]\nkind='acceleration'\nunit='g'\nfile='sa.json'\npart='b'\n",
        std::string(drawn) + "[waves.target]\nkind='acceleration'\npoints=[[0.1,3],[10,1]]\n",
        "[waves]\nsource='spectrum-compatible'\ncount=2\nduration='20 s'\ntime_step=0.02\nmatch='each'\n"
        "match_tolerance=0.3\nmatch_iterations=3\nacceptance='none'\n" + std::string(target)
            + "[waves.variability]\nsigma=0.5\ncorrelation='full'\nper_target=2\nconditional={period=1, epsilon=0.5}\n",
        matched + "[waves.variability]\nbetween=0.3\nwithin=0.4\ncorrelation='none'\ntargets_per_event=2\n",
        matched + "[waves.variability]\nsigma=0.5\ncorrelation='full'\nconditional={period='1 s', sa='5 m/s2'}\n",
        "[waves]\nsource='spectrum-compatible'\ncount=1\n" + std::string(target)
            + "[waves.seed]\nfolder='r'\nfiles=['a.csv']\nunit='gal'\n",
        enveloped("shape='saragoni-hart'\npeak=4\ngamma=2\n"),
        enveloped("shape='noda-2002'\nmagnitude=5\ndistance='10 km'\n"),
        enveloped("shape='points'\npoints=[[0,0],[5,1],[20,0]]\n"),
        noise + "model='clough-penzien'\namplitudes='gaussian'\ntime_step=0.01\nground_frequency=2\nground_damping=0.5\n"
            "filter_frequency=0.2\nfilter_damping=0.5\ntransverse={ratio=1, correlation=0}\nvertical={ratio=0.5}\n",
        noise + "model='points'\n[waves.density]\npoints=[[0.1,1],[10,1]]\n",
        noise + "model='points'\n[waves.density]\nfile='psd.csv'\n",
        std::string(harmonic) + "frequency=1\ncycles=5\nramp=1\ntime_step=0.01\ntransverse={ratio=1, phase='90 deg'}\n",
        std::string(harmonic) + "frequencies=[1,2]\nduration=5\nvertical={ratio=0.5}\n",
        std::string(harmonic) + "periods=[1,2]\ncycles=5\n",
        "[waves]\nsource='pulse'\nshape='ricker'\namplitude=3\nperiod=1\ntime_step=0.01\nquiet_before=1\nquiet_after=1\n"
        "transverse={ratio=1, lag=0.1}\nvertical={ratio=0.5}\n",
        "[waves]\nsource='pulse'\nshape='one-sine'\namplitude=3\nperiods=[1,2]\n",
        "[waves]\nsource='pulse'\nshape='mavroeidis-papageorgiou'\ngamma=2\nphase='90 deg'\namplitude=3\nperiod=1\n",
        "[waves]\nsource='records'\nfolder='r'\nfiles=['a.csv','b.csv']\ncount=1\nformat='auto'\nunit='gal'\n"
        "time_step=0.005\ncolumns='time,h1'\ncomponent=''\ncomponents='file'\nresample='finer'\naxes='as-recorded'\nscale=2\n"
        "time_scale=0.5\nbaseline='mean'\n",
        "[waves]\nsource='records'\nfolder='r'\n[[waves.records]]\nhorizontal='a.csv'\ntransverse='b.csv'\n"
        "vertical='b.csv'\nunit='gal'\nbaseline={high_pass='22 Hz', order=2, phase='causal'}\n"};
    std::vector<std::string> all;
    for (auto const& one : waves) {
        all.push_back("seed=1\n" + one + usual);
    }
    auto const standing = [&](std::string const& bodies) { all.push_back("seed=1\n" + steady + levels + bodies); };
    standing(
        "[[bodies]]\nfile='body.toml'\nname='other'\naxes=1\noffset='1 cm'\nslope='0.1 deg'\ninitial_tilt='0.1 deg'\n");
    standing(
        "[[bodies]]\nbase_width=1.4\n[[bodies.parts]]\nkind='cylinder'\nmass=1000\ndiameter=1\nheight=2\nbottom=0.1\n"
        "[[bodies.parts]]\nkind='box'\nmass=1000\nwidth=1\nheight=0.1\nfastened=true\nfriction=0.4\n");
    standing(
        "[[bodies]]\nmass={distribution='normal', mean='10 t', deviation='1 t', low='8 t', high='12 t'}\n"
        "base_width=1.4\ncentre_height={distribution='uniform', low=0.9, high=1.1}\ninertia='uniform-block'\n"
        "restitution={distribution='fixed', value=0.8}\n"
        "friction={static={distribution='lognormal', median=0.5, beta=0.1}, kinetic_ratio=0.9}\n"
        "[scatter]\nsampling='latin-hypercube'\n");
    standing(std::string(body) + "inertia_y='20 t m2'\ninertia_z='20 t m2'\nfriction={static=0.5, kinetic=0.4}\n"
             "base={shape='square', bedding='flat', points=9}\npad={vertical_frequency='98 Hz', normal_restitution=0.3, "
             "strength='30 MPa', tangential_ratio=0.8, tangential_damping=0.3, match_restitution=false}\n");
    standing(std::string(body) + "base={shape='round', bedding='flat', inner_diameter=1}\n");
    standing(std::string(body)
             + "friction=0.5\nbase={shape='polygon', corners=[[-0.7,-0.7],[0.7,-0.7],[0.7,0.7],[-0.7,0.7]]}\n");
    all.push_back("seed=1\n" + steady + body
                  + "[levels]\nmeasure='sa'\nperiod=1\nwaves='shared'\nvalues={from=1, to=4, count=3, spacing='log'}\n"
                    "design_basis=2\nbeyond_design=[5]\n[measures]\nradius_unit='m'\nenergy=true\nwave_quality=true\n"
                    "both_radius_units=true\nwindow='running'\nsa_periods=[1.0,2.0]\nsa_band=[1,2]\ncurves=['cav']\n[accuracy]\n"
                    "restoring='nonlinear'\n"
                    "contact_step=0.3\npanel_phase=10\n");
    all.push_back("title='t'\nquestion='q?'\nprepared='p'\nchecked='c'\napproved='a'\nrevision='0'\nhazard='hazard.csv'\ninputs='stored'\nseed=1\n" + noise + "model='kanai-tajimi'\n" + usual
                  + "friction=0.5\n[effects]\nmode='auto'\n[statistics]\nconfidence=0.9\nbeta_u=0.3\ntarget_half_width=0.1\n"
                    "target_median_half_width=0.1\n[[limits]]\nname='a'\nquantity='peak_slip'\nabove='0.1 m'\n"
                    "overturned='excluded'\ntarget_half_width=0.2\n[[limits]]\nname='b'\nquantity='peak_slip'\nbelow='0.1 m'\n"
                    "[[limits]]\nname='c'\nany=['a','overturning']\n[[limits]]\nname='d'\nall=['a','b']\n");
    all.push_back("seed=1\n" + steady + usual
                  + "friction=0.5\n[site]\ncask='1 m'\ncask_body='body'\nwall={plus_x=1, minus_x=2, plus_y=3, minus_y=4}\n"
                    "edge={plus_x=5}\nheight=2\nwidth=3\n");
    all.push_back("seed=1\n" + noise + "model='kanai-tajimi'\n" + body + "friction=0.5\n[effects]\ninclude=['sliding']\n"
                  "[levels]\nmeasure='factor'\nvalues=[1]\n[rare]\nmethod='auto'\ntarget_cov=0.2\nreplicates=8\n"
                  "max_runs=50000\n");
    return all;
}

}  // namespace overturn::testing
