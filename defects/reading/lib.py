import json,glob,tomllib,os
R=''
def fnv(b):
    h=0xcbf29ce484222325
    for x in b: h=((h^x)*0x100000001b3)&0xffffffffffffffff
    return h^(h>>32)^(h>>48)
cases={}
bykey={}
for f in sorted(glob.glob(R+'vectors/corpus/**/*.json',recursive=True)):
    for x in json.load(open(f))['cases']:
        x['file']=f[len(R):]
        cases[x['id']]=x; bykey[fnv(x['id'].encode())&0xffffffff]=x
M=json.load(open(R+'reports/full/mutants.json'))['mutants']
D={}; order=[]
for f in sorted(glob.glob(R+'defects/peer/*.toml')):
    for d in tomllib.load(open(f,'rb'))['defect']:
        d['toml']=os.path.basename(f); D[d['name']]=d; order.append(d['name'])
fails={}
for n in ('alone.json','alone-large.json'):
    for p in json.load(open(R+'.tools/dictionary/'+n))['peers']:
        if len(p[0])==1:
            fails.setdefault(p[0][0],{}).update({int(k):tuple(v) for k,v in p[1].items()})
def ptrs(v,at,out,depth=0):
    out.append(at)
    if depth>12: return
    if isinstance(v,dict):
        for k,w in v.items():
            if k in('any','items','members','exact','json','beginning','$any','$json','$exact') or k.startswith('$'):
                ptrs(w,at,out,depth+1)
                if isinstance(w,list):
                    for a in w: ptrs(a,at,out,depth+1)
            else: ptrs(w,at+'/'+k.replace('~','~0').replace('/','~1'),out,depth+1)
    elif isinstance(v,list):
        for i,w in enumerate(v[:200]): ptrs(w,at+'/'+str(i),out,depth+1)
_pc={}
def cand(c):
    if c['id'] in _pc: return _pc[c['id']]
    out=['']
    e=c['expect']
    if isinstance(e,dict):
        for k in('value','columns'):
            if k in e: ptrs(e[k],'',out)
        t=e.get('text')
        if isinstance(t,str):
            try: ptrs(json.loads(t),'',out)
            except Exception: pass
        out+=['/text','/block']
    # extra: all members of message known
    extra=[]
    for p in list(out):
        for n in ('error','channels','mode','seq','t','ttl_ms','horizon','frame_id','horizon_dt_ms','values','unit','data','ok','unsupported'): extra.append(p+'/'+n)
    out=list(dict.fromkeys(out+extra)); _pc[c['id']]=out
    return out
def stepof(p):
    for t in p.split('/'):
        if t.isdigit(): return min(int(t)+1,255)
    return 0
_h={}
def h8(s):
    if s not in _h: _h[s]=fnv(s.encode())&0xff
    return _h[s]
def byat(c,place):
    toks=place.split('/')
    best=None
    for at,r in c.get('by',{}).items():
        if not at.startswith('/'): continue
        a=at.split('/')
        if len(a)<=len(toks) and all(w=='*' or w==t for w,t in zip(a,toks)):
            if best is None or len(a)>=best[0]: best=(len(a),r)
    if best: return best[1]
    if place and 'within' in c.get('by',{}): return c['by']['within']
def symptoms(c,s):
    step,pl,val=s
    res=[]
    for kind in('crash','timeout','protocol','acceptance'):
        if (0,h8(kind+' '))==(step,pl) and val==(fnv(b'')&0xffff): res.append((kind,''))
    for p in cand(c):
        if stepof(p)!=step: continue
        for kind in('value','crash','refusal','order'):
            if h8(kind+' '+p)==pl and (kind=='value' or val==(fnv(b'')&0xffff)): 
                if (kind,p) not in res: res.append((kind,p))
    return res
def charge1(c,k,p):
    by=c.get('by',{})
    r={'crash':by.get('crash'),'timeout':by.get('crash'),'protocol':by.get('crash'),'refusal':by.get('refusal'),'order':by.get('order')}.get(k)
    return r or byat(c,p) or c['requirements'][0]
def rulings(m,named):
    """id -> (charged, [(kind,place)], via)"""
    alone={}
    for k,s in fails[m].items():
        c=bykey.get(k)
        if not c: continue
        sy=symptoms(c,s)
        if not sy:
            # by prefix step only
            sy=[('value','/steps/%d'%(s[0]-1))] if s[0] and 'steps' in json.dumps(c['expect']) else [('value','?')]
        opts={}
        for k2,p in sy: opts.setdefault(charge1(c,k2,p),[]).append((k2,p))
        alone[c['id']]=opts
    pick={i:next((r for r in o if r in named),next(iter(o))) for i,o in alone.items()}
    memo={}
    def found(i,seen=()):
        if i in memo: return memo[i]
        r=None
        for b in cases[i].get('rests_on',[]):
            if b in pick:
                r=found(b) or (pick[b],b); break
        memo[i]=r; return r
    out={}
    for i in pick:
        f=found(i)
        if f: out[i]=(f[0],alone[i],f[1])
        else: out[i]=(pick[i],alone[i],None)
    return out
