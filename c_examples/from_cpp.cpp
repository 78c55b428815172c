// The library from C++17: a gripper closes around pegs of different width.
//
// The program learns how wide to open it, and draws openings for pegs that it has
// not seen: from the region that was learned, and from one written by hand. Then it
// plans with it. Errors are exceptions.
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

static bool close_gripper(const double *instance, const double *theta) {
    const double width = instance[0], opening = theta[0];
    return opening >= width + 0.01;
}

static critreg::Region learn_openings() {
    critreg_config config = critreg::Learner::default_config();
    config.calls = 40;
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
    for (const critreg::Constraint &constraint : region.constraints())
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
            feasible += close_gripper(peg.data(), opening->data());
        }
    }
    std::printf(" %d draws, %d of them feasible\n", drawn, feasible);
}

static const char OPERATORS[] =
    "(define (domain gripper)"
    "  (:types peg)"
    "  (:predicates (Around ?p - peg) (Held ?p - peg))"
    "  (:action Open :parameters (?p - peg) :effect (Around ?p))"
    "  (:action Close :parameters (?p - peg) :precondition (Around ?p) :effect (Held ?p)))";
static const char PROBLEM[] =
    "(define (problem grip) (:domain gripper) (:objects peg - peg) (:init) (:goal (Held peg)))";

// A state is the width of the peg, how wide the gripper is open, and whether it holds.
static critreg::World world(const critreg::Region *region) {
    critreg::World world;
    world.execute = [](const critreg::Ground &ground, const double *parameters,
                       std::vector<double> &state) -> std::uint32_t {
        if (ground.name == "Open") {
            state[1] = parameters[0];
            return 1;
        }
        state[2] = close_gripper(&state[0], &state[1]);
        return 1;
    };
    world.holds = [](const critreg::Ground &ground, const std::vector<double> &state) {
        return ground.name == "Held" ? state[2] > 0.5 : state[1] > state[0];
    };
    if (region != nullptr)
        world.sample = [region](const critreg_draw &draw, critreg::Rng &rng,
                                critreg_drawn &drawn) -> critreg::Status {
            if (draw.parameter_count == 0) return critreg::Status::ok;
            const auto opening = region->sample({draw.state[0]}, rng);
            if (!opening) return opening.status();
            drawn.parameters[0] = opening->front();
            drawn.informed = 1;
            return critreg::Status::ok;
        };
    return world;
}

static void plan(const critreg::Region &region) {
    critreg_planner_config config = critreg::Planner::default_config();
    config.state_len = 3;
    critreg::Planner planner(OPERATORS, PROBLEM, config);
    planner.set_ranges("Open", {{0.0, 0.1}});
    const std::vector<double> initial = {0.085, 0.0, 0.0};
    for (bool informed : {false, true}) {
        const auto steps = planner.plan(world(informed ? &region : nullptr), initial, 1);
        std::printf("plan %s:", informed ? "with it" : "without the region");
        for (const critreg::Step &step : steps.value())
            std::printf(" %s", step.ground.text().c_str());
        std::printf(" after %u samples\n", planner.metrics().samples);
    }
    // What a callback throws comes through, and planning can go on.
    critreg::World broken = world(&region);
    broken.execute = [](const critreg::Ground &ground, const double *,
                        std::vector<double> &) -> std::uint32_t {
        throw std::runtime_error("cannot run " + ground.text());
    };
    try {
        planner.plan(broken, initial, 1);
    } catch (const std::runtime_error &stopped) {
        std::printf("stopped: %s\n", stopped.what());
    }
    // A peg that is too wide: the region is empty, and says so.
    if (!planner.plan(world(&region), {0.095, 0.0, 0.0}, 1))
        std::printf("%s; %s failed most\n", planner.message().c_str(), planner.metrics().most_failed);
}

// The same without a callback that draws: skills are learned in tasks, and planned with.
static void plan_with_skills() {
    critreg_skills_config config = critreg::Skills::default_config();
    config.state_len = 3;
    critreg::Skills skills(OPERATORS, "type peg { width: length, open: length, held: flag }\n"
                                      "object pegs[1]: peg", config);
    skills.add_controller("Open", "", "", {{0.0, 0.1}});
    skills.add("Open", "object peg { width: length }\nconstant finger.gap = 0.01: length\n"
                       "parameter opening in [0, 0.1]: length");
    skills.add_pair("Open", "Close");
    for (int i = 0; i < 30; i++) skills.add_task(PROBLEM, {0.02 + 0.002 * i, 0.0, 0.0});
    skills.learn(world(nullptr));
    const critreg::SkillReport report = skills.report(1);
    std::printf("learned of Open, then Close: %s after %u calls\n", report.text.c_str(),
                report.numbers.calls);
    critreg_planner_config planning = critreg::Planner::default_config();
    planning.state_len = 3;
    critreg::Planner planner(OPERATORS, PROBLEM, planning);
    if (planner.plan(world(nullptr), {0.085, 0.0, 0.0}, 1, &skills))
        std::printf("plan with skills after %u samples\n", planner.metrics().samples);
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

        const std::vector<double> thin = {0.025}, thick = {0.06};
        critreg::Rng rng(7);
        const auto both = critreg::sample({{written, thin}, {written, thick}}, rng);
        std::printf("an opening for two pegs: %.4f\n", both.value().front());
        plan(learned);
        plan_with_skills();

        // Errors tell what is wrong and where.
        const critreg::Region wrong = critreg::Region::parse(DOMAIN, "opening >= peg.height");
    } catch (const critreg::Error &error) {
        std::printf("%s: %s\n", critreg::name(error.status()), error.what());
        return error.status() == critreg::Status::syntax_error ? 0 : 1;
    } catch (const std::exception &error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 1;
}
