(define (problem village)
  (:domain delivery)
  (:objects
    mill school - place
    lorry van - truck
    bee - drone
    letter box - parcel)
  (:init
    (road depot mill) (road mill depot) (road mill school) (road school school)
    (docked bee van)
    (at lorry depot) (at van depot) (at bee depot) (at letter depot) (at box depot))
  (:goal (and (at letter school) (carried-out box) (docked bee van))))
