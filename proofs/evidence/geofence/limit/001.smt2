; geofence/limit: ∀ v ∈ F64 ∪ {none}: limit(v) = Enabled(v) ⇔ fin(v) ∧ 0 < v; Faulty ⇔ ¬fin(v) ∨ v < 0
; Each answer has to be unsat, 7 of them. A question is a check that fails where the kernel has taken
; these decisions. x… are the doubles in the order in which the harness draws them, q… the seqs.
(set-logic QF_BVFP)
(declare-const x0 Float64)
(define-fun t4 () Bool (not (or (fp.isNaN x0) (fp.isInfinite x0))))
(define-fun t5 () Bool (fp.lt x0 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t7 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x0))
(define-fun t8 () Bool (and t4 t7))
(define-fun t10 () Bool (and t4 (not t5)))
(push 1) ; enabled
(assert t4)(assert t7)(assert (not t8))
(check-sat)
(pop 1)
(push 1) ; enabled
(assert (not t4))(assert (not (not t8)))
(check-sat)
(pop 1)
(push 1) ; enabled
(assert t4)(assert t5)(assert (not (not t8)))
(check-sat)
(pop 1)
(push 1) ; enabled
(assert t4)(assert (not t7))(assert (not (not t8)))
(check-sat)
(pop 1)
(push 1) ; faulty
(assert t4)(assert (not t5))(assert (not t10))
(check-sat)
(pop 1)
(push 1) ; faulty
(assert (not t4))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; faulty
(assert t4)(assert t5)(assert (not (not t10)))
(check-sat)
(pop 1)
