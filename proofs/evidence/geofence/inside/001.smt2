; geofence/inside: ∀ x, y, z, r ∈ F64: inside ⇔ fin(x) ∧ fin(y) ∧ fin(z) ∧ fin(r) ∧ 0 < r ∧ √(x⊗x ⊕ y⊗y ⊕ z⊗z) ≤ r
; Each answer has to be unsat, 7 of them. A question is a check that fails where the kernel has taken
; these decisions. x… are the doubles in the order in which the harness draws them, q… the seqs.
(set-logic QF_BVFP)
(declare-const x0 Float64)
(declare-const x1 Float64)
(declare-const x2 Float64)
(declare-const x3 Float64)
(define-fun t4 () Bool (not (or (fp.isNaN x0) (fp.isInfinite x0))))
(define-fun t5 () Bool (not (or (fp.isNaN x1) (fp.isInfinite x1))))
(define-fun t6 () Bool (not (or (fp.isNaN x2) (fp.isInfinite x2))))
(define-fun t7 () Bool (not (or (fp.isNaN x3) (fp.isInfinite x3))))
(define-fun t9 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x3))
(define-fun t10 () Float64 (fp.mul RNE x0 x0))
(define-fun t11 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t10))
(define-fun t12 () Float64 (fp.mul RNE x1 x1))
(define-fun t13 () Float64 (fp.add RNE t11 t12))
(define-fun t14 () Float64 (fp.mul RNE x2 x2))
(define-fun t15 () Float64 (fp.add RNE t13 t14))
(define-fun t16 () Float64 (fp.sqrt RNE t15))
(define-fun t17 () Bool (fp.leq t16 x3))
(define-fun t18 () Bool (and t7 t9))
(define-fun t20 () Bool (and t4 t5))
(define-fun t21 () Bool (and t6 t20))
(define-fun t22 () Bool (and t18 t21))
(define-fun t23 () Bool (and t17 t22))
(push 1) ; inside
(assert t4)(assert t5)(assert t6)(assert t7)(assert t9)(assert t17)(assert (not t23))
(check-sat)
(pop 1)
(push 1) ; inside
(assert (not t4))(assert (not (not t23)))
(check-sat)
(pop 1)
(push 1) ; inside
(assert t4)(assert (not t5))(assert (not (not t23)))
(check-sat)
(pop 1)
(push 1) ; inside
(assert t4)(assert t5)(assert (not t6))(assert (not (not t23)))
(check-sat)
(pop 1)
(push 1) ; inside
(assert t4)(assert t5)(assert t6)(assert (not t7))(assert (not (not t23)))
(check-sat)
(pop 1)
(push 1) ; inside
(assert t4)(assert t5)(assert t6)(assert t7)(assert (not t9))(assert (not (not t23)))
(check-sat)
(pop 1)
(push 1) ; inside
(assert t4)(assert t5)(assert t6)(assert t7)(assert t9)(assert (not t17))(assert (not (not t23)))
(check-sat)
(pop 1)
