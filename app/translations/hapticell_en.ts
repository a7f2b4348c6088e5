<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- SPDX-License-Identifier: Apache-2.0 -->
<TS version="2.1" language="en_GB">
<context>
    <name>HaptiCell</name>
    <message numerus="yes">
        <source>  ·  preparing %n parts</source>
        <translation><numerusform>·  preparing %n part</numerusform><numerusform>·  preparing %n parts</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%1 in %n frames</source>
        <translation><numerusform>%1 in %n frame</numerusform><numerusform>%1 in %n frames</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n action(s) written as a script: %1</source>
        <translation><numerusform>%n action written as a script: %1</numerusform><numerusform>%n actions written as a script: %1</numerusform></translation>
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
        <source>%n entities in the cell.</source>
        <translation><numerusform>%n entity in the cell.</numerusform><numerusform>%n entities in the cell.</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n frames</source>
        <translation><numerusform>%n frame</numerusform><numerusform>%n frames</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n joints</source>
        <translation><numerusform>%n joint</numerusform><numerusform>%n joints</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n limits reached.</source>
        <translation><numerusform>%n limit reached.</numerusform><numerusform>%n limits reached.</numerusform></translation>
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
        <source>%n robots</source>
        <translation><numerusform>%n robot</numerusform><numerusform>%n robots</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n selected</source>
        <translation><numerusform>%n selected</numerusform><numerusform>%n selected</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n solids</source>
        <translation><numerusform>%n solid</numerusform><numerusform>%n solids</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation><numerusform>%n value</numerusform><numerusform>%n values</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n variant(s)</source>
        <translation><numerusform>%n variant</numerusform><numerusform>%n variants</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>Move %n entities</source>
        <translation><numerusform>Move %n entity</numerusform><numerusform>Move %n entities</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>Rotate %n entities</source>
        <translation><numerusform>Rotate %n entity</numerusform><numerusform>Rotate %n entities</numerusform></translation>
    </message>
</context>
</TS>
