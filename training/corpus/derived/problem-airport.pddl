(define (problem airport-1)
  (:domain airport)
  (:objects
    cart1 cart2 - cart
    gate-a gate-b customs baggage-hall - loc
    parcel1 parcel2 - parcel
    door1 door2 - door)
  (:init (at cart1 hangar) (at cart2 customs) (empty cart1) (empty cart2)
    (lies parcel1 baggage-hall) (lies parcel2 baggage-hall)
    (by door1 gate-a) (by door2 gate-b) (locked door1) (locked door2)
    (road hangar baggage-hall) (road baggage-hall hangar)
    (road baggage-hall customs) (road customs baggage-hall)
    (road customs gate-a) (road gate-a customs)
    (road customs gate-b) (road gate-b customs))
  (:goal (delivered parcel1)))
