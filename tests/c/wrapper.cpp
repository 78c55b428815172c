// What critreg.hpp promises: every part of it, with exceptions.
#include "expect.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include "critreg.hpp"

using critreg::Status;

static const std::vector<double> walls(WALLS, WALLS + 2 * INSTANCES);
static const char REGION[] = "hand.x <= wall.x - hand.radius";

static bool works(const double *instance, const double *theta) {
    return theta[0] <= instance[0] - 0.1;
}

static critreg::Learner new_learner(std::uint32_t calls = 60) {
    critreg_config config = critreg::Learner::default_config();
    config.calls = calls;
    return critreg::Learner(DOMAIN, config);
}

// The status of what a call throws.
template <class Call> static Status thrown(Call call) {
    try {
        call();
    } catch (const critreg::Error &error) {
        EXPECT_TRUE(std::string(error.what()) != "");
        return error.status();
    }
    return Status::ok;
}

// A region that comes out of a function keeps its memory and its evidence.
static critreg::Region learned() {
    critreg::Learner learner = new_learner();
    return learner.learn(walls, works);
}

static void regions() {
    const critreg::Region region = learned();
    const critreg::Region copy = region;    // of the same memory, which nobody changes
    EXPECT_TRUE(copy.text() == region.text() && copy.quality() == CRITREG_EXACT);
    EXPECT_TRUE(copy.constraints().size() == 1 && copy.constraints()[0].evidence.has_evidence == 1);
    EXPECT_TRUE(copy.constraints()[0].evidence.support > 0);
    const critreg::Region loaded = critreg::Region::load(copy.save());
    EXPECT_TRUE(loaded.text() == copy.text() && loaded.save() == copy.save());
    EXPECT_TRUE(loaded.quality() == CRITREG_NO_QUALITY);
    EXPECT_TRUE(loaded.constraints()[0].evidence.has_evidence == 0);
    EXPECT_TRUE(loaded.instance_len() == 2 && loaded.parameter_count() == 1);
}

// Whatever has a pointer and a length is a row of numbers.
static void views() {
    const critreg::Region region = critreg::Region::parse(DOMAIN, REGION);
    const std::array<double, 2> array = {1.0, 0.0};
    const double plain[] = {0.5};
    EXPECT_TRUE(region.contains(array, plain));
    EXPECT_TRUE(region.contains({WALLS, 2}, {0.5}));
    EXPECT_TRUE(!region.contains(std::vector<double>{1.0, 0.0}, {0.95}));
    EXPECT_TRUE(thrown([&] { (void)region.contains(array, {0.5, 0.5}); }) ==
                Status::invalid_argument);
    unsigned char inside[2] = {2, 2};
    region.contains({1.0, 0.0}, {0.5, 0.95}, inside);
    EXPECT_TRUE(inside[0] == 1 && inside[1] == 0);
    std::vector<double> values(region.constraints().size()), gradients(values);
    region.margins({1.0, 0.0}, {0.5}, values, gradients);
    EXPECT_TRUE(values[0] < 0.0 && gradients[0] == 1.0);
    double where[2], how[1];
    const std::vector<double> ranges = {0.0, 4.0, 0.0, 1.0};
    critreg_proof proof =
        region.implies(region, ranges, critreg::Region::default_proof(), where, how);
    EXPECT_TRUE(proof.verdict == CRITREG_PROVEN);
    const std::vector<std::string> questions = region.to_smt2(region, ranges);
    EXPECT_TRUE(!questions.empty() && questions[0].find("(check-sat)") != std::string::npos);
    EXPECT_TRUE(region.to_c("reach").find("reach_contains") != std::string::npos);
    EXPECT_TRUE(region.to_rust().find("pub fn contains(") != std::string::npos);
    EXPECT_TRUE(region.to_svg({1.0, 0.0}).find("</svg>") != std::string::npos);
    EXPECT_TRUE(thrown([&] { (void)region.to_svg({1.0}); }) == Status::invalid_argument);
    critreg::Rng many(3);
    double drawn[5] = {9.0, 9.0, 9.0, 9.0, 9.0};
    EXPECT_TRUE(region.sample_many({1.0, 0.0}, many, drawn) == 5 && drawn[4] <= 0.9);
    critreg_config noisy = critreg::Learner::default_config();
    noisy.noise = 0.5;
    EXPECT_TRUE(thrown([&] { critreg::Learner::check_config(noisy); }) ==
                Status::invalid_argument);
    EXPECT_TRUE(thrown([&] { (void)region.contains({1.0}, plain); }) == Status::invalid_argument);
    EXPECT_TRUE(thrown([&] { (void)region.contains({NAN, 0.0}, plain); }) == Status::not_finite);
}

static void draws() {
    const critreg::Region region = critreg::Region::parse(DOMAIN, REGION);
    critreg::Rng rng(7), same(7);
    const critreg::Sample sample = region.sample({1.0, 0.0}, rng);
    double theta[1] = {-1.0};
    EXPECT_TRUE(region.sample({1.0, 0.0}, same, theta) == Status::ok);
    EXPECT_TRUE(sample && sample.status() == Status::ok && sample->at(0) == theta[0]);
    EXPECT_TRUE(works(WALLS, theta));
    const critreg::Sample none = region.sample({-1.0, 0.0}, rng);
    EXPECT_TRUE(!none && none.status() == Status::empty_region);
    EXPECT_TRUE(region.sample({-1.0, 0.0}, rng, theta) == Status::empty_region);
    EXPECT_TRUE(region.is_empty({-1.0, 0.0}) && !region.is_empty({1.0, 0.0}));
    // Not proven to be empty, and yet nothing is found: a point in a square.
    const critreg::Region point = critreg::Region::parse(
        "object wall { x: length, y: length }\n"
        "parameter a in [0, 1]: length\nparameter b in [0, 1]: length\n"
        "point hand = world + (a, b)\n",
        "dist(hand, wall) <= 0 and hand.x <= 0.3 and hand.x >= 0.3");
    EXPECT_TRUE(!point.is_empty({0.3, 0.7}));
    EXPECT_TRUE(point.sample({0.3, 0.7}, rng).status() == Status::no_sample);
    double ends[2] = {};
    EXPECT_TRUE(region.intervals({1.0, 0.0}, ends) == 1 && ends[0] == 0.0);
    EXPECT_TRUE(region.intervals({1.0, 0.0}).at(0).second == ends[1]);
    EXPECT_TRUE(thrown([&] { (void)region.intervals({1.0, 0.0}, critreg::Room()); }) ==
                Status::too_small);
}

// Parts own what they are made of, so a list of them may outlive it.
static void parts() {
    std::vector<critreg::Part> parts;
    for (double x : {1.0, 1.5, 2.5})
        parts.push_back({critreg::Region::parse(DOMAIN, REGION), {x, 0.0}});
    critreg::Rng rng(7);
    const critreg::Sample sample = critreg::sample(parts, rng);
    EXPECT_TRUE(sample && sample->at(0) <= 0.9);
    EXPECT_TRUE(!critreg::are_empty(parts));
    parts.push_back({critreg::Region::parse(DOMAIN, REGION), {-1.0, 0.0}});
    EXPECT_TRUE(critreg::are_empty(parts));
    EXPECT_TRUE(critreg::sample(parts, rng).status() == Status::empty_region);
    EXPECT_TRUE(thrown([&] { (void)critreg::sample({}, rng); }) == Status::invalid_argument);
    parts.resize(CRITREG_MAX_REGIONS + 1, parts[0]);
    EXPECT_TRUE(thrown([&] { (void)critreg::sample(parts, rng); }) == Status::capacity_exceeded);
}

static void random_numbers() {
    static_assert(std::is_same_v<critreg::Rng::result_type, std::uint32_t>);
    static_assert(critreg::Rng::min() == 0 && critreg::Rng::max() == UINT32_MAX);
    critreg::Rng one(3), two(3);
    EXPECT_TRUE(one() == two() && one() == two());
    std::vector<int> order(100);
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), one);
    EXPECT_TRUE(!std::is_sorted(order.begin(), order.end()));
    double sum = 0.0;
    for (int i = 0; i < 10000; i++) sum += std::uniform_real_distribution<>(0.0, 1.0)(one);
    EXPECT_TRUE(std::fabs(sum / 10000 - 0.5) < 0.02);
}

static critreg_status count(void *data, const critreg_report *) {
    ++*static_cast<int *>(data);
    return CRITREG_OK;
}

// The callback of the configuration and a lambda both see every sample.
static void progress() {
    int configured = 0;
    std::uint64_t calls = 0;
    critreg_config config = critreg::Learner::default_config();
    config.progress = count;
    config.progress_data = &configured;
    critreg::Learner made(DOMAIN, config);
    critreg::Learner learner = std::move(made);     // What it is told by moves with it.
    const auto stop = [&](const critreg_report &report) {
        calls = report.calls;
        return calls == 10 ? Status::cancelled : Status::ok;
    };
    EXPECT_TRUE(thrown([&] { learner.learn(walls, works, stop); }) == Status::cancelled);
    EXPECT_TRUE(calls == 10 && configured == 10);
    learner.learn(walls, works);
    EXPECT_TRUE(calls == 10 && configured == 100);
    double where[2], how[1];
    const critreg_proof proof = learner.challenge(
        critreg::Region::parse(DOMAIN, "hand.x <= wall.x"), {0.5, 3.0, 0.0, 0.0},
        critreg::Region::default_proof(), where, how);
    EXPECT_TRUE(proof.verdict == CRITREG_PROVEN);
    try {
        new_learner().learn(walls, works, [](const critreg_report &) -> Status { throw 3; });
        EXPECT_TRUE(false);
    } catch (int number) {
        EXPECT_TRUE(number == 3);
    }
}

// Several workers, in any order; one of them is lost.
static void questions() {
    critreg::Learner learner = new_learner();
    std::vector<critreg::Question> asked = learner.ask_many(walls, 3);
    EXPECT_TRUE(asked.size() == 3 && learner.open_questions().size() == 3);
    learner.forget(asked[1].id);
    for (const critreg::Question &question : {asked[2], asked[0]})
        learner.tell_id(walls, question.id, works(&walls[2 * question.instance],
                                                  question.theta.data()));
    EXPECT_TRUE(learner.open_questions().empty());
    EXPECT_TRUE(thrown([&] { learner.tell_id(walls, asked[0].id, true); }) ==
                Status::out_of_sequence);
    while (!learner.is_finished())
        for (const critreg::Question &question : learner.ask_many(walls, 4))
            learner.tell_id(walls, question.id, works(&walls[2 * question.instance],
                                                      question.theta.data()));
    EXPECT_TRUE(learner.region().quality() == CRITREG_EXACT);
    EXPECT_TRUE(learner.why().code == CRITREG_WHY_EXPLAINED);
}

static void asking() {
    critreg::Learner learner = new_learner();
    const auto chosen = learner.choose_instances(
        9, [](std::size_t number, double *wall) { wall[0] = double(number), wall[1] = 0.0; }, 4);
    EXPECT_TRUE(chosen.size() == 8 && chosen[0] == 0.0 && chosen[7] == 0.0);
    EXPECT_TRUE(thrown([&] { (void)learner.choose_instances(0, [](std::size_t, double *) {}, 4); }) ==
                Status::invalid_argument);
    double theta[1];
    const std::size_t instance = learner.ask(walls, theta);
    const critreg::Query query = learner.ask(walls);
    EXPECT_TRUE(query.instance == instance && query.theta.at(0) == theta[0]);
    EXPECT_TRUE(thrown([&] { learner.tell(walls, 7); }) == Status::invalid_argument);
    EXPECT_TRUE(thrown([&] { learner.tell(walls, (1LL << 32) + 1); }) == Status::invalid_argument);
    learner.tell(walls, works(&walls[2 * instance], theta));
    learner.observe(walls, 0, {0.5}, true);
    learner.observe(walls, critreg::Query{1, {3.9}}, CRITREG_INFEASIBLE);
    learner.conclude(walls);
    EXPECT_TRUE(learner.report().calls == 1 && learner.report().observed == 2);
    EXPECT_TRUE(learner.instance_len() == 2 && learner.parameter_count() == 1);
    EXPECT_TRUE(thrown([&] { (void)learner.ask({1.0}); }) == Status::invalid_argument);
    EXPECT_TRUE(thrown([&] { learner.observe(walls, 0, {0.5, 0.5}, true); }) ==
                Status::invalid_argument);
}

static void saved_runs() {
    critreg::Learner learner = new_learner();
    std::vector<std::uint8_t> journal;
    for (std::size_t told = 0; told < 10; told++) {
        const critreg::Query query = learner.ask(walls);
        learner.tell(walls, works(&walls[2 * query.instance], query.theta.data()));
        for (std::uint8_t byte : learner.journal(walls, told)) journal.push_back(byte);
    }
    const std::vector<std::uint8_t> saved = learner.save(walls);
    critreg::Learner resumed = new_learner(), replayed = new_learner();
    resumed.resume(walls, saved);
    EXPECT_TRUE(resumed.save(walls) == saved);
    const std::size_t whole = journal.size();
    journal.push_back(1);
    EXPECT_TRUE(replayed.resume_journal(walls, journal) == whole);
    EXPECT_TRUE(replayed.save(walls) == saved);
    EXPECT_TRUE(thrown([&] { resumed.resume(walls, saved); }) == Status::out_of_sequence);
}

static void texts() {
    EXPECT_TRUE(critreg::version() == std::string(critreg_version()));
    EXPECT_TRUE(critreg::abi_version() == CRITREG_ABI_VERSION);
    EXPECT_TRUE((critreg::capabilities() & CRITREG_HAS_F64) != 0);
    EXPECT_TRUE(critreg::name(Status::busy) == std::string("CRITREG_BUSY"));
    EXPECT_TRUE(critreg::words(Status::busy) == std::string(critreg_strerror(CRITREG_BUSY)));
    critreg::Learner::check_domain(DOMAIN);
    try {
        critreg::Learner::check_domain("object a { x: length }\nshape a = potato(1)\n");
        EXPECT_TRUE(false);
    } catch (const critreg::Error &error) {
        EXPECT_TRUE(error.status() == Status::syntax_error);
        EXPECT_TRUE(std::string(error.what()).find("line 2, column") == 0);
    }
    critreg_config config = critreg::Learner::default_config();
    EXPECT_TRUE(critreg::Learner::size(config) > 1000);
    config.steps = CRITREG_MAX_STEPS + 1;
    EXPECT_TRUE(critreg::Learner::size(config) == 0);
    EXPECT_TRUE(thrown([&] { critreg::Learner(DOMAIN, config); }) == Status::invalid_argument);
}

// The built-in environment, planned in.
static void stick_button() {
    using Stick = critreg::StickButton;
    const std::vector<double> state = Stick::task(1, 0, 1);
    EXPECT_TRUE(state.size() == Stick::state_len(1));
    critreg::Learner learner(Stick::domain());
    int feasible = 0;
    for (int i = 0; i <= 20; i++) feasible += Stick::pick(state, 0.05 * i).number() == 1;
    EXPECT_TRUE(feasible > 0 && feasible < 21);

    // One operator by hand: pick the stick where picking works.
    critreg_ground ground = {};
    ground.name = "PickStickFromNothing";
    ground.object_names[0] = "robby";
    ground.object_names[1] = "stick";
    ground.object_count = 2;
    double parameters[CRITREG_MAX_PARAMETERS] = {};
    while (Stick::pick(state, parameters[0]).number() != 1) parameters[0] += 0.05;
    std::vector<double> after = state;
    EXPECT_TRUE(Stick::execute(ground, parameters, after) > 0 && after != state);
    ground.name = "Grasped";
    EXPECT_TRUE(Stick::holds(ground, after) && !Stick::holds(ground, state));
}

static const char OPERATORS[] =
    "(define (domain rail) (:predicates (AtLamp) (Lit))"
    "  (:action Drive :parameters () :effect (AtLamp))"
    "  (:action Light :parameters () :precondition (AtLamp) :effect (Lit)))";
static const char PROBLEM[] = "(define (problem light) (:domain rail) (:init) (:goal (Lit)))";

static critreg::World rail() {
    critreg::World world;
    world.execute = [](const critreg::Ground &ground, const double *parameters,
                       std::vector<double> &state) -> std::uint32_t {
        state[ground.name == "Drive" ? 0 : 1] += ground.name == "Drive" ? parameters[0] : 1.0;
        return 1;
    };
    world.holds = [](const critreg::Ground &ground, const std::vector<double> &state) {
        return ground.name == "AtLamp" ? std::fabs(state[0] - 3.0) < 0.1 : state[1] > 0.5;
    };
    return world;
}

static void planning() {
    critreg_planner_config config = critreg::Planner::default_config();
    critreg::Planner::measure(OPERATORS, PROBLEM, config);
    EXPECT_TRUE(config.operators < CRITREG_DEFAULT_OPERATORS);
    config.state_len = 2;
    EXPECT_TRUE(critreg::Planner::size(config) > 1000);
    critreg::Planner planner(OPERATORS, PROBLEM, config);
    planner.set_ranges("Drive", {{-4.0, 4.0}});
    const auto steps = planner.plan(rail(), {0.0, 0.0}, 1);
    EXPECT_TRUE(steps && steps->size() == 2 && steps->at(1).ground.text() == "(Light)");
    EXPECT_TRUE(planner.why().code == CRITREG_WHY_NOTHING && planner.why().text == "");

    critreg::World hopeless = rail();
    hopeless.sample = [](const critreg_draw &, critreg::Rng &, critreg_drawn &drawn) {
        drawn.reason = 5;
        return Status::empty_region;
    };
    EXPECT_TRUE(!planner.plan(hopeless, {0.0, 0.0}, 1));
    EXPECT_TRUE(planner.reasons(5) > 0 && planner.failures("Drive") > 0);
    EXPECT_TRUE(planner.why().text != "" && planner.message() != "");
    hopeless.advise = [](const critreg_ground *, std::size_t, const std::vector<double> &,
                         std::uint32_t &) -> critreg_advice { return CRITREG_PRUNE; };
    EXPECT_TRUE(!planner.plan(hopeless, {0.0, 0.0}, 1) && planner.metrics().pruned > 0);

    critreg::World wrong = rail();
    wrong.execute = [](const critreg::Ground &, const double *, std::vector<double> &state) {
        state.push_back(0.0);
        return 1U;
    };
    EXPECT_TRUE(thrown([&] { planner.plan(wrong, {0.0, 0.0}, 1); }) == Status::invalid_argument);
    EXPECT_TRUE(thrown([&] { planner.plan(rail(), {0.0}, 1); }) == Status::invalid_argument);
    EXPECT_TRUE(thrown([&] { planner.plan(critreg::World(), {0.0, 0.0}, 1); }) ==
                Status::null_pointer);
    EXPECT_TRUE(thrown([&] { planner.set_ranges("Fly", {}); }) == Status::invalid_argument);
    EXPECT_TRUE(thrown([&] { critreg::Planner("(", PROBLEM, config); }) == Status::syntax_error);
}

int main() {
    regions();
    views();
    draws();
    parts();
    random_numbers();
    progress();
    questions();
    asking();
    saved_runs();
    texts();
    stick_button();
    planning();
    return summary();
}
