/**
 * @file critreg.hpp
 * critreg.h for C++17: owners of memory, exceptions, vectors and views.
 *
 * A critreg::Learner owns the memory of a learner, a critreg::Region that of a region, a
 * critreg::Planner that of a planner, critreg::Skills that of skills. What can fail throws
 * critreg::Error. Nothing here is linked: the headers only call the functions of critreg.h, which remains the manual.
 *
 *     critreg::Learner learner(DOMAIN);
 *     critreg::Region region = learner.learn(instances, [](const double *instance,
 *                                                          const double *theta) {
 *         return try_grasp(instance, theta);      // a bool: whether it works
 *     });
 *     critreg::Rng rng(7);
 *     if (auto theta = region.sample(instance, rng)) try_it(*theta);
 *
 * Numbers are taken as a vector, an array, a std::span, a pointer and a length, or
 * {1.0, 2.0}. What is asked often has an overload that writes into memory of the program
 * and does not allocate.
 *
 * The same classes in critreg::nothrow never throw: what can fail returns a critreg::Result,
 * with a value or a status and a message, and make() takes the place of constructors. They
 * also compile without exceptions (-fno-exceptions), where the others are left out:
 *
 *     auto learner = critreg::nothrow::Learner::make(DOMAIN);
 *     if (!learner) return complain(learner.message());
 *     auto region = learner->learn(instances, try_grasp);
 *     if (region.status() == critreg::Status::no_region) use_own_sampler();
 */
#ifndef CRITREG_HPP
#define CRITREG_HPP

#include "critreg_learner.hpp"
#include "critreg_planner.hpp"
#include "critreg_region.hpp"
#include "critreg_skills.hpp"
#include "critreg_stick_button.hpp"
#include "critreg_support.hpp"
#include "critreg_world.hpp"

#endif
