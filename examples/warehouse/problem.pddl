; Three aisles, each with one parcel; a ring of ways joins them to the office and the dock,
; and the charging point is beside the dock.
(define (problem three-aisles)
  (:domain warehouse)
  (:objects
    cart - carrier
    fork - lifter
    aisle-1 aisle-2 aisle-3 - aisle
    bay - dock
    desk - office
    plug - charger
    crate drum carton - parcel)
  (:init
    (robot-at cart bay) (robot-at fork aisle-1)
    (path bay aisle-1) (path aisle-1 bay)
    (path aisle-1 aisle-2) (path aisle-2 aisle-1)
    (path aisle-2 aisle-3) (path aisle-3 aisle-2)
    (path aisle-3 desk) (path desk aisle-3)
    (path desk bay) (path bay desk)
    (path bay plug) (path plug bay)
    (on-shelf crate aisle-1) (on-shelf drum aisle-2) (on-shelf carton aisle-3))
  (:goal (and (delivered crate) (delivered drum) (delivered carton)))
)
