(define (problem four-balls)
  (:domain gripper)
  (:objects kitchen hall left right ball1 ball2 ball3 ball4)
  (:init
    (room kitchen) (room hall) (hand left) (hand right)
    (ball ball1) (ball ball2) (ball ball3) (ball ball4)
    (robot-in kitchen) (free left) (free right)
    (in ball1 kitchen) (in ball2 kitchen) (in ball3 kitchen) (in ball4 kitchen))
  (:goal (and (in ball1 hall) (in ball2 hall) (in ball3 hall) (in ball4 hall))))
