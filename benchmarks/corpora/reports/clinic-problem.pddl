; Two wards, a laboratory and a pantry along one corridor.
(define (problem small-clinic)
  (:domain clinic)
  (:objects
    medi - robot
    ward-1 ward-2 - ward
    lab - lab
    pantry - pantry
    blood-sample swab - sample
    breakfast lunch - meal)
  (:init
    (robot-in medi ward-1) (tray-free medi)
    (linked ward-1 ward-2) (linked ward-2 ward-1)
    (linked ward-2 lab) (linked lab ward-2)
    (linked lab pantry) (linked pantry lab)
    (item-in blood-sample ward-1) (item-in swab ward-2)
    (item-in breakfast pantry) (item-in lunch pantry)
    (untested blood-sample) (untested swab)
    (locked pantry))
  (:goal (and (served breakfast) (disinfected ward-1)))
)
