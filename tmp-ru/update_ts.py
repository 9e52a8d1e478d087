#!/usr/bin/env python3
"""update_ts.py TREE NAME: runs lupdate over TREE (both .ts files) and fills unfinished entries from
/tmp/ru/NAME.json: {"source or Context|source": "перевод"} and for %n texts
{"source": [["en one","en many"],["ru 1","ru 2","ru 5"]]}. Prints what is still missing."""
import glob,json,subprocess,sys
import xml.etree.ElementTree as ET
tree,name=sys.argv[1],sys.argv[2]
words={}
for n in name.split(','):
    words.update(json.load(open(f'/tmp/ru/{n}.json')))
src=[f for pat in('core/**/*.cpp','core/**/*.h','ui/**/*.cpp','ui/**/*.h') for f in glob.glob(f'{tree}/{pat}',recursive=True)]+[f'{tree}/app/main.cpp']
missing=0
for lang in('ru','en'):
    p=f'{tree}/translations/sparkout_{lang}.ts'
    subprocess.run(['/usr/lib/qt6/bin/lupdate','-silent','-no-obsolete','-locations','none','-tr-function-alias','QT_TRANSLATE_NOOP+=SPARKOUT_NOOP','-I',tree]+(['-pluralonly'] if lang=='en' else [])+src+['-ts',p],check=True,stderr=subprocess.DEVNULL)
    r=ET.parse(p).getroot()
    for c in r.findall('context'):
        ctx=c.find('name').text
        for m in c.findall('message'):
            s=m.find('source').text; tr=m.find('translation')
            if tr.get('type')!='unfinished': continue
            v=words.get(f'{ctx}|{s}',words.get(s))
            if v is None: print('missing',lang,ctx,repr(s)); missing+=1; continue
            if m.get('numerus'):
                for x in list(tr): tr.remove(x)
                for f in v[0 if lang=='en' else 1]:
                    e=ET.SubElement(tr,'numerusform'); e.text=f
            else: tr.text=v
            tr.attrib.pop('type',None)
    ET.indent(r,'    ')
    open(p,'w').write('<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n'+ET.tostring(r,encoding='unicode')+'\n')
print('missing:',missing)
