; Two patients and a room each, the pharmacy downstairs and the nurses' station between them.
(define (problem night-round)
  (:domain hospital)
  (:objects
    medi - robot
    room-1 room-2 - room
    pharmacy - pharmacy
    station - station
    adams brown - patient
    aspirin insulin - medicine)
  (:init
    (robot-at medi station)
    (corridor station pharmacy) (corridor pharmacy station)
    (corridor station room-1) (corridor room-1 station)
    (corridor station room-2) (corridor room-2 station)
    (lies-in adams room-1) (lies-in brown room-2)
    (prescribed aspirin adams) (prescribed insulin brown)
    (unseen adams) (unseen brown))
  (:goal (and (charted adams) (charted brown) (nurse-informed)))
)
