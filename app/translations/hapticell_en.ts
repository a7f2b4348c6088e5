<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- SPDX-License-Identifier: Apache-2.0 -->
<TS version="2.1" language="en_GB">
<context>
    <name>HaptiCell</name>
    <message numerus="yes">
        <source>  ·  %n parts are made ready</source>
        <translation><numerusform>  ·  %n part is made ready</numerusform><numerusform>  ·  %n parts are made ready</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%1 s · %n frame(s)</source>
        <translation><numerusform>%1 s · %n frame</numerusform><numerusform>%1 s · %n frames</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%1 · %n run(s) · next help %2 %</source>
        <translation><numerusform>%1 · %n run · next help %2 %</numerusform><numerusform>%1 · %n runs · next help %2 %</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%1: %n motion(s) made; the recording is as it was</source>
        <translation><numerusform>%1: %n motion made; the recording is as it was</numerusform><numerusform>%1: %n motions made; the recording is as it was</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n are hidden.</source>
        <translation><numerusform>%n is hidden.</numerusform><numerusform>%n are hidden.</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n are locked.</source>
        <translation><numerusform>%n is locked.</numerusform><numerusform>%n are locked.</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n assemblies</source>
        <translation><numerusform>%n assembly</numerusform><numerusform>%n assemblies</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n contact(s)</source>
        <translation><numerusform>%n contact</numerusform><numerusform>%n contacts</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n contact(s) felt</source>
        <translation><numerusform>%n contact felt</numerusform><numerusform>%n contacts felt</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n entities in the cell.</source>
        <translation><numerusform>%n entity in the cell.</numerusform><numerusform>%n entities in the cell.</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <translation><numerusform>%n frame</numerusform><numerusform>%n frames</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) recorded</source>
        <translation><numerusform>%n frame recorded</numerusform><numerusform>%n frames recorded</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s)</source>
        <translation><numerusform>%n joint</numerusform><numerusform>%n joints</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n joints</source>
        <translation><numerusform>%n joint</numerusform><numerusform>%n joints</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n limit(s) passed</source>
        <translation><numerusform>%n limit passed</numerusform><numerusform>%n limits passed</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n limits push back.</source>
        <translation><numerusform>%n limit pushes back.</numerusform><numerusform>%n limits push back.</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n mannequins</source>
        <translation><numerusform>%n mannequin</numerusform><numerusform>%n mannequins</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n mechanisms</source>
        <translation><numerusform>%n mechanism</numerusform><numerusform>%n mechanisms</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n motion(s) imported</source>
        <translation><numerusform>%n motion imported</numerusform><numerusform>%n motions imported</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n robots</source>
        <translation><numerusform>%n robot</numerusform><numerusform>%n robots</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n run(s), the last with %1 points</source>
        <translation><numerusform>%n run, the last with %1 points</numerusform><numerusform>%n runs, the last with %1 points</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n selected</source>
        <translation><numerusform>%n selected</numerusform><numerusform>%n selected</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n singular place(s) or change(s) of configuration</source>
        <translation><numerusform>%n singular place or change of configuration</numerusform><numerusform>%n singular places or changes of configuration</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n solids</source>
        <translation><numerusform>%n solid</numerusform><numerusform>%n solids</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>Import %n motion(s)</source>
        <translation><numerusform>Import %n motion</numerusform><numerusform>Import %n motions</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>Last run: %1 points. %2 s (expert %3 s), %4 mm off the path, at most %5 N, %n contact(s), smoothness %6 (expert %7).</source>
        <translation><numerusform>Last run: %1 points. %2 s (expert %3 s), %4 mm off the path, at most %5 N, %n contact, smoothness %6 (expert %7).</numerusform><numerusform>Last run: %1 points. %2 s (expert %3 s), %4 mm off the path, at most %5 N, %n contacts, smoothness %6 (expert %7).</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>Move %n entities</source>
        <translation><numerusform>Move %n entity</numerusform><numerusform>Move %n entities</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>Turn %n entities</source>
        <translation><numerusform>Turn %n entity</numerusform><numerusform>Turn %n entities</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>Written: %1 (%n frame(s)). Tool, base and safety are the controller's own: check them there</source>
        <translation><numerusform>Written: %1 (%n frame). Tool, base and safety are the controller's own: check them there</numerusform><numerusform>Written: %1 (%n frames). Tool, base and safety are the controller's own: check them there</numerusform></translation>
    </message>
</context>
</TS>
