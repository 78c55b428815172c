"""Worlds of KinDER, all variants of an environment as one: its models, and what is said of them."""

import dataclasses
import warnings
from importlib import import_module

warnings.filterwarnings("ignore")

import kinder
from kinder_bilevel_planning.env_models import create_bilevel_planning_models


class Environment:
    """An environment whose variants differ in how many objects there are.

    `module` is the file of texts beside this one: its name is that of the models.
    """

    def __init__(self, module: str):
        self.text = import_module(module)
        self._envs, self._models = {}, {}

    def models(self, variant: int):
        """The models of a variant, as KinDER has them."""
        if variant not in self._models:
            env = kinder.make(self.text.ENVIRONMENT.format(variant))
            spaces = env.observation_space, env.action_space
            counted = {self.text.COUNTED: variant}
            self._envs[variant] = env
            self._models[variant] = create_bilevel_planning_models(
                self.text.__name__, *spaces, **counted
            )
        return self._models[variant]

    def state(self, variant: int, seed: int):
        """The state that a task begins in."""
        models = self.models(variant)
        observation, _ = self._envs[variant].reset(seed=seed)
        return models.observation_to_state(observation)

    def of_all(self, variants):
        """Models for the states of all these variants: each state has those of its own."""
        counts = {len(list(self.state(variant, 0))): variant for variant in variants}

        def own(state):
            return self.models(counts[len(list(state))])

        return dataclasses.replace(
            self.models(variants[0]),
            transition_fn=lambda state, action: own(state).transition_fn(state, action),
            state_abstractor=lambda state: own(state).state_abstractor(state),
            goal_deriver=lambda state: own(state).goal_deriver(state),
        )


kinder.register_all_environments()
