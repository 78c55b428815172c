(define (problem two-buttons)
  (:domain stick-button)
  (:objects
    robby - robot
    stick - stick
    holder - holder
    button0 button1 - button)
  (:init (HandEmpty robby) (AboveNoButton))
  (:goal (and (Pressed button0) (Pressed button1))))
