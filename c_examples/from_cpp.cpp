// The library from C++17: a gripper closes around pegs of different width.
//
// The program learns how wide to open it, and draws openings for pegs that it has
// not seen: from the region that was learned, and from one written by hand. Errors
// are exceptions.
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "critreg.hpp"

static const char DOMAIN[] =
    "object peg { width: length }\n"
    "constant finger.gap  = 0.01: length   # wanted on both sides together\n"
    "constant gripper.max = 0.10: length\n"
    "parameter opening in [0, gripper.max]\n";

// Pegs of 2, 3, 5 and 8 centimetres.
static const std::vector<double> pegs = {0.02, 0.03, 0.05, 0.08};

static critreg_outcome close_gripper(const double *instance, const double *theta) {
    const double width = instance[0], opening = theta[0];
    return opening >= width + 0.01 ? CRITREG_FEASIBLE : CRITREG_INFEASIBLE;
}

static critreg::Region learn_openings() {
    critreg_config config = critreg::Learner::default_config();
    config.iterations = 40;
    critreg::Learner learner(DOMAIN, config);

    // An exception of the simulator comes through, and learning can go on.
    int calls = 0;
    try {
        learner.learn(pegs, [&](const double *instance, const double *theta) {
            if (++calls == 5) throw std::runtime_error("the gripper is stuck");
            return close_gripper(instance, theta);
        });
    } catch (const std::runtime_error &stuck) {
        std::printf("stopped after %d calls: %s\n", calls, stuck.what());
    }
    critreg::Region region = learner.learn(pegs, close_gripper);
    const critreg_report report = learner.report();
    std::printf("samples: %llu, feasible: %llu; at least %.3f of the region works\n",
                static_cast<unsigned long long>(report.calls),
                static_cast<unsigned long long>(report.feasible),
                report.certificate_lower_bound);
    for (const critreg::Constraint &constraint : learner.constraints())
        std::printf("constraint: %s; feasible from %.5f, infeasible to %.5f, name: %s\n",
                    constraint.text.c_str(), constraint.evidence.feasible,
                    constraint.evidence.infeasible, constraint.name.c_str());
    return region;
}

static void try_region(const critreg::Region &region, double width) {
    const std::vector<double> peg = {width};
    critreg::Rng rng(7);
    std::printf("peg of %.3f:", width);
    for (const auto &[low, high] : region.intervals(peg)) std::printf(" [%.4f, %.4f]", low, high);
    int drawn = 0, feasible = 0;
    for (int i = 0; i < 1000; i++) {
        if (auto opening = region.sample(peg, rng)) {
            drawn++;
            feasible += close_gripper(peg.data(), opening->data()) == CRITREG_FEASIBLE;
        }
    }
    std::printf(" %d draws, %d of them feasible\n", drawn, feasible);
}

int main() {
    try {
        const critreg::Region learned = learn_openings();
        std::printf("learned: %s\n", learned.text().c_str());
        for (double width : {0.025, 0.06, 0.095}) try_region(learned, width);

        const critreg::Region written =
            critreg::Region::parse(DOMAIN, "opening >= peg.width + finger.gap");
        std::printf("written: %s\n", written.text().c_str());
        for (double width : {0.025, 0.06, 0.095}) try_region(written, width);

        // Errors tell what is wrong and where.
        critreg::Region::parse(DOMAIN, "opening >= peg.height");
    } catch (const critreg::Error &error) {
        std::printf("%s: %s\n", critreg_status_name(error.status()), error.what());
        return error.status() == CRITREG_SYNTAX_ERROR ? 0 : 1;
    } catch (const std::exception &error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 1;
}
