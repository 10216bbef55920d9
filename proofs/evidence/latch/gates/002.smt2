; latch/gates: ∀ limits, states, commands: decision = first closed gate of 7.3; estop′ ⇔ estop ∨ mode = estop ∨ outside; note_link, reset as in 7.1
; Each answer has to be unsat, 400 of them. A question is a check that fails where the kernel has taken
; these decisions. x… are the doubles in the order in which the harness draws them, q… the seqs.
(set-logic QF_BVFP)
(declare-const x0 Float64)
(declare-const x1 Float64)
(declare-const x2 Float64)
(declare-const x3 Float64)
(declare-const x4 Float64)
(define-fun t9 () Bool (not (or (fp.isNaN x0) (fp.isInfinite x0))))
(define-fun t10 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x0))
(define-fun t11 () Bool (not (or (fp.isNaN x1) (fp.isInfinite x1))))
(define-fun t12 () Bool (not (or (fp.isNaN x2) (fp.isInfinite x2))))
(define-fun t13 () Bool (fp.leq x2 x1))
(define-fun t14 () Float64 (fp.sub RNE x1 x2))
(define-fun t16 () Float64 (fp.mul RNE t14 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t17 () Bool (fp.leq t16 x0))
(define-fun t18 () Bool (and t9 t10))
(define-fun t19 () Bool (and t11 t12))
(define-fun t20 () Bool (and t13 t19))
(define-fun t21 () Bool (and t18 t20))
(define-fun t22 () Bool (and t17 t21))
(declare-const x5 Float64)
(define-fun t25 () Bool (fp.lt x0 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t28 () Bool (and t9 (not t25)))
(define-fun t31 () Bool (and t28 (not t18)))
(define-fun t40 () Float64 (fp.mul RNE x4 x4))
(define-fun t42 () Float64 (fp.mul RNE x5 x5))
(define-fun t60 () Bool (not (or (fp.isNaN x3) (fp.isInfinite x3))))
(define-fun t61 () Bool (not (or (fp.isNaN x4) (fp.isInfinite x4))))
(define-fun t62 () Bool (not (or (fp.isNaN x5) (fp.isInfinite x5))))
(define-fun t63 () Bool (and t60 t61))
(define-fun t70 () Float64 (fp.sub RNE x2 x3))
(define-fun t71 () Float64 (fp.mul RNE t70 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t72 () Bool (fp.leq x3 x2))
(define-fun t73 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x1))
(define-fun t74 () Bool (and t11 t73))
(define-fun t75 () Bool (fp.leq t71 x1))
(define-fun t76 () Bool (and t12 t60))
(define-fun t77 () Bool (and t72 t76))
(define-fun t78 () Bool (and t74 t77))
(define-fun t79 () Bool (and t75 t78))
(define-fun t83 () Bool (and t31 t79))
(define-fun t86 () Bool (and (not t18) t83))
(define-fun t89 () Bool (and (not t18) t86))
(declare-const x6 Float64)
(define-fun t91 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t40))
(define-fun t92 () Float64 (fp.add RNE t91 t42))
(define-fun t93 () Float64 (fp.mul RNE x6 x6))
(define-fun t94 () Float64 (fp.add RNE t92 t93))
(define-fun t95 () Bool (fp.lt t94 (fp #b0 #b00001111011 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t96 () Bool (fp.lt t94 (fp #b0 #b11111100111 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t97 () Float64 (ite t96 (fp #b0 #b01111111111 #b0000000000000000000000000000000000000000000000000000) (fp #b0 #b00110100111 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t98 () Float64 (ite t95 (fp #b0 #b11001010111 #b0000000000000000000000000000000000000000000000000000) t97))
(define-fun t99 () Float64 (fp.mul RNE x4 t98))
(define-fun t100 () Float64 (fp.mul RNE t99 t99))
(define-fun t101 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t100))
(define-fun t102 () Float64 (fp.mul RNE x5 t98))
(define-fun t103 () Float64 (fp.mul RNE t102 t102))
(define-fun t104 () Float64 (fp.add RNE t101 t103))
(define-fun t105 () Float64 (fp.mul RNE x6 t98))
(define-fun t106 () Float64 (fp.mul RNE t105 t105))
(define-fun t107 () Float64 (fp.add RNE t104 t106))
(define-fun t108 () Float64 (fp.sqrt RNE t107))
(define-fun t109 () Float64 (fp.mul RNE x0 t98))
(define-fun t110 () Bool (fp.leq t108 t109))
(define-fun t111 () Bool (not (or (fp.isNaN x6) (fp.isInfinite x6))))
(define-fun t112 () Bool (and t61 t62))
(define-fun t113 () Bool (and t111 t112))
(define-fun t114 () Bool (and t18 t113))
(define-fun t115 () Bool (and t110 t114))
(define-fun t117 () Bool (and t18 (not t115)))
(define-fun t118 () Bool (and t83 t117))
(define-fun t121 () Bool (and t83 (not t117)))
(define-fun t126 () Bool (and t28 t79))
(define-fun t129 () Bool (and (not t18) t126))
(define-fun t130 () Bool (and t18 t129))
(define-fun t132 () Bool (and (not t18) t129))
(define-fun t133 () Bool (and t117 t126))
(define-fun t135 () Bool (and (not t117) t126))
(define-fun t212 () Bool (fp.lt x1 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t215 () Bool (and t11 (not t212)))
(define-fun t217 () Bool (and t28 t215))
(define-fun t220 () Bool (and (not t18) (not t74)))
(define-fun t222 () Bool (and t217 t220))
(define-fun t231 () Float64 (fp.sub RNE x3 x4))
(define-fun t232 () Float64 (fp.mul RNE t231 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t233 () Bool (fp.leq x4 x3))
(define-fun t234 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x2))
(define-fun t235 () Bool (and t12 t234))
(define-fun t236 () Bool (fp.leq t232 x2))
(define-fun t237 () Bool (and t63 t233))
(define-fun t238 () Bool (and t235 t237))
(define-fun t239 () Bool (and t236 t238))
(define-fun t243 () Bool (and t222 t239))
(define-fun t246 () Bool (and (not t74) t243))
(define-fun t247 () Bool (and t74 t246))
(define-fun t249 () Bool (and (not t74) t246))
(declare-const x7 Float64)
(define-fun t251 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t42))
(define-fun t252 () Float64 (fp.add RNE t251 t93))
(define-fun t253 () Float64 (fp.mul RNE x7 x7))
(define-fun t254 () Float64 (fp.add RNE t252 t253))
(define-fun t255 () Bool (fp.lt t254 (fp #b0 #b00001111011 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t256 () Bool (fp.lt t254 (fp #b0 #b11111100111 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t257 () Float64 (ite t256 (fp #b0 #b01111111111 #b0000000000000000000000000000000000000000000000000000) (fp #b0 #b00110100111 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t258 () Float64 (ite t255 (fp #b0 #b11001010111 #b0000000000000000000000000000000000000000000000000000) t257))
(define-fun t259 () Float64 (fp.mul RNE x5 t258))
(define-fun t260 () Float64 (fp.mul RNE t259 t259))
(define-fun t261 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t260))
(define-fun t262 () Float64 (fp.mul RNE x6 t258))
(define-fun t263 () Float64 (fp.mul RNE t262 t262))
(define-fun t264 () Float64 (fp.add RNE t261 t263))
(define-fun t265 () Float64 (fp.mul RNE x7 t258))
(define-fun t266 () Float64 (fp.mul RNE t265 t265))
(define-fun t267 () Float64 (fp.add RNE t264 t266))
(define-fun t268 () Float64 (fp.sqrt RNE t267))
(define-fun t269 () Float64 (fp.mul RNE x1 t258))
(define-fun t270 () Bool (fp.leq t268 t269))
(define-fun t271 () Bool (not (or (fp.isNaN x7) (fp.isInfinite x7))))
(define-fun t272 () Bool (and t62 t111))
(define-fun t273 () Bool (and t271 t272))
(define-fun t274 () Bool (and t74 t273))
(define-fun t275 () Bool (and t270 t274))
(define-fun t277 () Bool (and t74 (not t275)))
(define-fun t278 () Bool (and t243 t277))
(define-fun t281 () Bool (and t243 (not t277)))
(define-fun t284 () Bool (and (not t18) t217))
(define-fun t288 () Bool (and t239 t284))
(define-fun t291 () Bool (and (not t74) t288))
(define-fun t292 () Bool (and t74 t291))
(define-fun t294 () Bool (and (not t74) t291))
(define-fun t295 () Bool (and t277 t288))
(define-fun t297 () Bool (and (not t277) t288))
(define-fun t322 () Bool (and t217 (not t74)))
(define-fun t326 () Bool (and t239 t322))
(define-fun t329 () Bool (and (not t74) t326))
(define-fun t330 () Bool (and t74 t329))
(define-fun t333 () Bool (and t277 t326))
(define-fun t340 () Bool (and t217 t239))
(define-fun t343 () Bool (and (not t74) t340))
(define-fun t344 () Bool (and t74 t343))
(define-fun t347 () Bool (and t277 t340))
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t72)(assert t73)(assert (not t75))(assert (not (not t118)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t72)(assert t73)(assert t75)(assert (not (not t118)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert (not t73))(assert (not (not t118)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert (not t25))(assert (not (not t118)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t25)(assert (not (not t118)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert (not (not t130)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t130)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert t73)(assert (not (not t130)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert t73)(assert (not (not t130)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t72))(assert t73)(assert (not (not t130)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t72)(assert t73)(assert (not t75))(assert (not (not t130)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t72)(assert t73)(assert t75)(assert (not (not t130)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert (not t73))(assert (not (not t130)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert (not t11))(assert (not t25))(assert (not (not t130)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert (not t12))(assert (not t25))(assert t73)(assert (not (not t130)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert t73)(assert (not (not t130)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t72))(assert t73)(assert (not (not t130)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t72)(assert t73)(assert (not t75))(assert (not (not t130)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t72)(assert t73)(assert t75)(assert (not (not t130)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert (not t73))(assert (not (not t130)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t25)(assert (not (not t130)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t61))(assert t72)(assert t73)(assert t75)(assert (not t133))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t62))(assert t72)(assert t73)(assert t75)(assert (not t133))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t62)(assert t72)(assert t73)(assert t75)(assert (not t110))(assert t111)(assert (not t133))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t62)(assert t72)(assert t73)(assert t75)(assert (not t111))(assert (not t133))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert (not (not t133)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t133)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert t73)(assert (not (not t133)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert t73)(assert (not (not t133)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t72))(assert t73)(assert (not (not t133)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t72)(assert t73)(assert (not t75))(assert (not (not t133)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t72)(assert t73)(assert t75)(assert (not (not t133)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert (not t73))(assert (not (not t133)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert (not t11))(assert (not t25))(assert (not (not t133)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert (not t12))(assert (not t25))(assert t73)(assert (not (not t133)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert t73)(assert (not (not t133)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t62)(assert t72)(assert t73)(assert t75)(assert t110)(assert t111)(assert (not (not t133)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t72))(assert t73)(assert (not (not t133)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t72)(assert t73)(assert (not t75))(assert (not (not t133)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert (not t73))(assert (not (not t133)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t25)(assert (not (not t133)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert (not t11))(assert (not (not t247)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert t11)(assert (not t73))(assert (not t212))(assert (not (not t247)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert t11)(assert t73)(assert (not t212))(assert (not (not t247)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert t11)(assert t212)(assert (not (not t247)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t247)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert (not t73))(assert (not t212))(assert (not (not t247)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert (not t73))(assert (not t212))(assert t234)(assert (not (not t247)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t61))(assert (not t73))(assert (not t212))(assert t234)(assert (not (not t247)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert (not t233))(assert t234)(assert (not (not t247)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert t233)(assert t234)(assert (not t236))(assert (not (not t247)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert t233)(assert t234)(assert t236)(assert (not (not t247)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t73))(assert (not t212))(assert (not t234))(assert (not (not t247)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t73)(assert (not t212))(assert (not (not t247)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t212)(assert (not (not t247)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert (not t11))(assert (not t25))(assert (not (not t247)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert (not t73))(assert (not t212))(assert (not (not t247)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t73)(assert (not t212))(assert (not (not t247)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t212)(assert (not (not t247)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t11))(assert t25)(assert (not (not t247)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t25)(assert (not t73))(assert (not t212))(assert (not (not t247)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t25)(assert t73)(assert (not t212))(assert (not (not t247)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t25)(assert t212)(assert (not (not t247)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert (not t11))(assert (not (not t278)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert t11)(assert (not t73))(assert (not t212))(assert (not (not t278)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert t11)(assert t73)(assert (not t212))(assert (not (not t278)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert t11)(assert t212)(assert (not (not t278)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t278)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert (not t73))(assert (not t212))(assert (not (not t278)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert (not t73))(assert (not t212))(assert t234)(assert (not (not t278)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t61))(assert (not t73))(assert (not t212))(assert t234)(assert (not (not t278)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert (not t233))(assert t234)(assert (not (not t278)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert t233)(assert t234)(assert (not t236))(assert (not (not t278)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert t233)(assert t234)(assert t236)(assert (not (not t278)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t73))(assert (not t212))(assert (not t234))(assert (not (not t278)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t73)(assert (not t212))(assert (not (not t278)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t212)(assert (not (not t278)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert (not t11))(assert (not t25))(assert (not (not t278)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert (not t73))(assert (not t212))(assert (not (not t278)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t73)(assert (not t212))(assert (not (not t278)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t212)(assert (not (not t278)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t11))(assert t25)(assert (not (not t278)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t25)(assert (not t73))(assert (not t212))(assert (not (not t278)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t25)(assert t73)(assert (not t212))(assert (not (not t278)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t25)(assert t212)(assert (not (not t278)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert (not t11))(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert t11)(assert (not t73))(assert (not t212))(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert t11)(assert t73)(assert (not t212))(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert t11)(assert t212)(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert (not t73))(assert (not t212))(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert t73)(assert (not t212))(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert (not t73))(assert (not t212))(assert t234)(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert t73)(assert (not t212))(assert t234)(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t61))(assert (not t73))(assert (not t212))(assert t234)(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t61))(assert t73)(assert (not t212))(assert t234)(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert (not t233))(assert t234)(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert t233)(assert t234)(assert (not t236))(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert t233)(assert t234)(assert t236)(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t73)(assert (not t212))(assert (not t233))(assert t234)(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t73)(assert (not t212))(assert t233)(assert t234)(assert (not t236))(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t73)(assert (not t212))(assert t233)(assert t234)(assert t236)(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t73))(assert (not t212))(assert (not t234))(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t73)(assert (not t212))(assert (not t234))(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t212)(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert (not t11))(assert (not t25))(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert (not t73))(assert (not t212))(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t73)(assert (not t212))(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t212)(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t11))(assert t25)(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t25)(assert (not t73))(assert (not t212))(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t25)(assert t73)(assert (not t212))(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t25)(assert t212)(assert (not (not t292)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t62))(assert t73)(assert (not t212))(assert t233)(assert t234)(assert t236)(assert (not t295))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t62)(assert t73)(assert (not t111))(assert (not t212))(assert t233)(assert t234)(assert t236)(assert (not t295))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t62)(assert t73)(assert t111)(assert (not t212))(assert t233)(assert t234)(assert t236)(assert (not t270))(assert t271)(assert (not t295))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t62)(assert t73)(assert t111)(assert (not t212))(assert t233)(assert t234)(assert t236)(assert (not t271))(assert (not t295))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert (not t11))(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert t11)(assert (not t73))(assert (not t212))(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert t11)(assert t73)(assert (not t212))(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert t11)(assert t212)(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert (not t73))(assert (not t212))(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert t73)(assert (not t212))(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert (not t73))(assert (not t212))(assert t234)(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert t73)(assert (not t212))(assert t234)(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t61))(assert (not t73))(assert (not t212))(assert t234)(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t61))(assert t73)(assert (not t212))(assert t234)(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t62)(assert t73)(assert t111)(assert (not t212))(assert t233)(assert t234)(assert t236)(assert t270)(assert t271)(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert (not t233))(assert t234)(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert t233)(assert t234)(assert (not t236))(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert t233)(assert t234)(assert t236)(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t73)(assert (not t212))(assert (not t233))(assert t234)(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t73)(assert (not t212))(assert t233)(assert t234)(assert (not t236))(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t73))(assert (not t212))(assert (not t234))(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t73)(assert (not t212))(assert (not t234))(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t212)(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert (not t11))(assert (not t25))(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert (not t73))(assert (not t212))(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t73)(assert (not t212))(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t212)(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t11))(assert t25)(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t25)(assert (not t73))(assert (not t212))(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t25)(assert t73)(assert (not t212))(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t25)(assert t212)(assert (not (not t295)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert (not t11))(assert (not (not t330)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert t11)(assert (not t73))(assert (not t212))(assert (not (not t330)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert t11)(assert t73)(assert (not t212))(assert (not (not t330)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert t11)(assert t212)(assert (not (not t330)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t11))(assert (not t25))(assert (not (not t330)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t11))(assert t25)(assert (not (not t330)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert (not t12))(assert (not t25))(assert (not t73))(assert (not t212))(assert (not (not t330)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert (not t73))(assert (not t212))(assert t234)(assert (not (not t330)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t61))(assert (not t73))(assert (not t212))(assert t234)(assert (not (not t330)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert (not t233))(assert t234)(assert (not (not t330)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert t233)(assert t234)(assert (not t236))(assert (not (not t330)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert t233)(assert t234)(assert t236)(assert (not (not t330)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert (not t73))(assert (not t212))(assert (not t234))(assert (not (not t330)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert (not t25))(assert t73)(assert (not t212))(assert (not (not t330)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert (not t25))(assert t212)(assert (not (not t330)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t25)(assert (not t73))(assert (not t212))(assert (not (not t330)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t25)(assert t73)(assert (not t212))(assert (not (not t330)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t25)(assert t212)(assert (not (not t330)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert (not t11))(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert t11)(assert (not t73))(assert (not t212))(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert t11)(assert t73)(assert (not t212))(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert t11)(assert t212)(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t11))(assert (not t25))(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t11))(assert t25)(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert (not t12))(assert (not t25))(assert (not t73))(assert (not t212))(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert (not t73))(assert (not t212))(assert t234)(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t61))(assert (not t73))(assert (not t212))(assert t234)(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert (not t233))(assert t234)(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert t233)(assert t234)(assert (not t236))(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert t233)(assert t234)(assert t236)(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert (not t73))(assert (not t212))(assert (not t234))(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert (not t25))(assert t73)(assert (not t212))(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert (not t25))(assert t212)(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t25)(assert (not t73))(assert (not t212))(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t25)(assert t73)(assert (not t212))(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t25)(assert t212)(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert (not t11))(assert (not (not t344)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert t11)(assert (not t73))(assert (not t212))(assert (not (not t344)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert t11)(assert t73)(assert (not t212))(assert (not (not t344)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert t11)(assert t212)(assert (not (not t344)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t11))(assert (not t25))(assert (not (not t344)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t11))(assert t25)(assert (not (not t344)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert (not t12))(assert (not t25))(assert (not t73))(assert (not t212))(assert (not (not t344)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert (not t12))(assert (not t25))(assert t73)(assert (not t212))(assert (not (not t344)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert (not t73))(assert (not t212))(assert t234)(assert (not (not t344)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert t73)(assert (not t212))(assert t234)(assert (not (not t344)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t61))(assert (not t73))(assert (not t212))(assert t234)(assert (not (not t344)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t61))(assert t73)(assert (not t212))(assert t234)(assert (not (not t344)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert (not t233))(assert t234)(assert (not (not t344)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert t233)(assert t234)(assert (not t236))(assert (not (not t344)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert t233)(assert t234)(assert t236)(assert (not (not t344)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t73)(assert (not t212))(assert (not t233))(assert t234)(assert (not (not t344)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t73)(assert (not t212))(assert t233)(assert t234)(assert (not t236))(assert (not (not t344)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t73)(assert (not t212))(assert t233)(assert t234)(assert t236)(assert (not (not t344)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert (not t73))(assert (not t212))(assert (not t234))(assert (not (not t344)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t73)(assert (not t212))(assert (not t234))(assert (not (not t344)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert (not t25))(assert t212)(assert (not (not t344)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t25)(assert (not t73))(assert (not t212))(assert (not (not t344)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t25)(assert t73)(assert (not t212))(assert (not (not t344)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t25)(assert t212)(assert (not (not t344)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t62))(assert t73)(assert (not t212))(assert t233)(assert t234)(assert t236)(assert (not t347))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t62)(assert t73)(assert (not t111))(assert (not t212))(assert t233)(assert t234)(assert t236)(assert (not t347))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t62)(assert t73)(assert t111)(assert (not t212))(assert t233)(assert t234)(assert t236)(assert (not t270))(assert t271)(assert (not t347))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t62)(assert t73)(assert t111)(assert (not t212))(assert t233)(assert t234)(assert t236)(assert (not t271))(assert (not t347))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert (not t11))(assert (not (not t347)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert t11)(assert (not t73))(assert (not t212))(assert (not (not t347)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert t11)(assert t73)(assert (not t212))(assert (not (not t347)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert (not t9))(assert t11)(assert t212)(assert (not (not t347)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t11))(assert (not t25))(assert (not (not t347)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert (not t11))(assert t25)(assert (not (not t347)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert (not t12))(assert (not t25))(assert (not t73))(assert (not t212))(assert (not (not t347)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert (not t12))(assert (not t25))(assert t73)(assert (not t212))(assert (not (not t347)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert (not t73))(assert (not t212))(assert t234)(assert (not (not t347)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert t73)(assert (not t212))(assert t234)(assert (not (not t347)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t61))(assert (not t73))(assert (not t212))(assert t234)(assert (not (not t347)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t61))(assert t73)(assert (not t212))(assert t234)(assert (not (not t347)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t62)(assert t73)(assert t111)(assert (not t212))(assert t233)(assert t234)(assert t236)(assert t270)(assert t271)(assert (not (not t347)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert (not t233))(assert t234)(assert (not (not t347)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert t233)(assert t234)(assert (not t236))(assert (not (not t347)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert t233)(assert t234)(assert t236)(assert (not (not t347)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t73)(assert (not t212))(assert (not t233))(assert t234)(assert (not (not t347)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t73)(assert (not t212))(assert t233)(assert t234)(assert (not t236))(assert (not (not t347)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert (not t73))(assert (not t212))(assert (not t234))(assert (not (not t347)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t73)(assert (not t212))(assert (not t234))(assert (not (not t347)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert (not t25))(assert t212)(assert (not (not t347)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t25)(assert (not t73))(assert (not t212))(assert (not (not t347)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t25)(assert t73)(assert (not t212))(assert (not (not t347)))
(check-sat)
(pop 1)
(push 1) ; gate 4: outside
(assert t9)(assert t11)(assert t25)(assert t212)(assert (not (not t347)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert t12)(assert t13)(assert t17)(assert (not t22))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert (not t9))(assert (not (not t22)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert (not (not t22)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert (not t11))(assert (not (not t22)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert (not t12))(assert (not (not t22)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t13))(assert (not (not t22)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert t12)(assert t13)(assert (not t17))(assert (not (not t22)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t72)(assert t73)(assert t75)(assert (not t83))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t72)(assert t73)(assert t75)(assert (not t89))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t72)(assert t73)(assert t75)(assert (not t121))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert (not t9))(assert (not (not t89)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t89)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert t73)(assert (not (not t89)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert t73)(assert (not (not t89)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t72))(assert t73)(assert (not (not t89)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t72)(assert t73)(assert (not t75))(assert (not (not t89)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert (not t73))(assert (not (not t89)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert (not t25))(assert (not (not t89)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t25)(assert (not (not t89)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert (not t9))(assert (not (not t121)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t121)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert t73)(assert (not (not t121)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert t73)(assert (not (not t121)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t72))(assert t73)(assert (not (not t121)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t72)(assert t73)(assert (not t75))(assert (not (not t121)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert (not t73))(assert (not (not t121)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert (not t25))(assert (not (not t121)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t25)(assert (not (not t121)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t72)(assert t73)(assert t75)(assert (not t126))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t72)(assert t73)(assert t75)(assert (not t132))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t72)(assert t73)(assert t75)(assert (not t135))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t62)(assert t72)(assert t73)(assert t75)(assert t110)(assert t111)(assert (not t135))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert (not t9))(assert (not (not t132)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t132)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert t73)(assert (not (not t132)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert t73)(assert (not (not t132)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t72))(assert t73)(assert (not (not t132)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t72)(assert t73)(assert (not t75))(assert (not (not t132)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert (not t73))(assert (not (not t132)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert (not t11))(assert (not t25))(assert (not (not t132)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert (not t12))(assert (not t25))(assert t73)(assert (not (not t132)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert t73)(assert (not (not t132)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t72))(assert t73)(assert (not (not t132)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t72)(assert t73)(assert (not t75))(assert (not (not t132)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t72)(assert t73)(assert t75)(assert (not (not t132)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert (not t73))(assert (not (not t132)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t25)(assert (not (not t132)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert (not t9))(assert (not (not t135)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t135)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert t73)(assert (not (not t135)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert t73)(assert (not (not t135)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t72))(assert t73)(assert (not (not t135)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t72)(assert t73)(assert (not t75))(assert (not (not t135)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert (not t73))(assert (not (not t135)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert (not t11))(assert (not t25))(assert (not (not t135)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert (not t12))(assert (not t25))(assert t73)(assert (not (not t135)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert t73)(assert (not (not t135)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t61))(assert t72)(assert t73)(assert t75)(assert (not (not t135)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t62))(assert t72)(assert t73)(assert t75)(assert (not (not t135)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t62)(assert t72)(assert t73)(assert t75)(assert (not t110))(assert t111)(assert (not (not t135)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t62)(assert t72)(assert t73)(assert t75)(assert (not t111))(assert (not (not t135)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t72))(assert t73)(assert (not (not t135)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t72)(assert t73)(assert (not t75))(assert (not (not t135)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert (not t73))(assert (not (not t135)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t25)(assert (not (not t135)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert (not t9))(assert (not (not t83)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t83)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert t73)(assert (not (not t83)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert t73)(assert (not (not t83)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t72))(assert t73)(assert (not (not t83)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t72)(assert t73)(assert (not t75))(assert (not (not t83)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert (not t73))(assert (not (not t83)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert (not t25))(assert (not (not t83)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t25)(assert (not (not t83)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert (not t9))(assert (not (not t126)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t11))(assert (not t25))(assert (not (not t126)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t11)(assert (not t12))(assert (not t25))(assert t73)(assert (not (not t126)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert t73)(assert (not (not t126)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t72))(assert t73)(assert (not (not t126)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t72)(assert t73)(assert (not t75))(assert (not (not t126)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t11)(assert (not t25))(assert (not t73))(assert (not (not t126)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t25)(assert (not (not t126)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert t233)(assert t234)(assert t236)(assert (not t249))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert t233)(assert t234)(assert t236)(assert (not t281))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert (not t9))(assert (not t11))(assert (not (not t249)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert (not t9))(assert t11)(assert (not t73))(assert (not t212))(assert (not (not t249)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert (not t9))(assert t11)(assert t73)(assert (not t212))(assert (not (not t249)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert (not t9))(assert t11)(assert t212)(assert (not (not t249)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t249)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert (not t73))(assert (not t212))(assert (not (not t249)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert (not t73))(assert (not t212))(assert t234)(assert (not (not t249)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t61))(assert (not t73))(assert (not t212))(assert t234)(assert (not (not t249)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert (not t233))(assert t234)(assert (not (not t249)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert t233)(assert t234)(assert (not t236))(assert (not (not t249)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t73))(assert (not t212))(assert (not t234))(assert (not (not t249)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t73)(assert (not t212))(assert (not (not t249)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t212)(assert (not (not t249)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert (not t11))(assert (not t25))(assert (not (not t249)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert (not t73))(assert (not t212))(assert (not (not t249)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t73)(assert (not t212))(assert (not (not t249)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t212)(assert (not (not t249)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t11))(assert t25)(assert (not (not t249)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t11)(assert t25)(assert (not t73))(assert (not t212))(assert (not (not t249)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t11)(assert t25)(assert t73)(assert (not t212))(assert (not (not t249)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t11)(assert t25)(assert t212)(assert (not (not t249)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert (not t9))(assert (not t11))(assert (not (not t281)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert (not t9))(assert t11)(assert (not t73))(assert (not t212))(assert (not (not t281)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert (not t9))(assert t11)(assert t73)(assert (not t212))(assert (not (not t281)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert (not t9))(assert t11)(assert t212)(assert (not (not t281)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t281)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert (not t73))(assert (not t212))(assert (not (not t281)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert (not t73))(assert (not t212))(assert t234)(assert (not (not t281)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t61))(assert (not t73))(assert (not t212))(assert t234)(assert (not (not t281)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert (not t233))(assert t234)(assert (not (not t281)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert t233)(assert t234)(assert (not t236))(assert (not (not t281)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t73))(assert (not t212))(assert (not t234))(assert (not (not t281)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t73)(assert (not t212))(assert (not (not t281)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t212)(assert (not (not t281)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert (not t11))(assert (not t25))(assert (not (not t281)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert (not t73))(assert (not t212))(assert (not (not t281)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t73)(assert (not t212))(assert (not (not t281)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t212)(assert (not (not t281)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t11))(assert t25)(assert (not (not t281)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t11)(assert t25)(assert (not t73))(assert (not t212))(assert (not (not t281)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t11)(assert t25)(assert t73)(assert (not t212))(assert (not (not t281)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t11)(assert t25)(assert t212)(assert (not (not t281)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert t233)(assert t234)(assert t236)(assert (not t294))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t62)(assert t73)(assert t111)(assert (not t212))(assert t233)(assert t234)(assert t236)(assert t270)(assert t271)(assert (not t297))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert t233)(assert t234)(assert t236)(assert (not t297))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert (not t9))(assert (not t11))(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert (not t9))(assert t11)(assert (not t73))(assert (not t212))(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert (not t9))(assert t11)(assert t73)(assert (not t212))(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert (not t9))(assert t11)(assert t212)(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert (not t73))(assert (not t212))(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert t73)(assert (not t212))(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert (not t73))(assert (not t212))(assert t234)(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert t73)(assert (not t212))(assert t234)(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t61))(assert (not t73))(assert (not t212))(assert t234)(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t61))(assert t73)(assert (not t212))(assert t234)(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert (not t233))(assert t234)(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert (not t73))(assert (not t212))(assert t233)(assert t234)(assert (not t236))(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t73)(assert (not t212))(assert (not t233))(assert t234)(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t73)(assert (not t212))(assert t233)(assert t234)(assert (not t236))(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert t61)(assert t73)(assert (not t212))(assert t233)(assert t234)(assert t236)(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t73))(assert (not t212))(assert (not t234))(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t73)(assert (not t212))(assert (not t234))(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert (not t25))(assert t212)(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert (not t11))(assert (not t25))(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert (not t73))(assert (not t212))(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t73)(assert (not t212))(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t10)(assert t11)(assert (not t25))(assert t212)(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t11))(assert t25)(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t11)(assert t25)(assert (not t73))(assert (not t212))(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t11)(assert t25)(assert t73)(assert (not t212))(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert t11)(assert t25)(assert t212)(assert (not (not t294)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert (not t9))(assert (not t11))(assert (not (not t297)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert (not t9))(assert t11)(assert (not t73))(assert (not t212))(assert (not (not t297)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert (not t9))(assert t11)(assert t73)(assert (not t212))(assert (not (not t297)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert (not t9))(assert t11)(assert t212)(assert (not (not t297)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert (not t11))(assert (not t25))(assert (not (not t297)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert (not t73))(assert (not t212))(assert (not (not t297)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert (not t12))(assert (not t25))(assert t73)(assert (not t212))(assert (not (not t297)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert (not t73))(assert (not t212))(assert t234)(assert (not (not t297)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert (not t60))(assert t73)(assert (not t212))(assert t234)(assert (not (not t297)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t61))(assert (not t73))(assert (not t212))(assert t234)(assert (not (not t297)))
(check-sat)
(pop 1)
(push 1) ; gate 5: only active moves
(assert t9)(assert (not t10))(assert t11)(assert t12)(assert (not t25))(assert t60)(assert (not t61))(assert t73)(assert (not t212))(assert t234)(assert (not (not t297)))
(check-sat)
(pop 1)
