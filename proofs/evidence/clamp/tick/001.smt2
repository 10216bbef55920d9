; clamp/tick: limit_tick(channels, limit) is ok ⇔ ¬faulty ∧ fin(channels) ∧ (enabled ⇒ velocity is named, 3 wide, in m/s); and then ∀ c in m/s: ‖c‖ ≤ max
; Each answer has to be unsat, 400 of them. A question is a check that fails where the kernel has taken
; these decisions. x… are the doubles in the order in which the harness draws them, q… the seqs.
(set-logic QF_BVFP)
(declare-const x0 Float64)
(declare-const x1 Float64)
(declare-const x2 Float64)
(declare-const x3 Float64)
(define-fun t5 () Bool (not (or (fp.isNaN x3) (fp.isInfinite x3))))
(define-fun t6 () Bool (not (or (fp.isNaN x1) (fp.isInfinite x1))))
(define-fun t7 () Bool (not (or (fp.isNaN x2) (fp.isInfinite x2))))
(define-fun t9 () Bool (and t6 t7))
(define-fun t10 () Bool (and t5 t9))
(declare-const x4 Float64)
(define-fun t14 () Bool (not (or (fp.isNaN x4) (fp.isInfinite x4))))
(define-fun t15 () Bool (and t10 t14))
(declare-const x5 Float64)
(define-fun t18 () Bool (not (or (fp.isNaN x5) (fp.isInfinite x5))))
(define-fun t19 () Bool (and t15 t18))
(define-fun t21 () Bool (not (or (fp.isNaN x0) (fp.isInfinite x0))))
(define-fun t22 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x0))
(define-fun t23 () Float64 (fp.mul RNE x3 x3))
(define-fun t27 () Bool (and t21 t22))
(define-fun t29 () Bool (and (not t10) t27))
(define-fun t31 () Bool (and t10 t27))
(define-fun t35 () Float64 (fp.mul RNE x0 (fp #b0 #b01111111110 #b1111111111111111111111111111111111111111111111110111)))
(define-fun t42 () Float64 (fp.abs x3))
(define-fun t43 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t42))
(define-fun t44 () Float64 (fp.div RNE x3 t42))
(define-fun t45 () Float64 (fp.mul RNE t44 t44))
(define-fun t54 () Float64 (fp.div RNE x3 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t55 () Float64 (fp.mul RNE t54 t54))
(define-fun t64 () Float64 (fp.mul RNE x1 x1))
(define-fun t65 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t64))
(define-fun t66 () Float64 (fp.mul RNE x2 x2))
(define-fun t67 () Float64 (fp.add RNE t65 t66))
(define-fun t82 () Float64 (fp.abs x1))
(define-fun t83 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t82))
(define-fun t84 () Float64 (fp.abs x2))
(define-fun t85 () Bool (fp.lt t82 t84))
(define-fun t86 () Float64 (fp.div RNE x1 t84))
(define-fun t87 () Float64 (fp.div RNE x2 t84))
(define-fun t88 () Float64 (fp.mul RNE t86 t86))
(define-fun t89 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t88))
(define-fun t90 () Float64 (fp.mul RNE t87 t87))
(define-fun t91 () Float64 (fp.add RNE t89 t90))
(define-fun t102 () Float64 (fp.div RNE x1 t82))
(define-fun t103 () Float64 (fp.div RNE x2 t82))
(define-fun t104 () Float64 (fp.mul RNE t102 t102))
(define-fun t105 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t104))
(define-fun t106 () Float64 (fp.mul RNE t103 t103))
(define-fun t107 () Float64 (fp.add RNE t105 t106))
(define-fun t118 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t84))
(define-fun t119 () Float64 (fp.div RNE x1 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t120 () Float64 (fp.div RNE x2 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t121 () Float64 (fp.mul RNE t119 t119))
(define-fun t122 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t121))
(define-fun t123 () Float64 (fp.mul RNE t120 t120))
(define-fun t124 () Float64 (fp.add RNE t122 t123))
(define-fun t135 () Float64 (fp.mul RNE x4 x4))
(define-fun t136 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t135))
(define-fun t137 () Float64 (fp.sqrt RNE t136))
(define-fun t138 () Bool (fp.leq t137 x0))
(define-fun t139 () Bool (and (not t15) t27))
(define-fun t141 () Bool (and t15 t27))
(define-fun t143 () Bool (not (or (fp.isNaN t137) (fp.isInfinite t137))))
(define-fun t144 () Float64 (fp.div RNE t35 t137))
(define-fun t145 () Float64 (fp.mul RNE x4 t144))
(define-fun t146 () Float64 (fp.mul RNE t145 t145))
(define-fun t147 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t146))
(define-fun t148 () Float64 (fp.sqrt RNE t147))
(define-fun t149 () Bool (fp.leq t148 x0))
(define-fun t150 () Float64 (fp.abs x4))
(define-fun t151 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t150))
(define-fun t152 () Float64 (fp.div RNE x4 t150))
(define-fun t153 () Float64 (fp.mul RNE t152 t152))
(define-fun t154 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t153))
(define-fun t155 () Float64 (fp.sqrt RNE t154))
(define-fun t156 () Float64 (fp.div RNE t35 t155))
(define-fun t157 () Float64 (fp.mul RNE t152 t156))
(define-fun t158 () Float64 (fp.mul RNE t157 t157))
(define-fun t159 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t158))
(define-fun t160 () Float64 (fp.sqrt RNE t159))
(define-fun t161 () Bool (fp.leq t160 x0))
(define-fun t162 () Float64 (fp.div RNE x4 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t163 () Float64 (fp.mul RNE t162 t162))
(define-fun t164 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t163))
(define-fun t165 () Float64 (fp.sqrt RNE t164))
(define-fun t166 () Float64 (fp.div RNE t35 t165))
(define-fun t167 () Float64 (fp.mul RNE t162 t166))
(define-fun t168 () Float64 (fp.mul RNE t167 t167))
(define-fun t169 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t168))
(define-fun t170 () Float64 (fp.sqrt RNE t169))
(define-fun t171 () Bool (fp.leq t170 x0))
(define-fun t172 () Float64 (fp.add RNE t67 t23))
(define-fun t173 () Float64 (fp.sqrt RNE t172))
(define-fun t174 () Bool (fp.leq t173 x0))
(define-fun t175 () Bool (not (or (fp.isNaN t173) (fp.isInfinite t173))))
(define-fun t177 () Float64 (fp.mul RNE x0 (fp #b0 #b01111111110 #b1111111111111111111111111111111111111111111111110101)))
(define-fun t178 () Float64 (fp.div RNE t177 t173))
(define-fun t179 () Float64 (fp.mul RNE x1 t178))
(define-fun t180 () Float64 (fp.mul RNE x2 t178))
(define-fun t181 () Float64 (fp.mul RNE x3 t178))
(define-fun t182 () Float64 (fp.mul RNE t179 t179))
(define-fun t183 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t182))
(define-fun t184 () Float64 (fp.mul RNE t180 t180))
(define-fun t185 () Float64 (fp.add RNE t183 t184))
(define-fun t186 () Float64 (fp.mul RNE t181 t181))
(define-fun t187 () Float64 (fp.add RNE t185 t186))
(define-fun t188 () Float64 (fp.sqrt RNE t187))
(define-fun t189 () Bool (fp.leq t188 x0))
(define-fun t190 () Bool (fp.lt t84 t42))
(define-fun t191 () Float64 (fp.div RNE x1 t42))
(define-fun t192 () Float64 (fp.div RNE x2 t42))
(define-fun t193 () Float64 (fp.mul RNE t191 t191))
(define-fun t194 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t193))
(define-fun t195 () Float64 (fp.mul RNE t192 t192))
(define-fun t196 () Float64 (fp.add RNE t194 t195))
(define-fun t197 () Float64 (fp.add RNE t196 t45))
(define-fun t198 () Float64 (fp.sqrt RNE t197))
(define-fun t199 () Float64 (fp.div RNE t177 t198))
(define-fun t200 () Float64 (fp.mul RNE t191 t199))
(define-fun t201 () Float64 (fp.mul RNE t192 t199))
(define-fun t202 () Float64 (fp.mul RNE t44 t199))
(define-fun t203 () Float64 (fp.mul RNE t200 t200))
(define-fun t204 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t203))
(define-fun t205 () Float64 (fp.mul RNE t201 t201))
(define-fun t206 () Float64 (fp.add RNE t204 t205))
(define-fun t207 () Float64 (fp.mul RNE t202 t202))
(define-fun t208 () Float64 (fp.add RNE t206 t207))
(define-fun t209 () Float64 (fp.sqrt RNE t208))
(define-fun t210 () Bool (fp.leq t209 x0))
(define-fun t211 () Float64 (fp.div RNE x3 t84))
(define-fun t212 () Float64 (fp.mul RNE t211 t211))
(define-fun t213 () Float64 (fp.add RNE t91 t212))
(define-fun t214 () Float64 (fp.sqrt RNE t213))
(define-fun t215 () Float64 (fp.div RNE t177 t214))
(define-fun t216 () Float64 (fp.mul RNE t86 t215))
(define-fun t217 () Float64 (fp.mul RNE t87 t215))
(define-fun t218 () Float64 (fp.mul RNE t211 t215))
(define-fun t219 () Float64 (fp.mul RNE t216 t216))
(define-fun t220 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t219))
(define-fun t221 () Float64 (fp.mul RNE t217 t217))
(define-fun t222 () Float64 (fp.add RNE t220 t221))
(define-fun t223 () Float64 (fp.mul RNE t218 t218))
(define-fun t224 () Float64 (fp.add RNE t222 t223))
(define-fun t225 () Float64 (fp.sqrt RNE t224))
(define-fun t226 () Bool (fp.leq t225 x0))
(define-fun t227 () Bool (fp.lt t82 t42))
(define-fun t228 () Float64 (fp.div RNE x3 t82))
(define-fun t229 () Float64 (fp.mul RNE t228 t228))
(define-fun t230 () Float64 (fp.add RNE t107 t229))
(define-fun t231 () Float64 (fp.sqrt RNE t230))
(define-fun t232 () Float64 (fp.div RNE t177 t231))
(define-fun t233 () Float64 (fp.mul RNE t102 t232))
(define-fun t234 () Float64 (fp.mul RNE t103 t232))
(define-fun t235 () Float64 (fp.mul RNE t228 t232))
(define-fun t236 () Float64 (fp.mul RNE t233 t233))
(define-fun t237 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t236))
(define-fun t238 () Float64 (fp.mul RNE t234 t234))
(define-fun t239 () Float64 (fp.add RNE t237 t238))
(define-fun t240 () Float64 (fp.mul RNE t235 t235))
(define-fun t241 () Float64 (fp.add RNE t239 t240))
(define-fun t242 () Float64 (fp.sqrt RNE t241))
(define-fun t243 () Bool (fp.leq t242 x0))
(define-fun t244 () Float64 (fp.add RNE t124 t55))
(define-fun t245 () Float64 (fp.sqrt RNE t244))
(define-fun t246 () Float64 (fp.div RNE t177 t245))
(define-fun t247 () Float64 (fp.mul RNE t119 t246))
(define-fun t248 () Float64 (fp.mul RNE t120 t246))
(define-fun t249 () Float64 (fp.mul RNE t54 t246))
(define-fun t250 () Float64 (fp.mul RNE t247 t247))
(define-fun t251 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t250))
(define-fun t252 () Float64 (fp.mul RNE t248 t248))
(define-fun t253 () Float64 (fp.add RNE t251 t252))
(define-fun t254 () Float64 (fp.mul RNE t249 t249))
(define-fun t255 () Float64 (fp.add RNE t253 t254))
(define-fun t256 () Float64 (fp.sqrt RNE t255))
(define-fun t257 () Bool (fp.leq t256 x0))
(define-fun t259 () Bool (= x1 t179))
(define-fun t260 () Bool (= x2 t180))
(define-fun t261 () Bool (= x3 t181))
(define-fun t262 () Bool (and t259 t260))
(define-fun t263 () Bool (and t261 t262))
(define-fun t265 () Bool (and t174 (not t263)))
(define-fun t267 () Bool (fp.leq (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x0))
(define-fun t268 () Bool (= x1 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t269 () Bool (= x2 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t270 () Bool (= x3 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t271 () Bool (and t268 t269))
(define-fun t272 () Bool (and t270 t271))
(define-fun t274 () Bool (and t174 (not t272)))
(define-fun t276 () Bool (= x1 t200))
(define-fun t277 () Bool (= x2 t201))
(define-fun t278 () Bool (= x3 t202))
(define-fun t279 () Bool (and t276 t277))
(define-fun t280 () Bool (and t278 t279))
(define-fun t282 () Bool (and t174 (not t280)))
(define-fun t284 () Bool (= x1 t216))
(define-fun t285 () Bool (= x2 t217))
(define-fun t286 () Bool (= x3 t218))
(define-fun t287 () Bool (and t284 t285))
(define-fun t288 () Bool (and t286 t287))
(define-fun t290 () Bool (and t174 (not t288)))
(define-fun t292 () Bool (= x1 t233))
(define-fun t293 () Bool (= x2 t234))
(define-fun t294 () Bool (= x3 t235))
(define-fun t295 () Bool (and t292 t293))
(define-fun t296 () Bool (and t294 t295))
(define-fun t298 () Bool (and t174 (not t296)))
(define-fun t300 () Bool (= x1 t247))
(define-fun t301 () Bool (= x2 t248))
(define-fun t302 () Bool (= x3 t249))
(define-fun t303 () Bool (and t300 t301))
(define-fun t304 () Bool (and t302 t303))
(define-fun t306 () Bool (and t174 (not t304)))
(define-fun t309 () Bool (and t138 t174))
(define-fun t311 () Bool (= x4 t145))
(define-fun t313 () Bool (and t138 (not t311)))
(define-fun t315 () Bool (= x4 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t317 () Bool (and t138 (not t315)))
(define-fun t319 () Bool (= x4 t157))
(define-fun t321 () Bool (and t138 (not t319)))
(define-fun t323 () Bool (= x4 t167))
(define-fun t325 () Bool (and t138 (not t323)))
(define-fun t331 () Bool (and (not t19) t27))
(define-fun t333 () Bool (and t19 t27))
(push 1) ; a channel that is not above it is as it was
(assert (not t174))(assert (not (not t265)))
(check-sat)
(pop 1)
(push 1) ; a channel that is not above it is as it was
(assert (not t174))(assert (not (not t274)))
(check-sat)
(pop 1)
(push 1) ; a channel that is not above it is as it was
(assert (not t174))(assert (not (not t282)))
(check-sat)
(pop 1)
(push 1) ; a channel that is not above it is as it was
(assert (not t174))(assert (not (not t290)))
(check-sat)
(pop 1)
(push 1) ; a channel that is not above it is as it was
(assert (not t174))(assert (not (not t298)))
(check-sat)
(pop 1)
(push 1) ; a channel that is not above it is as it was
(assert (not t174))(assert (not (not t306)))
(check-sat)
(pop 1)
(push 1) ; a channel that is not above it is as it was
(assert (not t138))(assert (not (not t313)))
(check-sat)
(pop 1)
(push 1) ; a channel that is not above it is as it was
(assert (not t138))(assert (not (not t317)))
(check-sat)
(pop 1)
(push 1) ; a channel that is not above it is as it was
(assert (not t138))(assert (not (not t321)))
(check-sat)
(pop 1)
(push 1) ; a channel that is not above it is as it was
(assert (not t138))(assert (not (not t325)))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t138)(assert (not t138))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t149)(assert (not t149))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t161)(assert (not t161))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t171)(assert (not t171))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t174)(assert (not t174))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t189)(assert (not t189))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t210)(assert (not t210))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t226)(assert (not t226))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t243)(assert (not t243))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t257)(assert (not t257))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert (not t257))(assert t14)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert (not t257))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert (not t257))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert (not t257))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert t171)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert (not t257))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert (not t257))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert (not t257))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert t161)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert (not t257))(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert (not t257))(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert (not t257))(assert t14)(assert (not t138))(assert t143)(assert t149)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert (not t257))(assert t14)(assert t138)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert t257)(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert t257)(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert t257)(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert (not t210))(assert t14)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert (not t210))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert (not t210))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert (not t210))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert t171)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert (not t210))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert (not t210))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert (not t210))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert t161)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert (not t210))(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert (not t210))(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert (not t210))(assert t14)(assert (not t138))(assert t143)(assert t149)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert (not t210))(assert t14)(assert t138)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert t210)(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert t210)(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert t210)(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert (not t226))(assert t14)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert (not t226))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert (not t226))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert (not t226))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert t171)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert (not t226))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert (not t226))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert (not t226))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert t161)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert (not t226))(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert (not t226))(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert (not t226))(assert t14)(assert (not t138))(assert t143)(assert t149)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert (not t226))(assert t14)(assert t138)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert t226)(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert t226)(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert t226)(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert (not t210))(assert t14)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert (not t210))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert (not t210))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert (not t210))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert t171)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert (not t210))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert (not t210))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert (not t210))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert t161)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert (not t210))(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert (not t210))(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert (not t210))(assert t14)(assert (not t138))(assert t143)(assert t149)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert (not t210))(assert t14)(assert t138)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert t210)(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert t210)(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert t210)(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert (not t243))(assert t14)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert (not t243))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert (not t243))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert (not t243))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert t171)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert (not t243))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert (not t243))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert (not t243))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert t161)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert (not t243))(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert (not t243))(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert (not t243))(assert t14)(assert (not t138))(assert t143)(assert t149)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert (not t243))(assert t14)(assert t138)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert t243)(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert t243)(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert t243)(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert (not t210))(assert t14)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert (not t210))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert (not t210))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert (not t210))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert t171)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert (not t210))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert (not t210))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert (not t210))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert t161)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert (not t210))(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert (not t210))(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert (not t210))(assert t14)(assert (not t138))(assert t143)(assert t149)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert (not t210))(assert t14)(assert t138)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert t210)(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert t210)(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert t210)(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert (not t226))(assert t14)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert (not t226))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert (not t226))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert (not t226))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert t171)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert (not t226))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert (not t226))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert (not t226))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert t161)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert (not t226))(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert (not t226))(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert (not t226))(assert t14)(assert (not t138))(assert t143)(assert t149)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert (not t226))(assert t14)(assert t138)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert t226)(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert t226)(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert t226)(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert (not t210))(assert t14)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert (not t210))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert (not t210))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert (not t210))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert t171)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert (not t210))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert (not t210))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert (not t210))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert t161)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert (not t210))(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert (not t210))(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert (not t210))(assert t14)(assert (not t138))(assert t143)(assert t149)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert (not t210))(assert t14)(assert t138)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert t210)(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert t210)(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert t210)(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert t175)(assert (not t189))(assert t14)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert t175)(assert (not t189))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert t175)(assert (not t189))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert t175)(assert (not t189))(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert t171)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert t175)(assert (not t189))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert t175)(assert (not t189))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert t175)(assert (not t189))(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert t161)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert t175)(assert (not t189))(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert t175)(assert (not t189))(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert t175)(assert (not t189))(assert t14)(assert (not t138))(assert t143)(assert t149)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert t175)(assert (not t189))(assert t14)(assert t138)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert t175)(assert t189)(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert t175)(assert t189)(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert t175)(assert t189)(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert t174)(assert t14)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert t174)(assert t14)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert t174)(assert t14)(assert (not t138))(assert t143)(assert (not t149))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert (not t257))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert (not t226))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert (not t243))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert (not t226))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t174))(assert t175)(assert (not t189))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert (not t257))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert (not t257))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert t257)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert t210)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert (not t226))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert (not t226))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert t226)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert t210)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert (not t243))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert (not t243))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert t243)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert t210)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert (not t226))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert (not t226))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert t226)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert t210)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert t175)(assert (not t189))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert t175)(assert (not t189))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert t175)(assert t189)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert (not t171))(assert t6)(assert t7)(assert t5)(assert t174)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert t171)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert (not t257))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert t171)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert t171)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert (not t226))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert t171)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert t171)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert (not t243))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert t171)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert t171)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert (not t226))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert t171)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert (not t151))(assert t171)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert t175)(assert (not t189))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert (not t257))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert (not t257))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert t257)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert t210)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert (not t226))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert (not t226))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert t226)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert t210)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert (not t243))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert (not t243))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert t243)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert t210)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert (not t226))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert (not t226))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert t226)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert t210)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert t175)(assert (not t189))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert t175)(assert (not t189))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert t175)(assert t189)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert (not t161))(assert t6)(assert t7)(assert t5)(assert t174)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert t161)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert (not t257))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert t161)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert t161)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert (not t226))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert t161)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert t161)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert (not t243))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert t161)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert t161)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert (not t226))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert t161)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert (not t143))(assert t151)(assert t161)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert t175)(assert (not t189))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert (not t257))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert (not t257))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert t257)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert t210)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert (not t226))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert (not t226))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert t226)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert t210)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert (not t243))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert (not t243))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert t243)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert t210)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert (not t226))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert (not t226))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert t226)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert t210)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert t175)(assert (not t189))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert t175)(assert (not t189))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert (not t174))(assert t175)(assert t189)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert (not t149))(assert t6)(assert t7)(assert t5)(assert t174)(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert t149)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert (not t257))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert t149)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert t149)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert (not t226))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert t149)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert t149)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert (not t243))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert t149)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert t149)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert (not t226))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert t149)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t138))(assert t143)(assert t149)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert t175)(assert (not t189))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert t138)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert (not t43))(assert (not t257))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert t138)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert (not t118))(assert t43)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert t138)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert (not t190))(assert (not t226))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert t138)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert (not t83))(assert t118)(assert t190)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert t138)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert (not t227))(assert (not t243))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert t138)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert (not t85))(assert t227)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert t138)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert (not t190))(assert (not t226))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert t138)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert (not t175))(assert t83)(assert t85)(assert t190)(assert (not t210))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert t138)(assert t6)(assert t7)(assert t5)(assert (not t174))(assert t175)(assert (not t189))(assert (not t267))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert (not t10))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert (not t6))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert (not t7))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t7))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert (not t15))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert t14)(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert (not t14))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert t14)(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t7))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t7))(assert t14)(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t14))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert t18)(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert t18)(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert (not t14))(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert (not t14))(assert t18)(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert (not t18))(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert t18)(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t7))(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t7))(assert t18)(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t18))(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert (not t21))(assert (not (not t29)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t21)(assert (not t22))(assert (not (not t29)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t21)(assert t22)(assert (not (not t29)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert (not t21))(assert (not (not t29)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t21)(assert (not t22))(assert (not (not t29)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert t7)(assert (not t21))(assert (not (not t29)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert t7)(assert t21)(assert (not t22))(assert (not (not t29)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert (not (not t31)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert (not (not t31)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert t21)(assert t22)(assert (not (not t31)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert (not t6))(assert (not (not t31)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert (not t6))(assert t21)(assert t22)(assert (not (not t31)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert (not t7))(assert (not (not t31)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert (not t7))(assert t21)(assert t22)(assert (not (not t31)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert (not (not t31)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t7))(assert (not (not t31)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert (not t21))(assert (not (not t139)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert t21)(assert (not t22))(assert (not (not t139)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert t21)(assert t22)(assert (not (not t139)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert (not t21))(assert (not (not t139)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t21)(assert (not t22))(assert (not (not t139)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t14)(assert (not t21))(assert (not (not t139)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t14)(assert t21)(assert (not t22))(assert (not (not t139)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert t14)(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert t14)(assert t21)(assert t22)(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert (not t14))(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert (not t14))(assert t21)(assert t22)(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert t14)(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert t14)(assert t21)(assert t22)(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t7))(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t7))(assert t14)(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t7))(assert t14)(assert t21)(assert t22)(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t14))(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert t18)(assert (not t21))(assert (not (not t331)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert t18)(assert t21)(assert (not t22))(assert (not (not t331)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert t18)(assert t21)(assert t22)(assert (not (not t331)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert (not t21))(assert (not (not t331)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert t21)(assert (not t22))(assert (not (not t331)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t18)(assert (not t21))(assert (not (not t331)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t18)(assert t21)(assert (not t22))(assert (not (not t331)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert t18)(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert t18)(assert t21)(assert t22)(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert (not t14))(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert (not t14))(assert t18)(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert (not t14))(assert t18)(assert t21)(assert t22)(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert (not t18))(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert (not t18))(assert t21)(assert t22)(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert t18)(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert t18)(assert t21)(assert t22)(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t7))(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t7))(assert t18)(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t7))(assert t18)(assert t21)(assert t22)(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t18))(assert (not (not t333)))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert t174)(assert (not t174))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert (not t174))(assert (not (not t174)))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert t138)(assert t174)(assert (not t309))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert (not t138))(assert (not t174))(assert (not (not t309)))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert (not t138))(assert t174)(assert (not (not t309)))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert t138)(assert (not t174))(assert (not (not t309)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert (not t10))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t5))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t5))(assert t6)(assert t7)(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert (not t6))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert (not t7))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t6))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t6)(assert (not t7))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert t14)(assert (not t15))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t5))(assert t6)(assert t7)(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t5))(assert t6)(assert t7)(assert t14)(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert (not t14))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t6))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t6))(assert t14)(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t6)(assert (not t7))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t6)(assert (not t7))(assert t14)(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t14))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert t14)(assert t18)(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t5))(assert t6)(assert t7)(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t5))(assert t6)(assert t7)(assert t18)(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert (not t14))(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert (not t14))(assert t18)(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert t14)(assert (not t18))(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t6))(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t6))(assert t18)(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t6)(assert (not t7))(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t6)(assert (not t7))(assert t18)(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t18))(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert t14)(assert t21)(assert t22)(assert (not t141))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t5))(assert t6)(assert t7)(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t5))(assert t6)(assert t7)(assert t14)(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t5))(assert t6)(assert t7)(assert t14)(assert t21)(assert t22)(assert (not (not t141)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert (not t14))(assert t21)(assert t22)(assert (not (not t141)))
(check-sat)
(pop 1)
