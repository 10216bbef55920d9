; latch/new: ∀ speed, radius ∈ F64 ∪ {none}, timeout ∈ F64: new(speed, radius, timeout) = (limit(speed), limit(radius), timeout, faulty(speed) ∨ faulty(radius), false), the whole state
; Each answer has to be unsat, 34 of them. A question is a check that fails where the kernel has taken
; these decisions. x… are the doubles in the order in which the harness draws them, q… the seqs.
(set-logic QF_BVFP)
(declare-const x0 Float64)
(declare-const x1 Float64)
(define-fun t5 () Bool (not (or (fp.isNaN x0) (fp.isInfinite x0))))
(define-fun t6 () Bool (fp.lt x0 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t8 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x0))
(define-fun t9 () Bool (and t5 t8))
(define-fun t11 () Bool (and t5 (not t6)))
(define-fun t15 () Bool (not (or (fp.isNaN x1) (fp.isInfinite x1))))
(define-fun t16 () Bool (fp.lt x1 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t18 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x1))
(define-fun t19 () Bool (and t15 t18))
(define-fun t21 () Bool (and t15 (not t16)))
(define-fun t24 () Bool (and t11 t21))
(push 1) ; a config fault exactly for a faulty limit
(assert t5)(assert (not t6))(assert (not t11))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly for a faulty limit
(assert (not t5))(assert (not (not t11)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly for a faulty limit
(assert t5)(assert t6)(assert (not (not t11)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly for a faulty limit
(assert t5)(assert (not t6))(assert t15)(assert (not t16))(assert (not t24))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly for a faulty limit
(assert (not t5))(assert (not t15))(assert (not (not t24)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly for a faulty limit
(assert (not t5))(assert t15)(assert (not t16))(assert (not (not t24)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly for a faulty limit
(assert (not t5))(assert t15)(assert t16)(assert (not (not t24)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly for a faulty limit
(assert t5)(assert (not t6))(assert (not t15))(assert (not (not t24)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly for a faulty limit
(assert t5)(assert (not t6))(assert t15)(assert t16)(assert (not (not t24)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly for a faulty limit
(assert t5)(assert t6)(assert (not t15))(assert (not (not t24)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly for a faulty limit
(assert t5)(assert t6)(assert t15)(assert (not t16))(assert (not (not t24)))
(check-sat)
(pop 1)
(push 1) ; a config fault exactly for a faulty limit
(assert t5)(assert t6)(assert t15)(assert t16)(assert (not (not t24)))
(check-sat)
(pop 1)
(push 1) ; enabled exactly when finite and above 0
(assert t5)(assert t8)(assert (not t9))
(check-sat)
(pop 1)
(push 1) ; enabled exactly when finite and above 0
(assert (not t5))(assert (not (not t9)))
(check-sat)
(pop 1)
(push 1) ; enabled exactly when finite and above 0
(assert t5)(assert t6)(assert (not (not t9)))
(check-sat)
(pop 1)
(push 1) ; enabled exactly when finite and above 0
(assert t5)(assert t6)(assert (not (not t9)))
(check-sat)
(pop 1)
(push 1) ; enabled exactly when finite and above 0
(assert t5)(assert t6)(assert (not t15))(assert (not (not t9)))
(check-sat)
(pop 1)
(push 1) ; enabled exactly when finite and above 0
(assert t5)(assert t6)(assert t15)(assert (not t16))(assert (not t18))(assert (not (not t9)))
(check-sat)
(pop 1)
(push 1) ; enabled exactly when finite and above 0
(assert t5)(assert t6)(assert t15)(assert (not t16))(assert t18)(assert (not (not t9)))
(check-sat)
(pop 1)
(push 1) ; enabled exactly when finite and above 0
(assert t5)(assert t6)(assert t15)(assert t16)(assert (not (not t9)))
(check-sat)
(pop 1)
(push 1) ; enabled exactly when finite and above 0
(assert t5)(assert (not t8))(assert (not (not t9)))
(check-sat)
(pop 1)
(push 1) ; enabled exactly when finite and above 0
(assert t15)(assert t18)(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; enabled exactly when finite and above 0
(assert (not t5))(assert t15)(assert t16)(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; enabled exactly when finite and above 0
(assert t5)(assert (not t6))(assert (not t8))(assert t15)(assert t16)(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; enabled exactly when finite and above 0
(assert t5)(assert (not t6))(assert t8)(assert t15)(assert t16)(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; enabled exactly when finite and above 0
(assert t5)(assert t6)(assert t15)(assert t16)(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; enabled exactly when finite and above 0
(assert (not t15))(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; enabled exactly when finite and above 0
(assert t15)(assert (not t18))(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; faulty exactly when negative or not finite
(assert t5)(assert (not t6))(assert (not t11))
(check-sat)
(pop 1)
(push 1) ; faulty exactly when negative or not finite
(assert (not t5))(assert (not (not t11)))
(check-sat)
(pop 1)
(push 1) ; faulty exactly when negative or not finite
(assert t5)(assert t6)(assert (not (not t11)))
(check-sat)
(pop 1)
(push 1) ; faulty exactly when negative or not finite
(assert t15)(assert (not t16))(assert (not t21))
(check-sat)
(pop 1)
(push 1) ; faulty exactly when negative or not finite
(assert (not t15))(assert (not (not t21)))
(check-sat)
(pop 1)
(push 1) ; faulty exactly when negative or not finite
(assert t15)(assert t16)(assert (not (not t21)))
(check-sat)
(pop 1)
