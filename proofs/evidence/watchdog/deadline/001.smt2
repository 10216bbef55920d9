; watchdog/deadline: ∀ now, r, ttl ∈ F64: within_deadline(now, r, ttl) ⇔ fin(now) ∧ fin(r) ∧ r ≤ now ∧ fin(ttl) ∧ 0 < ttl ∧ (now ⊖ r) ⊗ 1000 ≤ ttl ∧ (now ⊖ r) ⊗ 1000 ≤ 60000; and is_fresh likewise without 60000
; Each answer has to be unsat, 18 of them. A question is a check that fails where the kernel has taken
; these decisions. x… are the doubles in the order in which the harness draws them, q… the seqs.
(set-logic QF_BVFP)
(declare-const x0 Float64)
(declare-const x1 Float64)
(declare-const x2 Float64)
(define-fun t3 () Bool (not (or (fp.isNaN x2) (fp.isInfinite x2))))
(define-fun t5 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x2))
(define-fun t7 () Bool (fp.lt x2 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t8 () Bool (not (or (fp.isNaN x0) (fp.isInfinite x0))))
(define-fun t9 () Bool (not (or (fp.isNaN x1) (fp.isInfinite x1))))
(define-fun t10 () Bool (fp.leq x1 x0))
(define-fun t11 () Float64 (fp.sub RNE x0 x1))
(define-fun t13 () Float64 (fp.mul RNE t11 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t14 () Bool (fp.leq t13 x2))
(define-fun t15 () Bool (and t3 t5))
(define-fun t17 () Bool (fp.leq t13 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t18 () Bool (and t8 t9))
(define-fun t19 () Bool (and t10 t18))
(define-fun t20 () Bool (and t15 t19))
(define-fun t21 () Bool (and t14 t20))
(define-fun t22 () Bool (and t17 t21))
(push 1) ; a sensor frame is fresh exactly by its age
(assert t3)(assert t5)(assert t8)(assert t9)(assert t10)(assert t14)(assert (not t21))
(check-sat)
(pop 1)
(push 1) ; a sensor frame is fresh exactly by its age
(assert (not t3))(assert (not (not t21)))
(check-sat)
(pop 1)
(push 1) ; a sensor frame is fresh exactly by its age
(assert t3)(assert (not t5))(assert (not (not t21)))
(check-sat)
(pop 1)
(push 1) ; a sensor frame is fresh exactly by its age
(assert t3)(assert t5)(assert (not t8))(assert (not (not t21)))
(check-sat)
(pop 1)
(push 1) ; a sensor frame is fresh exactly by its age
(assert t3)(assert t5)(assert t8)(assert (not t9))(assert (not (not t21)))
(check-sat)
(pop 1)
(push 1) ; a sensor frame is fresh exactly by its age
(assert t3)(assert t5)(assert t8)(assert t9)(assert (not t10))(assert (not (not t21)))
(check-sat)
(pop 1)
(push 1) ; a sensor frame is fresh exactly by its age
(assert t3)(assert t5)(assert t8)(assert t9)(assert t10)(assert (not t14))(assert (not (not t21)))
(check-sat)
(pop 1)
(push 1) ; alive exactly by the liveness rule
(assert t3)(assert t5)(assert (not t7))(assert t8)(assert t9)(assert t10)(assert t17)(assert (not t14))(assert (not t22))
(check-sat)
(pop 1)
(push 1) ; alive exactly by the liveness rule
(assert t3)(assert t5)(assert t7)(assert t8)(assert t9)(assert t10)(assert t14)(assert (not t22))
(check-sat)
(pop 1)
(push 1) ; alive exactly by the liveness rule
(assert t3)(assert t5)(assert t8)(assert t9)(assert t10)(assert t14)(assert t17)(assert (not t22))
(check-sat)
(pop 1)
(push 1) ; alive exactly by the liveness rule
(assert (not t3))(assert (not (not t22)))
(check-sat)
(pop 1)
(push 1) ; alive exactly by the liveness rule
(assert t3)(assert (not t5))(assert (not (not t22)))
(check-sat)
(pop 1)
(push 1) ; alive exactly by the liveness rule
(assert t3)(assert t5)(assert (not t8))(assert (not (not t22)))
(check-sat)
(pop 1)
(push 1) ; alive exactly by the liveness rule
(assert t3)(assert t5)(assert t8)(assert (not t9))(assert (not (not t22)))
(check-sat)
(pop 1)
(push 1) ; alive exactly by the liveness rule
(assert t3)(assert t5)(assert t8)(assert t9)(assert (not t10))(assert (not (not t22)))
(check-sat)
(pop 1)
(push 1) ; alive exactly by the liveness rule
(assert t3)(assert t5)(assert t8)(assert t9)(assert t10)(assert (not t14))(assert (not (not t22)))
(check-sat)
(pop 1)
(push 1) ; alive exactly by the liveness rule
(assert t3)(assert t5)(assert t8)(assert t9)(assert t10)(assert (not t14))(assert (not t17))(assert (not (not t22)))
(check-sat)
(pop 1)
(push 1) ; alive exactly by the liveness rule
(assert t3)(assert t5)(assert t8)(assert t9)(assert t10)(assert t14)(assert (not t17))(assert (not (not t22)))
(check-sat)
(pop 1)
