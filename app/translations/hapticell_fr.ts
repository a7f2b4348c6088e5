<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- SPDX-License-Identifier: Apache-2.0 -->
<TS version="2.1" language="fr_FR">
<context>
    <name>HaptiCell</name>
    <message>
        <source>  (in use)</source>
        <translation>  (utilisée)</translation>
    </message>
    <message>
        <source>  (yours)</source>
        <translation>  (la vôtre)</translation>
    </message>
    <message numerus="yes">
        <source>  ·  %n parts are made ready</source>
        <translation><numerusform>  ·  %n pièce est préparée</numerusform><numerusform>  ·  %n pièces sont préparées</numerusform></translation>
    </message>
    <message>
        <source>  ·  Simplified while moving</source>
        <translation>  ·  Simplifié pendant le mouvement</translation>
    </message>
    <message>
        <source> and %1 more</source>
        <translation> et %1 de plus</translation>
    </message>
    <message>
        <source> and pushes back</source>
        <translation> et repousse</translation>
    </message>
    <message>
        <source> and pushes back on the stylus.</source>
        <translation> et repousse le stylet.</translation>
    </message>
    <message>
        <source> in degrees</source>
        <translation> en degrés</translation>
    </message>
    <message>
        <source> in millimetres</source>
        <translation> en millimètres</translation>
    </message>
    <message>
        <source> or </source>
        <translation> ou </translation>
    </message>
    <message>
        <source> · %1 by hand</source>
        <translation> · %1 à la main</translation>
    </message>
    <message>
        <source> · %1 left</source>
        <translation> · reste %1</translation>
    </message>
    <message>
        <source> · Esc: end</source>
        <translation> · Échap : terminer</translation>
    </message>
    <message>
        <source> · forces lost</source>
        <translation> · forces perdues</translation>
    </message>
    <message>
        <source> · forces off</source>
        <translation> · efforts coupés</translation>
    </message>
    <message>
        <source> · forces on</source>
        <translation> · efforts en marche</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 % at 5–7</source>
        <translation>%1 % à 5–7</translation>
    </message>
    <message>
        <source>%1 % of the joints</source>
        <translation>%1 % des articulations</translation>
    </message>
    <message>
        <source>%1 % of the limits</source>
        <translation>%1 % des limites</translation>
    </message>
    <message>
        <source>%1 % of the way</source>
        <translation>%1 % du chemin</translation>
    </message>
    <message>
        <source>%1 %2, %3 triangles. One unit of the file is one %4%5.</source>
        <translation>%1 %2, %3 triangles. Une unité du fichier vaut un %4%5.</translation>
    </message>
    <message>
        <source>%1 %2, %3 – %4</source>
        <translation>%1 %2, %3 – %4</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (%2 à %3)</translation>
    </message>
    <message>
        <source>%1 (not usable)</source>
        <translation>%1 (inutilisable)</translation>
    </message>
    <message>
        <source>%1 (unplugged)</source>
        <translation>%1 (débranché)</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>%1 Hz, late %2 ms</source>
        <translation>%1 Hz, retard %2 ms</translation>
    </message>
    <message>
        <source>%1 Hz, late %2 ms at most in 99 of 100 steps%3</source>
        <translation>%1 Hz, retard d'au plus %2 ms pour 99 pas sur 100%3</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>%1 N at %2 s</source>
        <translation>%1 N à %2 s</translation>
    </message>
    <message>
        <source>%1 N m</source>
        <translation>%1 N m</translation>
    </message>
    <message>
        <source>%1 N were commanded. If nothing was felt: is the device's power on, is its emergency stop released, is it calibrated?</source>
        <translation>%1 N ont été commandés. Si rien n'a été senti : le périphérique est-il sous tension, son arrêt d'urgence relâché, est-il étalonné ?</translation>
    </message>
    <message>
        <source>%1 a step down</source>
        <translation>%1 un pas de moins</translation>
    </message>
    <message>
        <source>%1 a step up</source>
        <translation>%1 un pas de plus</translation>
    </message>
    <message>
        <source>%1 acts while the pointer is over the scene</source>
        <translation>%1 agit tant que le pointeur est sur la scène</translation>
    </message>
    <message>
        <source>%1 against %2: the meshes are too dense there to tell all contacts, so only the nearest point of each pair is felt</source>
        <translation>%1 contre %2 : les maillages y sont trop denses pour tous les contacts ; seul le point le plus proche de chaque paire est senti</translation>
    </message>
    <message>
        <source>%1 already exists.
Do you want to replace it?</source>
        <translation>%1 existe déjà.
Voulez-vous le remplacer ?</translation>
    </message>
    <message>
        <source>%1 and %2 in all</source>
        <translation>%1 et %2 au total</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 et %2 de plus</translation>
    </message>
    <message>
        <source>%1 and %2 more: triangles face inward; they count as facing outward</source>
        <translation>%1 et %2 de plus : des triangles sont tournés vers l'intérieur ; ils comptent comme tournés vers l'extérieur</translation>
    </message>
    <message>
        <source>%1 answers at %2.</source>
        <translation>%1 répond à %2.</translation>
    </message>
    <message>
        <source>%1 cannot be a part of it</source>
        <translation>%1 ne peut pas en faire partie</translation>
    </message>
    <message>
        <source>%1 cannot be made of that</source>
        <translation>%1 ne peut pas être fait de cela</translation>
    </message>
    <message>
        <source>%1 cat. %2</source>
        <translation>%1 cat. %2</translation>
    </message>
    <message>
        <source>%1 changed on disk</source>
        <translation>%1 a changé sur le disque</translation>
    </message>
    <message>
        <source>%1 continuous</source>
        <translation>%1 en continu</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>%1 copie</translation>
    </message>
    <message>
        <source>%1 d</source>
        <translation>%1 j</translation>
    </message>
    <message>
        <source>%1 does not go along with %2: %3</source>
        <translation>%1 n'accompagne pas %2 : %3</translation>
    </message>
    <message>
        <source>%1 edges of more than two faces</source>
        <translation>%1 arêtes de plus de deux faces</translation>
    </message>
    <message>
        <source>%1 edges whose faces look opposite ways</source>
        <translation>%1 arêtes dont les faces sont opposées</translation>
    </message>
    <message>
        <source>%1 faces were turned outwards.</source>
        <translation>%1 faces ont été tournées vers l'extérieur.</translation>
    </message>
    <message>
        <source>%1 files lie outside of the workcell's folder. Pack them too?</source>
        <translation>%1 fichiers se trouvent hors du dossier de la cellule. Les archiver aussi ?</translation>
    </message>
    <message>
        <source>%1 files of this cell are missing</source>
        <translation>%1 fichiers de cette cellule manquent</translation>
    </message>
    <message>
        <source>%1 gives %2.</source>
        <translation>%1 donne %2.</translation>
    </message>
    <message>
        <source>%1 goes along</source>
        <translation>%1 suit</translation>
    </message>
    <message>
        <source>%1 goes to %2</source>
        <translation>%1 va à %2</translation>
    </message>
    <message>
        <source>%1 goes with %2, which the other stylus holds</source>
        <translation>%1 va avec %2, que tient l'autre stylet</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>%1 has been plugged in</source>
        <translation>%1 vient d'être branché</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved.</source>
        <translation>%1 a des changements non enregistrés.</translation>
    </message>
    <message>
        <source>%1 has more frames than rows here: simplify it, then reorder its points.</source>
        <translation>%1 a plus d'images que de lignes ici : simplifiez-le, puis réordonnez ses points.</translation>
    </message>
    <message>
        <source>%1 has unsaved work from before a crash</source>
        <translation>%1 a du travail non enregistré d’avant un plantage</translation>
    </message>
    <message numerus="yes">
        <source>%1 in %n frames</source>
        <translation><numerusform>%1 sur %n image</numerusform><numerusform>%1 sur %n images</numerusform></translation>
    </message>
    <message>
        <source>%1 in all</source>
        <translation>%1 au total</translation>
    </message>
    <message>
        <source>%1 is %2 beyond its end</source>
        <translation>%1 est %2 au-delà de sa butée</translation>
    </message>
    <message>
        <source>%1 is %2 from %3</source>
        <translation>%1 est à %2 de %3</translation>
    </message>
    <message>
        <source>%1 is %2 from %3: a near miss.</source>
        <translation>%1 est à %2 de %3 : quasi-contact.</translation>
    </message>
    <message>
        <source>%1 is %2 from its limit</source>
        <translation>%1 est à %2 de sa butée</translation>
    </message>
    <message>
        <source>%1 is %2 from its lower limit</source>
        <translation>%1 est à %2 de sa butée inférieure</translation>
    </message>
    <message>
        <source>%1 is %2 from its upper limit</source>
        <translation>%1 est à %2 de sa butée supérieure</translation>
    </message>
    <message>
        <source>%1 is %2, limit %3</source>
        <translation>%1 est à %2, limite %3</translation>
    </message>
    <message>
        <source>%1 is as it was</source>
        <translation>%1 est comme avant</translation>
    </message>
    <message>
        <source>%1 is at its lower limit</source>
        <translation>%1 est à sa butée inférieure</translation>
    </message>
    <message>
        <source>%1 is at its upper limit</source>
        <translation>%1 est à sa butée supérieure</translation>
    </message>
    <message>
        <source>%1 is free</source>
        <translation>%1 est libre</translation>
    </message>
    <message>
        <source>%1 is held by the other stylus</source>
        <translation>%1 est tenu par l'autre stylet</translation>
    </message>
    <message>
        <source>%1 is in the cell</source>
        <translation>%1 est dans la cellule</translation>
    </message>
    <message>
        <source>%1 is kept</source>
        <translation>%1 est gardée</translation>
    </message>
    <message>
        <source>%1 is known</source>
        <translation>%1 est connu</translation>
    </message>
    <message>
        <source>%1 is near %2 of %3</source>
        <translation>%1 est près de %2 de %3</translation>
    </message>
    <message>
        <source>%1 is near a position where nothing holds it</source>
        <translation>%1 est près d'une position où rien ne le retient</translation>
    </message>
    <message>
        <source>%1 is no picture that can be read. Choose a PNG, JPEG or SVG file; the report stays as it was.</source>
        <translation>%1 n'est pas une image lisible. Choisissez un fichier PNG, JPEG ou SVG ; le rapport reste comme il était.</translation>
    </message>
    <message>
        <source>%1 is not there or may not be run.</source>
        <translation>%1 n'est pas là ou ne peut pas être lancé.</translation>
    </message>
    <message>
        <source>%1 is open elsewhere</source>
        <translation>%1 est ouvert ailleurs</translation>
    </message>
    <message>
        <source>%1 is out of reach</source>
        <translation>%1 est hors d'atteinte</translation>
    </message>
    <message>
        <source>%1 is saved</source>
        <translation>%1 est enregistré</translation>
    </message>
    <message>
        <source>%1 is used, but only until the end of the program.</source>
        <translation>%1 est utilisé, mais seulement jusqu'à la fin du programme.</translation>
    </message>
    <message>
        <source>%1 is written</source>
        <translation>%1 est écrit</translation>
    </message>
    <message>
        <source>%1 kg</source>
        <translation>%1 kg</translation>
    </message>
    <message>
        <source>%1 late and %2 refused since the server's start</source>
        <translation>%1 en retard, %2 refusés depuis le démarrage</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>reste %1</translation>
    </message>
    <message>
        <source>%1 long</source>
        <translation>Longueur %1</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1 may hold the work of others.</source>
        <translation>%1 contient peut-être le travail d’autrui.</translation>
    </message>
    <message>
        <source>%1 meets %2</source>
        <translation>%1 rencontre %2</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 mm in front of the flange. Change it in the Robot dock, or undo the insertion.</source>
        <translation>À %1 mm devant la bride. Changez-le dans le panneau Robot, ou annulez l'insertion.</translation>
    </message>
    <message>
        <source>%1 mm&lt;br&gt;%2°</source>
        <translation>%1 mm&lt;br&gt;%2°</translation>
    </message>
    <message>
        <source>%1 moved, %2 added, %3 removed. Places: X Y Z in mm, A B C in degrees about z, y, x.</source>
        <translation>%1 déplacés, %2 ajoutés, %3 retirés. Places : X Y Z en mm, A B C en degrés autour de z, y, x.</translation>
    </message>
    <message>
        <source>%1 moves as fast as it can</source>
        <translation>%1 va aussi vite qu'il le peut</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 ms after they are felt in the middle, %2 ms at most, of %3; %4 ms go unnoticed</source>
        <translation>%1 ms après le ressenti au milieu, %2 ms au plus, sur %3 ; %4 ms passent inaperçues</translation>
    </message>
    <message>
        <source>%1 ms old in the middle, %2 ms in 99 of 100; %3</source>
        <translation>%1 ms d'âge médian, %2 ms pour 99 sur 100 ; %3</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>%1 of %2 frames; at most %3 from the recording</source>
        <translation>%1 images sur %2 ; au plus %3 de l'enregistrement</translation>
    </message>
    <message>
        <source>%1 of %2 solutions inside the limits</source>
        <translation>%1 solutions sur %2 dans les butées</translation>
    </message>
    <message>
        <source>%1 of %2 triangles are left, off the surface by at most %3.</source>
        <translation>Il reste %1 triangles sur %2, à %3 au plus de la surface.</translation>
    </message>
    <message>
        <source>%1 of %2:  %3</source>
        <translation>%1 de %2 :  %3</translation>
    </message>
    <message>
        <source>%1 of hand → %2 in the cell</source>
        <translation>%1 de main → %2 dans la cellule</translation>
    </message>
    <message>
        <source>%1 of many, nearest first</source>
        <translation>%1 parmi beaucoup, les plus proches d'abord</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>%1 on %2 has had it open since %3.</source>
        <translation>%1 sur %2 l’a ouvert depuis le %3.</translation>
    </message>
    <message>
        <source>%1 open edges</source>
        <translation>%1 arêtes ouvertes</translation>
    </message>
    <message>
        <source>%1 over by %2</source>
        <translation>%1 trop loin de %2</translation>
    </message>
    <message>
        <source>%1 pairs touch as the cell stands: %2. Leave them out of the check?</source>
        <translation>%1 paires se touchent dans la cellule au repos : %2. Les écarter de la vérification ?</translation>
    </message>
    <message>
        <source>%1 peak</source>
        <translation>%1 crête</translation>
    </message>
    <message>
        <source>%1 points; %2 are needed and the whole way</source>
        <translation>%1 points ; il en faut %2 et tout le chemin</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 s  %2</source>
        <translation>%1 s  %2</translation>
    </message>
    <message>
        <source>%1 s · frames: %2</source>
        <translation>%1 s · images : %2</translation>
    </message>
    <message>
        <source>%1 s → %2 s; at most %3 from the path</source>
        <translation>%1 s → %2 s ; au plus %3 du chemin</translation>
    </message>
    <message>
        <source>%1 s, %2 of %3 markers seen</source>
        <translation>%1 s, %2 marqueurs vus sur %3</translation>
    </message>
    <message>
        <source>%1 s, RULA %2 · worst phase %3 s to %4 s, RULA %5</source>
        <translation>%1 s, RULA %2 · pire phase de %3 s à %4 s, RULA %5</translation>
    </message>
    <message>
        <source>%1 short</source>
        <translation>manque %1</translation>
    </message>
    <message>
        <source>%1 sits on %2</source>
        <translation>%1 s'assied sur %2</translation>
    </message>
    <message>
        <source>%1 starts inside %2 and no straight way out was found; it is not held back by it until they are apart</source>
        <translation>%1 commence à l'intérieur de %2, sans sortie en ligne droite ; il n'est pas retenu tant qu'ils ne sont pas séparés</translation>
    </message>
    <message>
        <source>%1 starts inside %2, %3 deep: it comes free along %4</source>
        <translation>%1 commence à l'intérieur de %2, à %3 de profondeur : il se dégage selon %4</translation>
    </message>
    <message>
        <source>%1 starts inside %2, %3 deep: it comes free along %4 (an open mesh: told by its winding number)</source>
        <translation>%1 commence à l'intérieur de %2, à %3 de profondeur : il se dégage selon %4 (maillage ouvert : d'après son indice d'enroulement)</translation>
    </message>
    <message>
        <source>%1 takes configuration %2</source>
        <translation>%1 prend la configuration %2</translation>
    </message>
    <message>
        <source>%1 times, last %2</source>
        <translation>%1 fois, dernière à %2</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>%1 to %2, being measured</source>
        <translation>%1 à %2, mesure en cours</translation>
    </message>
    <message>
        <source>%1 to the edge</source>
        <translation>%1 jusqu'au bord</translation>
    </message>
    <message>
        <source>%1 to the edge of the workspace</source>
        <translation>%1 jusqu'au bord de l'espace de travail</translation>
    </message>
    <message>
        <source>%1 to the flange</source>
        <translation>%1 jusqu'à la bride</translation>
    </message>
    <message>
        <source>%1 took the stylus.</source>
        <translation>%1 a pris le stylet.</translation>
    </message>
    <message>
        <source>%1 touches %2</source>
        <translation>%1 touche %2</translation>
    </message>
    <message>
        <source>%1 touches %2 of %3</source>
        <translation>%1 touche %2 de %3</translation>
    </message>
    <message>
        <source>%1 touches %2.</source>
        <translation>%1 touche %2.</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 triangles</translation>
    </message>
    <message>
        <source>%1 triangles, off the mesh by at most %2</source>
        <translation>%1 triangles, à %2 au plus du maillage</translation>
    </message>
    <message>
        <source>%1 up, %2 away, %3: </source>
        <translation>%1 plus haut, %2 plus loin, %3 : </translation>
    </message>
    <message>
        <source>%1 was changed meanwhile: nothing was done</source>
        <translation>%1 a été modifié entre-temps : rien n'a été fait</translation>
    </message>
    <message>
        <source>%1 was not added</source>
        <translation>%1 n'a pas été ajouté</translation>
    </message>
    <message>
        <source>%1 was not opened</source>
        <translation>%1 n'a pas été ouvert</translation>
    </message>
    <message>
        <source>%1 was not read again</source>
        <translation>%1 n'a pas été relu</translation>
    </message>
    <message>
        <source>%1 was not written</source>
        <translation>%1 n'a pas été écrit</translation>
    </message>
    <message>
        <source>%1 was read with remarks</source>
        <translation>%1 a été lu avec des remarques</translation>
    </message>
    <message>
        <source>%1 was written with remarks</source>
        <translation>%1 a été écrit avec des remarques</translation>
    </message>
    <message>
        <source>%1 would be %2 over its upper limit</source>
        <translation>%1 dépasserait de %2 sa butée supérieure</translation>
    </message>
    <message>
        <source>%1 would be %2 under its lower limit</source>
        <translation>%1 dépasserait de %2 sa butée inférieure</translation>
    </message>
    <message>
        <source>%1 would have to go %2/s faster than it can</source>
        <translation>%1 devrait aller %2/s plus vite qu'il ne peut</translation>
    </message>
    <message>
        <source>%1 would touch %2</source>
        <translation>%1 toucherait %2</translation>
    </message>
    <message>
        <source>%1 would touch %2 after %3 % of the way</source>
        <translation>%1 toucherait %2 après %3 % du chemin</translation>
    </message>
    <message>
        <source>%1 would touch its own %2</source>
        <translation>%1 toucherait son propre %2</translation>
    </message>
    <message>
        <source>%1 would touch its own %2 after %3 % of the way</source>
        <translation>%1 toucherait son propre %2 après %3 % du chemin</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 · %2 s</source>
        <translation>%1 · %2 s</translation>
    </message>
    <message>
        <source>%1 · %2 · %3 points</source>
        <translation>%1 · %2 · %3 points</translation>
    </message>
    <message>
        <source>%1 · Esc: end</source>
        <translation>%1 · Échap : terminer</translation>
    </message>
    <message>
        <source>%1 · no shape</source>
        <translation>%1 · sans forme</translation>
    </message>
    <message>
        <source>%1 · runs: %3 · next help %2 %</source>
        <translation>%1 · essais : %3 · aide suivante %2 %</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>%1 × %2 × %3, %4 N peak, %5 N continuous, %6 measured and %7 driven axes</source>
        <translation>%1 × %2 × %3, crête %4 N, %5 N en continu, %6 axes mesurés et %7 motorisés</translation>
    </message>
    <message>
        <source>%1 × %2 × %3, unit not known</source>
        <translation>%1 × %2 × %3, unité inconnue</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>%1%2 through %3, %4, %5</source>
        <translation>%1%2 par %3, %4, %5</translation>
    </message>
    <message>
        <source>%1%2 triangles</source>
        <translation>%1%2 triangles</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1, %2 to %3</source>
        <translation>%1, de %2 à %3</translation>
    </message>
    <message>
        <source>%1, %2, %3 through %4, %5, %6</source>
        <translation>%1, %2, %3 par %4, %5, %6</translation>
    </message>
    <message>
        <source>%1, as the file says</source>
        <translation>%1, comme le dit le fichier</translation>
    </message>
    <message>
        <source>%1, heaviest class</source>
        <translation>%1, classe la plus lourde</translation>
    </message>
    <message>
        <source>%1, least distance</source>
        <translation>%1, distance minimale</translation>
    </message>
    <message>
        <source>%1, left</source>
        <translation>%1, gauche</translation>
    </message>
    <message>
        <source>%1, not calibrated for you</source>
        <translation>%1, pas étalonné pour vous</translation>
    </message>
    <message>
        <source>%1, off what was asked</source>
        <translation>%1, hors de ce qui était demandé</translation>
    </message>
    <message>
        <source>%1, right</source>
        <translation>%1, droite</translation>
    </message>
    <message>
        <source>%1, round trip %2 ms</source>
        <translation>%1, aller-retour %2 ms</translation>
    </message>
    <message>
        <source>%1, undone</source>
        <translation>%1, annulé</translation>
    </message>
    <message>
        <source>%1, which the other stylus holds, goes with %2</source>
        <translation>%1, que tient l'autre stylet, va avec %2</translation>
    </message>
    <message>
        <source>%1, µ %2</source>
        <translation>%1, µ %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>%1: %2 % seen, %3 away, %4</source>
        <translation>%1 : vu à %2 %, à %3, %4</translation>
    </message>
    <message>
        <source>%1: %2 is in the way, %3 short of the target</source>
        <translation>%1 : %2 fait obstacle, il manque %3 jusqu'à la cible</translation>
    </message>
    <message>
        <source>%1: %2 markers, %3 s at %4 Hz</source>
        <translation>%1 : %2 marqueurs, %3 s à %4 Hz</translation>
    </message>
    <message>
        <source>%1: %2 on %3</source>
        <translation>%1 : %2 sur %3</translation>
    </message>
    <message>
        <source>%1: %2 short of the target</source>
        <translation>%1 : il manque %2 jusqu'à la cible</translation>
    </message>
    <message>
        <source>%1: %2° to %3°, comfortable %4° to %5°</source>
        <translation>%1 : %2° à %3°, confortable %4° à %5°</translation>
    </message>
    <message>
        <source>%1: at least %2 mm</source>
        <translation>%1 : au moins %2 mm</translation>
    </message>
    <message>
        <source>%1: changed, takes effect at the next start.</source>
        <translation>%1 : changé, vaut au prochain démarrage.</translation>
    </message>
    <message>
        <source>%1: damping</source>
        <translation>%1 : amortissement</translation>
    </message>
    <message>
        <source>%1: friction</source>
        <translation>%1 : frottement</translation>
    </message>
    <message>
        <source>%1: one lies inside the other</source>
        <translation>%1 : l'une est à l'intérieur de l'autre</translation>
    </message>
    <message>
        <source>%1: one of them has no shape to measure.</source>
        <translation>%1 : l'une d'elles n'a pas de forme à mesurer.</translation>
    </message>
    <message>
        <source>%1: stiffness</source>
        <translation>%1 : raideur</translation>
    </message>
    <message>
        <source>%1: the body itself is in the way, %2 short of the target</source>
        <translation>%1 : le corps lui-même fait obstacle, il manque %2 jusqu'à la cible</translation>
    </message>
    <message>
        <source>%1: the nearest that %2 comes to is %3 away.</source>
        <translation>%1 : %2 n'approche qu'à %3.</translation>
    </message>
    <message>
        <source>%1: they touch or cut each other</source>
        <translation>%1 : elles se touchent ou se coupent</translation>
    </message>
    <message>
        <source>%1: triangles face inward; they count as facing outward</source>
        <translation>%1 : des triangles sont tournés vers l'intérieur ; ils comptent comme tournés vers l'extérieur</translation>
    </message>
    <message>
        <source>%1: why %2, and what brings it down</source>
        <translation>%1 : pourquoi %2, et ce qui l'abaisse</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1° · %2</source>
        <translation>%1° · %2</translation>
    </message>
    <message numerus="yes">
        <source>%n are hidden.</source>
        <translation><numerusform>%n est cachée.</numerusform><numerusform>%n sont cachées.</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n are locked.</source>
        <translation><numerusform>%n est verrouillée.</numerusform><numerusform>%n sont verrouillées.</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n assemblies</source>
        <translation><numerusform>%n assemblage</numerusform><numerusform>%n assemblages</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n entities in the cell.</source>
        <translation><numerusform>%n entité dans la cellule.</numerusform><numerusform>%n entités dans la cellule.</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n frames</source>
        <translation><numerusform>%n repère</numerusform><numerusform>%n repères</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n joints</source>
        <translation><numerusform>%n articulation</numerusform><numerusform>%n articulations</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n limits push back.</source>
        <translation><numerusform>%n butée repousse.</numerusform><numerusform>%n butées repoussent.</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n mannequins</source>
        <translation><numerusform>%n mannequin</numerusform><numerusform>%n mannequins</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n mechanisms</source>
        <translation><numerusform>%n mécanisme</numerusform><numerusform>%n mécanismes</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n robots</source>
        <translation><numerusform>%n robot</numerusform><numerusform>%n robots</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n selected</source>
        <translation><numerusform>%n choisie</numerusform><numerusform>%n choisies</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n solids</source>
        <translation><numerusform>%n solide</numerusform><numerusform>%n solides</numerusform></translation>
    </message>
    <message>
        <source>&amp;Add to Custom Colors</source>
        <translation>&amp;Ajouter aux couleurs propres</translation>
    </message>
    <message>
        <source>&amp;Basic colors</source>
        <translation>Couleurs de &amp;base</translation>
    </message>
    <message>
        <source>&amp;Custom colors</source>
        <translation>Couleurs &amp;propres</translation>
    </message>
    <message>
        <source>&amp;Green:</source>
        <translation>&amp;Vert :</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Non</translation>
    </message>
    <message>
        <source>&amp;Pick Screen Color</source>
        <translation>Prendre une couleur à l'&amp;écran</translation>
    </message>
    <message>
        <source>&amp;Red:</source>
        <translation>&amp;Rouge :</translation>
    </message>
    <message>
        <source>&amp;Sat:</source>
        <translation>&amp;Sat. :</translation>
    </message>
    <message>
        <source>&amp;Val:</source>
        <translation>&amp;Val. :</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Oui</translation>
    </message>
    <message>
        <source>(open elsewhere)</source>
        <translation>(ouvert ailleurs)</translation>
    </message>
    <message>
        <source>, %1 clear</source>
        <translation>, %1 libres</translation>
    </message>
    <message>
        <source>, as it says</source>
        <translation>, comme il le dit</translation>
    </message>
    <message>
        <source>, at most %1</source>
        <translation>, au plus %1</translation>
    </message>
    <message>
        <source>, at most %1 min</source>
        <translation>, au plus %1 min</translation>
    </message>
    <message>
        <source>, by hand</source>
        <translation>, à la main</translation>
    </message>
    <message>
        <source>, centre %1 from %2</source>
        <translation>, centre à %1 de %2</translation>
    </message>
    <message>
        <source>, firmware %1</source>
        <translation>, micrologiciel %1</translation>
    </message>
    <message>
        <source>, guessed from the size</source>
        <translation>, déduit de la taille</translation>
    </message>
    <message>
        <source>, hidden by %1</source>
        <translation>, caché par %1</translation>
    </message>
    <message>
        <source>, its clock %1 from ours</source>
        <translation>, son horloge à %1 de la nôtre</translation>
    </message>
    <message>
        <source>, not seen: %1</source>
        <translation>, non vus : %1</translation>
    </message>
    <message>
        <source>, waits %1 s</source>
        <translation>, attend %1 s</translation>
    </message>
    <message>
        <source>, µ %1</source>
        <translation>, µ %1</translation>
    </message>
    <message>
        <source>-changes.pdf</source>
        <translation>-changements.pdf</translation>
    </message>
    <message>
        <source>.</source>
        <translation>.</translation>
    </message>
    <message>
        <source>. A smaller window helps</source>
        <translation>. Une fenêtre plus petite aide</translation>
    </message>
    <message>
        <source>. Kept nearer to the recording from %1 to %2 s</source>
        <translation>. Tenu plus près de l'enregistrement de %1 à %2 s</translation>
    </message>
    <message>
        <source>. Real-time priority mends it: add the account to the group realtime</source>
        <translation>. La priorité temps réel y remédie : ajoutez le compte au groupe realtime</translation>
    </message>
    <message>
        <source>. The hand's tremor (%1) is larger than the tolerance: much of it is kept</source>
        <translation>. Le tremblement de la main (%1) dépasse la tolérance : il en reste beaucoup</translation>
    </message>
    <message>
        <source>. The robot cannot reach all of it: up to %1 away</source>
        <translation>. Le robot ne peut pas tout atteindre : jusqu'à %1 d'écart</translation>
    </message>
    <message>
        <source>. Their parts are kept without a shape; the rest is here. Show a folder that holds them.</source>
        <translation>. Leurs pièces sont gardées sans forme ; le reste est là. Montrez un dossier qui les contient.</translation>
    </message>
    <message>
        <source>/min</source>
        <translation>/min</translation>
    </message>
    <message>
        <source>/s</source>
        <translation>/s</translation>
    </message>
    <message>
        <source>/s²</source>
        <translation>/s²</translation>
    </message>
    <message>
        <source>/s³</source>
        <translation>/s³</translation>
    </message>
    <message>
        <source>0 N</source>
        <translation>0 N</translation>
    </message>
    <message>
        <source>1 joint</source>
        <translation>1 articulation</translation>
    </message>
    <message>
        <source>1 joints</source>
        <translation>1 articulations</translation>
    </message>
    <message>
        <source>3-D mouse</source>
        <translation>Souris 3D</translation>
    </message>
    <message>
        <source>; it names none itself</source>
        <translation> ; il n'en nomme aucune</translation>
    </message>
    <message>
        <source>; limits used: speed %1 %, acceleration %2 %</source>
        <translation> ; limites employées : vitesse %1 %, accélération %2 %</translation>
    </message>
    <message>
        <source>&lt; P 1</source>
        <translation>&lt; P 1</translation>
    </message>
    <message>
        <source>&gt; P 99</source>
        <translation>&gt; P 99</translation>
    </message>
    <message>
        <source>?</source>
        <translation>?</translation>
    </message>
    <message>
        <source>A B C</source>
        <translation>A B C</translation>
    </message>
    <message>
        <source>A bore, a shaft, a straight or round edge, or the normal of a face</source>
        <translation>Un alésage, un arbre, une arête droite ou ronde, ou la normale d'une face</translation>
    </message>
    <message>
        <source>A built-in robot was left out</source>
        <translation>Un robot fourni a été laissé de côté</translation>
    </message>
    <message>
        <source>A car door on its hinge</source>
        <translation>Une portière sur sa charnière</translation>
    </message>
    <message>
        <source>A click of the left button still chooses; a box is drawn with Ctrl and the left button.</source>
        <translation>Un clic gauche choisit toujours ; un cadre se trace avec Ctrl et le bouton gauche.</translation>
    </message>
    <message>
        <source>A copy of the chosen one, or at the flange</source>
        <translation>Une copie de celui choisi, ou à la bride</translation>
    </message>
    <message>
        <source>A face, an edge or a corner: its origin and direction become the tool's</source>
        <translation>Une face, une arête ou un coin : son origine et sa direction deviennent celles de l'outil</translation>
    </message>
    <message>
        <source>A file of this cell is missing</source>
        <translation>Un fichier de cette cellule manque</translation>
    </message>
    <message>
        <source>A frame by</source>
        <translation>Une image par</translation>
    </message>
    <message>
        <source>A frame by hand at the cursor, to be dragged in the scene</source>
        <translation>Une image à la main au curseur, à tirer dans la scène</translation>
    </message>
    <message>
        <source>A frame of this solid on picked geometry</source>
        <translation>Un repère de ce solide sur la géométrie désignée</translation>
    </message>
    <message>
        <source>A guide holds what you move on a line, a plane, a hinge … Select an entity, choose a kind, then pick an edge or a face.</source>
        <translation>Un guide tient ce que vous déplacez sur une ligne, un plan, une charnière… Choisissez une entité, un genre, puis désignez une arête ou une face.</translation>
    </message>
    <message>
        <source>A hand by itself, each finger as the glove has it; the stylus carries it</source>
        <translation>Une main seule, chaque doigt comme dans le gant ; le stylet la porte</translation>
    </message>
    <message>
        <source>A joint lets one part move on another. Begin with New joint, or take a sample below.</source>
        <translation>Une articulation laisse une pièce bouger sur une autre. Commencez par Nouvelle articulation, ou prenez un exemple ci-dessous.</translation>
    </message>
    <message>
        <source>A joint limit is in the way</source>
        <translation>Une butée d'articulation gêne</translation>
    </message>
    <message>
        <source>A joint limit is in the way of this pose</source>
        <translation>Une butée d'articulation gêne cette pose</translation>
    </message>
    <message>
        <source>A method's limit is where its next class begins; moments hold the arms' own weight.</source>
        <translation>La limite d'une méthode est là où commence sa classe suivante ; les moments comprennent le poids des bras.</translation>
    </message>
    <message>
        <source>A new workcell</source>
        <translation>Une nouvelle cellule</translation>
    </message>
    <message>
        <source>A person at a bench</source>
        <translation>Une personne à un établi</translation>
    </message>
    <message>
        <source>A person's own measure goes before the most likely one of the survey (ANSUR II)</source>
        <translation>Une mesure propre passe avant la plus probable de l'enquête (ANSUR II)</translation>
    </message>
    <message>
        <source>A picture at the head of every report; none is chosen</source>
        <translation>Une image en tête de chaque rapport ; aucune n'est choisie</translation>
    </message>
    <message>
        <source>A point of the entity by which the hand holds it</source>
        <translation>Un point de l'entité par lequel la main la tient</translation>
    </message>
    <message>
        <source>A process point: the motion rests here so long</source>
        <translation>Un point de travail : le mouvement y reste ce temps</translation>
    </message>
    <message>
        <source>A robot near a singular position</source>
        <translation>Un robot près d'une singularité</translation>
    </message>
    <message>
        <source>A straight way after it</source>
        <translation>Une voie droite après</translation>
    </message>
    <message>
        <source>A straight way before it</source>
        <translation>Une voie droite avant</translation>
    </message>
    <message>
        <source>A table of the forces that a hand may exert, of your own source; none are shipped</source>
        <translation>Une table des efforts qu'une main peut exercer, de votre propre source ; aucune n'est fournie</translation>
    </message>
    <message>
        <source>A trajectory is not on disk</source>
        <translation>Une trajectoire n'est pas sur le disque</translation>
    </message>
    <message>
        <source>A trajectory of the cell cannot be read</source>
        <translation>Une trajectoire de la cellule ne peut pas être lue</translation>
    </message>
    <message>
        <source>A value is needed</source>
        <translation>Une valeur est nécessaire</translation>
    </message>
    <message>
        <source>A workcell that somebody sent may name any file of this computer. Look whether all of these belong to it.</source>
        <translation>Une cellule reçue de quelqu'un peut nommer n'importe quel fichier de cet ordinateur. Vérifiez que tous ceux-ci lui appartiennent.</translation>
    </message>
    <message>
        <source>ABB RAPID (.mod)</source>
        <translation>ABB RAPID (.mod)</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Autour de</translation>
    </message>
    <message>
        <source>About HaptiCell</source>
        <translation>À propos de HaptiCell</translation>
    </message>
    <message>
        <source>Accel.</source>
        <translation>Accél.</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Accélération</translation>
    </message>
    <message>
        <source>Across %1</source>
        <translation>À travers %1</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Add a frame</source>
        <translation>Ajouter une image</translation>
    </message>
    <message>
        <source>Add a free hand</source>
        <translation>Ajouter une main libre</translation>
    </message>
    <message>
        <source>Add a person of any size with Ctrl+Shift+M: it stands on the floor, and its hands follow the stylus or the mouse.</source>
        <translation>Ajoutez une personne de toute taille par Ctrl+Maj+M : elle se tient sur le sol, et ses mains suivent le stylet ou la souris.</translation>
    </message>
    <message>
        <source>Add a robot</source>
        <translation>Ajouter un robot</translation>
    </message>
    <message>
        <source>Add mannequin</source>
        <translation>Ajouter un mannequin</translation>
    </message>
    <message>
        <source>Add of a size</source>
        <translation>Ajouter d'une taille</translation>
    </message>
    <message>
        <source>Add robot</source>
        <translation>Ajouter un robot</translation>
    </message>
    <message>
        <source>Add robot from a file…</source>
        <translation>Ajouter un robot depuis un fichier…</translation>
    </message>
    <message>
        <source>Add robot…</source>
        <translation>Ajouter un robot…</translation>
    </message>
    <message>
        <source>Add sample %1</source>
        <translation>Ajouter l'exemple %1</translation>
    </message>
    <message>
        <source>Add selected</source>
        <translation>Ajouter la sélection</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Address of the haptic server</source>
        <translation>Adresse du serveur haptique</translation>
    </message>
    <message>
        <source>Adjustable bench</source>
        <translation>Établi réglable</translation>
    </message>
    <message>
        <source>Again and again</source>
        <translation>En boucle</translation>
    </message>
    <message>
        <source>Against</source>
        <translation>Contre</translation>
    </message>
    <message>
        <source>Against %1</source>
        <translation>Contre %1</translation>
    </message>
    <message>
        <source>Against another workcell…</source>
        <translation>Par rapport à une autre cellule…</translation>
    </message>
    <message>
        <source>Against the imported files…</source>
        <translation>Par rapport aux fichiers importés…</translation>
    </message>
    <message>
        <source>Against the saved cell…</source>
        <translation>Par rapport à la cellule enregistrée…</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Toutes</translation>
    </message>
    <message>
        <source>All %1</source>
        <translation>Toutes %1</translation>
    </message>
    <message>
        <source>All 000</source>
        <translation>Toutes 000</translation>
    </message>
    <message>
        <source>All as shipped</source>
        <translation>Toutes comme à la livraison</translation>
    </message>
    <message>
        <source>All faces look outwards already.</source>
        <translation>Toutes les faces regardent déjà vers l'extérieur.</translation>
    </message>
    <message>
        <source>All four</source>
        <translation>Les quatre</translation>
    </message>
    <message>
        <source>All makers</source>
        <translation>Tous les constructeurs</translation>
    </message>
    <message>
        <source>All sets that are on (%1)</source>
        <translation>Tous les ensembles en service (%1)</translation>
    </message>
    <message>
        <source>All that can be done with a motion</source>
        <translation>Tout ce qu'on peut faire d'un mouvement</translation>
    </message>
    <message>
        <source>All that can be read (*.step *.stp *.p21 *.stpz *.iges *.igs *.stl *.obj *.ply *.off *.gltf *.glb *.dae *.3mf *.fbx *.3ds *.urdf *.xacro *.sdf *.world *.toml);;CAD (*.step *.stp *.p21 *.stpz *.iges *.igs);;Meshes (*.stl *.obj *.ply *.off *.gltf *.glb *.dae *.3mf *.fbx *.3ds);;Robots and cells (*.urdf *.xacro *.sdf *.world *.toml);;All files (*)</source>
        <translation>Tout ce qui se lit (*.step *.stp *.p21 *.stpz *.iges *.igs *.stl *.obj *.ply *.off *.gltf *.glb *.dae *.3mf *.fbx *.3ds *.urdf *.xacro *.sdf *.world *.toml);;CAO (*.step *.stp *.p21 *.stpz *.iges *.igs);;Maillages (*.stl *.obj *.ply *.off *.gltf *.glb *.dae *.3mf *.fbx *.3ds);;Robots et cellules (*.urdf *.xacro *.sdf *.world *.toml);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Aluminium</source>
        <translation>Aluminium</translation>
    </message>
    <message>
        <source>An exercise of this cell and an expert's motion in it</source>
        <translation>Un exercice fait de cette cellule et du mouvement d'un expert</translation>
    </message>
    <message>
        <source>An expert's recording leads the stylus along its way; the guide waits for the trainee.</source>
        <translation>L'enregistrement d'un expert mène le stylet sur son chemin ; le guide attend l'élève.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Angles in</source>
        <translation>Angles en</translation>
    </message>
    <message>
        <source>Another</source>
        <translation>Un autre</translation>
    </message>
    <message>
        <source>Another colour…</source>
        <translation>Autre couleur…</translation>
    </message>
    <message>
        <source>Another program (%1) controls the stylus.</source>
        <translation>Un autre programme (%1) commande le stylet.</translation>
    </message>
    <message>
        <source>Another program has had it open.</source>
        <translation>Un autre programme l’a ouvert.</translation>
    </message>
    <message>
        <source>Another program has written the file since it was opened here. Saving it undoes what that program wrote.</source>
        <translation>Un autre programme a écrit le fichier depuis qu’il est ouvert ici. L’enregistrer défait ce que ce programme a écrit.</translation>
    </message>
    <message>
        <source>Another program started the server at %1; the device is chosen there.</source>
        <translation>Un autre programme a lancé le serveur à %1 ; le périphérique s'y choisit.</translation>
    </message>
    <message>
        <source>Another window has the stylus; this one watches</source>
        <translation>Une autre fenêtre a le stylet ; celle-ci observe</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Tout</translation>
    </message>
    <message>
        <source>Apache License 2.0. Runs with Qt %1.</source>
        <translation>Licence Apache 2.0. Fonctionne avec Qt %1.</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Apparence</translation>
    </message>
    <message>
        <source>Applications</source>
        <translation>Applications</translation>
    </message>
    <message>
        <source>Approach</source>
        <translation>Approche</translation>
    </message>
    <message>
        <source>Archives (*.zip *.tar.gz)</source>
        <translation>Archives (*.zip *.tar.gz)</translation>
    </message>
    <message>
        <source>Arguments</source>
        <translation>Arguments</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Bras</translation>
    </message>
    <message>
        <source>Arms to the sides</source>
        <translation>Bras écartés</translation>
    </message>
    <message>
        <source>As</source>
        <translation>Comme</translation>
    </message>
    <message>
        <source>As a partner on the other side would do it</source>
        <translation>Comme le ferait un partenaire de l'autre côté</translation>
    </message>
    <message>
        <source>As ghosts at the same task; a column shows its body alone</source>
        <translation>En fantômes à la même tâche ; une colonne montre son corps seul</translation>
    </message>
    <message>
        <source>As in</source>
        <translation>Comme dans</translation>
    </message>
    <message>
        <source>As large as it is…</source>
        <translation>À sa taille…</translation>
    </message>
    <message>
        <source>As recorded</source>
        <translation>Comme enregistré</translation>
    </message>
    <message>
        <source>As shipped</source>
        <translation>Comme à la livraison</translation>
    </message>
    <message>
        <source>As the entity</source>
        <translation>Comme l'entité</translation>
    </message>
    <message>
        <source>As the set</source>
        <translation>Comme l'ensemble</translation>
    </message>
    <message>
        <source>At X</source>
        <translation>En X</translation>
    </message>
    <message>
        <source>At Y</source>
        <translation>En Y</translation>
    </message>
    <message>
        <source>At Z</source>
        <translation>En Z</translation>
    </message>
    <message>
        <source>At full reach with the trunk locked. Unlock the trunk, or move it %1 closer.</source>
        <translation>À bout de bras, le tronc bloqué. Débloquez le tronc, ou approchez de %1.</translation>
    </message>
    <message>
        <source>At full reach. Move it %1 closer, or let the feet step.</source>
        <translation>À bout de bras. Approchez de %1, ou laissez les pieds avancer.</translation>
    </message>
    <message>
        <source>At least %1. You typed %2.</source>
        <translation>Au moins %1. Vous avez saisi %2.</translation>
    </message>
    <message>
        <source>At most %1 from the recording; jerk %2 → %3 m/s³</source>
        <translation>Au plus %1 de l'enregistrement ; à-coup %2 → %3 m/s³</translation>
    </message>
    <message>
        <source>At most %1. You typed %2.</source>
        <translation>Au plus %1. Vous avez saisi %2.</translation>
    </message>
    <message>
        <source>Attach</source>
        <translation>Attacher</translation>
    </message>
    <message>
        <source>Attach %1 to %2</source>
        <translation>Attacher %1 à %2</translation>
    </message>
    <message>
        <source>Attach to</source>
        <translation>Attacher à</translation>
    </message>
    <message>
        <source>Attached</source>
        <translation>Attaché</translation>
    </message>
    <message>
        <source>Attached to %1</source>
        <translation>Attaché à %1</translation>
    </message>
    <message>
        <source>Attached to %1 of %2</source>
        <translation>Attaché à %1 de %2</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>Axes and scale</source>
        <translation>Axes et échelle</translation>
    </message>
    <message>
        <source>Axes at %1</source>
        <translation>Axes en %1</translation>
    </message>
    <message>
        <source>Axes of</source>
        <translation>Axes de</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Axis at %1</source>
        <translation>Axe en %1</translation>
    </message>
    <message>
        <source>BACK</source>
        <translation>ARRIÈRE</translation>
    </message>
    <message>
        <source>BOTTOM</source>
        <translation>DESSOUS</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Arrière</translation>
    </message>
    <message>
        <source>Backwards in time</source>
        <translation>À rebours</translation>
    </message>
    <message>
        <source>Balance: %1 inside the soles</source>
        <translation>Équilibre : %1 à l'intérieur des semelles</translation>
    </message>
    <message>
        <source>Bars: points of each run, hatched where it was not passed; without guidance apart. Line: help.</source>
        <translation>Barres : points de chaque essai, hachurées s'il n'est pas réussi ; sans guidage, à part. Ligne : aide.</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Base in frame</source>
        <translation>Base dans le repère</translation>
    </message>
    <message>
        <source>Base in world</source>
        <translation>Base dans le monde</translation>
    </message>
    <message>
        <source>Base, TCP stays</source>
        <translation>Base, le TCP reste</translation>
    </message>
    <message>
        <source>Begin again</source>
        <translation>Recommencer</translation>
    </message>
    <message>
        <source>Begin from</source>
        <translation>Partir de</translation>
    </message>
    <message>
        <source>Begin with a sample, or with your own cell</source>
        <translation>Commencez par un exemple ou par votre propre cellule</translation>
    </message>
    <message>
        <source>Begin with an empty cell</source>
        <translation>Commencer par une cellule vide</translation>
    </message>
    <message>
        <source>Belly depth, sitting</source>
        <translation>Profondeur du ventre, assis</translation>
    </message>
    <message>
        <source>Beside the middle</source>
        <translation>À côté du milieu</translation>
    </message>
    <message>
        <source>Better posture of %1</source>
        <translation>Meilleure posture de %1</translation>
    </message>
    <message>
        <source>Between centres or axes</source>
        <translation>Entre centres ou axes</translation>
    </message>
    <message>
        <source>Between the picked places</source>
        <translation>Entre les endroits désignés</translation>
    </message>
    <message>
        <source>Beyond limits of the figure, not clamped; longest: %1.</source>
        <translation>Au-delà de limites de la silhouette, non ramené ; le plus long : %1.</translation>
    </message>
    <message>
        <source>Bl&amp;ue:</source>
        <translation>Ble&amp;u :</translation>
    </message>
    <message>
        <source>Bore</source>
        <translation>Alésage</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Les deux</translation>
    </message>
    <message>
        <source>Both hands</source>
        <translation>Deux mains</translation>
    </message>
    <message>
        <source>Both hands forward</source>
        <translation>Deux mains en avant</translation>
    </message>
    <message>
        <source>Both hands of %1 to %2</source>
        <translation>Les deux mains de %1 à %2</translation>
    </message>
    <message>
        <source>Both hands to a part…</source>
        <translation>Les deux mains à une pièce…</translation>
    </message>
    <message>
        <source>Both hands to this part</source>
        <translation>Les deux mains à cette pièce</translation>
    </message>
    <message>
        <source>Both styluses are in somebody's hands. Choose the 3-D mouse as the second stylus to move entities by it.</source>
        <translation>Les deux stylets sont tenus. Choisissez la souris 3D comme second stylet pour déplacer des entités avec elle.</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Dessous</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Boîte</translation>
    </message>
    <message>
        <source>Brackets in the time bar: what Trim keeps and Delete takes out</source>
        <translation>Crochets dans la barre de temps : ce que Rogner garde et Supprimer retire</translation>
    </message>
    <message>
        <source>Breadth of the pelvis</source>
        <translation>Largeur du bassin</translation>
    </message>
    <message>
        <source>Bring in as</source>
        <translation>Importer comme</translation>
    </message>
    <message>
        <source>Bring the mannequin or the part nearer, or unlock the feet so that it may step.</source>
        <translation>Rapprochez le mannequin ou la pièce, ou libérez les pieds pour qu'il puisse faire un pas.</translation>
    </message>
    <message>
        <source>Bringing the work %1 nearer</source>
        <translation>En approchant le travail de %1</translation>
    </message>
    <message>
        <source>Built-in parts</source>
        <translation>Pièces intégrées</translation>
    </message>
    <message>
        <source>Built-in robots</source>
        <translation>Robots fournis</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>Boutons</translation>
    </message>
    <message>
        <source>By</source>
        <translation>De</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>À la main</translation>
    </message>
    <message>
        <source>By numbers</source>
        <translation>Par des nombres</translation>
    </message>
    <message>
        <source>Cabinet</source>
        <translation>Armoire</translation>
    </message>
    <message>
        <source>Cable</source>
        <translation>Câble</translation>
    </message>
    <message>
        <source>Calibrate glove…</source>
        <translation>Étalonner le gant…</translation>
    </message>
    <message>
        <source>Calibrated for you.</source>
        <translation>Étalonné pour vous.</translation>
    </message>
    <message>
        <source>Calibrated.</source>
        <translation>Étalonné.</translation>
    </message>
    <message>
        <source>Calibrate…</source>
        <translation>Étalonner…</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Étalonnage</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Cancelled: the map is not complete. </source>
        <translation>Interrompu : la carte n'est pas complète. </translation>
    </message>
    <message>
        <source>Carried by</source>
        <translation>Porté par</translation>
    </message>
    <message>
        <source>Carried parts</source>
        <translation>Pièces portées</translation>
    </message>
    <message>
        <source>Carried: goes with the link and collides with it</source>
        <translation>Portée : suit le corps et entre en collision avec lui</translation>
    </message>
    <message>
        <source>Cartesian</source>
        <translation>Cartésien</translation>
    </message>
    <message>
        <source>Casts rays from its eyes to the part that was chosen last</source>
        <translation>Lance des rayons de ses yeux vers la pièce choisie en dernier</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Cellule</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Centre</translation>
    </message>
    <message>
        <source>Centre of mass and support</source>
        <translation>Centre de masse et appui</translation>
    </message>
    <message>
        <source>Chair</source>
        <translation>Chaise</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Changer</translation>
    </message>
    <message>
        <source>Change the mechanism</source>
        <translation>Changer le mécanisme</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Modifié</translation>
    </message>
    <message>
        <source>Changes are not saved</source>
        <translation>Changements non enregistrés</translation>
    </message>
    <message>
        <source>Changes of %1</source>
        <translation>Changements de %1</translation>
    </message>
    <message>
        <source>Changes on this page take effect at the next start.</source>
        <translation>Les changements de cette page valent au prochain démarrage.</translation>
    </message>
    <message>
        <source>Changes up to %1 were kept. What is open does not have them.</source>
        <translation>Les modifications jusqu’au %1 ont été gardées. Ce qui est ouvert ne les contient pas.</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Vérifier</translation>
    </message>
    <message>
        <source>Check %1 for collision</source>
        <translation>Vérifier les collisions de %1</translation>
    </message>
    <message>
        <source>Check %1 – %2 again</source>
        <translation>Vérifier de nouveau %1 – %2</translation>
    </message>
    <message>
        <source>Check device</source>
        <translation>Vérifier le périphérique</translation>
    </message>
    <message>
        <source>Check device…</source>
        <translation>Vérifier le périphérique…</translation>
    </message>
    <message>
        <source>Check it</source>
        <translation>Le vérifier</translation>
    </message>
    <message>
        <source>Check the motion</source>
        <translation>Vérifier le mouvement</translation>
    </message>
    <message>
        <source>Check the whole way</source>
        <translation>Vérifier tout le chemin</translation>
    </message>
    <message>
        <source>Check this pair again</source>
        <translation>Vérifier de nouveau cette paire</translation>
    </message>
    <message>
        <source>Checked for collision</source>
        <translation>Vérifié pour les collisions</translation>
    </message>
    <message>
        <source>Checked for contact by</source>
        <translation>Forme de contact</translation>
    </message>
    <message>
        <source>Chest depth</source>
        <translation>Profondeur du thorax</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Choisir</translation>
    </message>
    <message>
        <source>Choose a file to see what it is.</source>
        <translation>Choisissez un fichier pour voir ce que c'est.</translation>
    </message>
    <message>
        <source>Choose a kind below, then pick its geometry in the scene</source>
        <translation>Choisissez un genre, puis désignez sa géométrie dans la scène</translation>
    </message>
    <message>
        <source>Choose a motion first.</source>
        <translation>Choisissez d'abord un mouvement.</translation>
    </message>
    <message>
        <source>Choose a motion to see its curves.</source>
        <translation>Choisissez un mouvement pour voir ses courbes.</translation>
    </message>
    <message>
        <source>Choose a part first: its brackets stand in the time bar now.</source>
        <translation>Choisissez d'abord une partie : ses crochets sont dans la barre de temps.</translation>
    </message>
    <message>
        <source>Choose a picture…</source>
        <translation>Choisir une image…</translation>
    </message>
    <message>
        <source>Choose a place on a part, not on the mannequin itself.</source>
        <translation>Choisissez un endroit sur une pièce, pas sur le mannequin lui-même.</translation>
    </message>
    <message>
        <source>Choose a row to see it in the scene.</source>
        <translation>Choisissez une ligne pour la voir dans la scène.</translation>
    </message>
    <message>
        <source>Choose a row, then press its new key.</source>
        <translation>Choisissez une ligne, puis pressez sa nouvelle touche.</translation>
    </message>
    <message>
        <source>Choose a typical task…</source>
        <translation>Choisissez une tâche type…</translation>
    </message>
    <message>
        <source>Choose an exercise</source>
        <translation>Choisissez un exercice</translation>
    </message>
    <message>
        <source>Choose it in the panel Virtual Desktop.</source>
        <translation>Choisissez-le dans le panneau Virtual Desktop.</translation>
    </message>
    <message>
        <source>Choose the logo of the reports</source>
        <translation>Choisir le logo des rapports</translation>
    </message>
    <message>
        <source>Choose the size first</source>
        <translation>Choisissez d'abord la taille</translation>
    </message>
    <message>
        <source>Choose what may be moved, then search.</source>
        <translation>Choisissez ce qui peut bouger, puis cherchez.</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Cercle</translation>
    </message>
    <message>
        <source>Circle at %1</source>
        <translation>Cercle en %1</translation>
    </message>
    <message>
        <source>Clean</source>
        <translation>Nettoyer</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Effacer</translation>
    </message>
    <message>
        <source>Click a bore, a shaft, an edge or a face: its axis becomes the joint's</source>
        <translation>Cliquez un alésage, un arbre, une arête ou une face : son axe devient celui de l'articulation</translation>
    </message>
    <message>
        <source>Click a dot in the time bar to take hold of a frame; drag it in the scene.</source>
        <translation>Cliquez un point de la barre de temps pour prendre une image ; tirez-la dans la scène.</translation>
    </message>
    <message>
        <source>Click a dot in the time bar, or choose a part.</source>
        <translation>Cliquez un point de la barre de temps, ou choisissez une partie.</translation>
    </message>
    <message>
        <source>Click a face, an edge or a corner: there the tool's point is</source>
        <translation>Cliquez une face, une arête ou un coin : là est le point de l'outil</translation>
    </message>
    <message>
        <source>Click a part first, then ask.</source>
        <translation>Cliquez d'abord une pièce, puis demandez.</translation>
    </message>
    <message>
        <source>Click a part, or draw a box about several.</source>
        <translation>Cliquez une pièce, ou tracez un cadre autour de plusieurs.</translation>
    </message>
    <message>
        <source>Click a robot or a mechanism in the scene or in the tree, or add one with Ctrl+Shift+I.</source>
        <translation>Cliquez un robot ou un mécanisme dans la scène ou dans l'arbre, ou ajoutez-en un par Ctrl+Maj+I.</translation>
    </message>
    <message>
        <source>Click entities in the scene; Escape ends</source>
        <translation>Cliquez des entités dans la scène ; Échap termine</translation>
    </message>
    <message>
        <source>Click one in the scene or in the tree.</source>
        <translation>Cliquez-en un dans la scène ou dans l'arbre.</translation>
    </message>
    <message>
        <source>Click the part in the scene</source>
        <translation>Cliquez la pièce dans la scène</translation>
    </message>
    <message>
        <source>Click the part that both hands shall take</source>
        <translation>Cliquez la pièce que les deux mains doivent prendre</translation>
    </message>
    <message>
        <source>Click the part that it moves on</source>
        <translation>Cliquez la pièce sur laquelle elle bouge</translation>
    </message>
    <message>
        <source>Click the part that moves</source>
        <translation>Cliquez la pièce qui bouge</translation>
    </message>
    <message>
        <source>Click the part that the robot shall carry</source>
        <translation>Cliquez la pièce que le robot portera</translation>
    </message>
    <message>
        <source>Click to choose for this pair</source>
        <translation>Cliquez pour choisir pour cette paire</translation>
    </message>
    <message>
        <source>Click to play it</source>
        <translation>Cliquez pour le jouer</translation>
    </message>
    <message>
        <source>Click where it shall stand; Esc: not now</source>
        <translation>Cliquez où le poser ; Échap : pas maintenant</translation>
    </message>
    <message>
        <source>Click where the base shall stand</source>
        <translation>Cliquez où la base se posera</translation>
    </message>
    <message>
        <source>Click where the frame shall be: a corner, an edge, a face or the floor; Esc: not now</source>
        <translation>Cliquez où poser le repère : un coin, une arête, une face ou le sol ; Échap : pas maintenant</translation>
    </message>
    <message>
        <source>Click where the hand shall be</source>
        <translation>Cliquez là où la main doit être</translation>
    </message>
    <message>
        <source>Click where the middle of its lower side shall stand</source>
        <translation>Cliquez là où doit se poser le milieu de sa face inférieure</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Close a window or program that watches.</source>
        <translation>Fermez une fenêtre ou un programme qui observe.</translation>
    </message>
    <message>
        <source>Close it, or connect as a watcher.</source>
        <translation>Fermez-le, ou connectez-vous en observateur.</translation>
    </message>
    <message>
        <source>Close the panel; the Window menu opens it again</source>
        <translation>Fermer le panneau ; le menu Fenêtre le rouvre</translation>
    </message>
    <message>
        <source>Close the section</source>
        <translation>Fermer la coupe</translation>
    </message>
    <message>
        <source>Clutch</source>
        <translation>Débrayé</translation>
    </message>
    <message>
        <source>Coarse</source>
        <translation>Grossier</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Collision</source>
        <translation>Collision</translation>
    </message>
    <message>
        <source>Collision loop, dashed</source>
        <translation>Boucle de collision, en tirets</translation>
    </message>
    <message>
        <source>Collisions</source>
        <translation>Collisions</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Colour %1</source>
        <translation>Colorer %1</translation>
    </message>
    <message>
        <source>Colour of the part</source>
        <translation>Couleur de la pièce</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Colonnes</translation>
    </message>
    <message>
        <source>Comes with the first one</source>
        <translation>Vient avec le premier</translation>
    </message>
    <message>
        <source>Company name</source>
        <translation>Nom de l'entreprise</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Comparer avec</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Ordinateur</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Cône</translation>
    </message>
    <message>
        <source>Configuration</source>
        <translation>Configuration</translation>
    </message>
    <message>
        <source>Configurations</source>
        <translation>Configurations</translation>
    </message>
    <message>
        <source>Configurations and jogging</source>
        <translation>Configurations et marche manuelle</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Connecter</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Connecté</translation>
    </message>
    <message>
        <source>Connected, pen 2 in the scene; it holds the other hand, the trunk stands still</source>
        <translation>Connecté, stylet 2 dans la scène ; il tient l'autre main, le tronc reste immobile</translation>
    </message>
    <message>
        <source>Connected, pen 2 in the scene; it holds what its tip touches</source>
        <translation>Connecté, stylet 2 dans la scène ; il prend ce que touche sa pointe</translation>
    </message>
    <message>
        <source>Connected, simulated</source>
        <translation>Connecté, simulé</translation>
    </message>
    <message>
        <source>Connecting</source>
        <translation>Connexion</translation>
    </message>
    <message>
        <source>Connecting to %1…</source>
        <translation>Connexion à %1…</translation>
    </message>
    <message>
        <source>Connecting to the haptic server at %1.</source>
        <translation>Connexion au serveur haptique à %1.</translation>
    </message>
    <message>
        <source>Constant</source>
        <translation>Constant</translation>
    </message>
    <message>
        <source>Constant speed</source>
        <translation>Vitesse constante</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Contact</translation>
    </message>
    <message>
        <source>Contact %1</source>
        <translation>Contact %1</translation>
    </message>
    <message>
        <source>Contact 00</source>
        <translation>Contact 00</translation>
    </message>
    <message>
        <source>Contact check, at most</source>
        <translation>Vérification des contacts, au plus</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Contacts</translation>
    </message>
    <message>
        <source>Contacts are only shown: it passes</source>
        <translation>Les contacts sont seulement montrés : il traverse</translation>
    </message>
    <message>
        <source>Contacts are prepared within</source>
        <translation>Contacts préparés à moins de</translation>
    </message>
    <message>
        <source>Contacts are seen as they are felt</source>
        <translation>Les contacts se voient dès qu'ils sont ressentis</translation>
    </message>
    <message>
        <source>Contacts are seen late</source>
        <translation>Les contacts se voient tard</translation>
    </message>
    <message>
        <source>Contacts come in time</source>
        <translation>Les contacts arrivent à temps</translation>
    </message>
    <message>
        <source>Contacts come late at times</source>
        <translation>Les contacts tardent parfois</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Sommaire</translation>
    </message>
    <message>
        <source>Controllers load so long a program slowly or not at all, and run short moves unevenly. Simplified, only the moves are written that are needed within %1 and %2; the motion itself stays as it is.</source>
        <translation>Les contrôleurs chargent un programme aussi long lentement ou pas du tout, et exécutent irrégulièrement les déplacements courts. Simplifié, seuls sont écrits les déplacements nécessaires à %1 et %2 près ; le mouvement lui-même reste tel quel.</translation>
    </message>
    <message>
        <source>Convex hull</source>
        <translation>Enveloppe convexe</translation>
    </message>
    <message>
        <source>Conveyor</source>
        <translation>Convoyeur</translation>
    </message>
    <message>
        <source>Copies the command that mends it</source>
        <translation>Copie la commande qui y remédie</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copy the command for %1</source>
        <translation>Copier la commande pour %1</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Coin</translation>
    </message>
    <message>
        <source>Coupling</source>
        <translation>Prise</translation>
    </message>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Ctrl snaps to corners, edges, faces and frames · Esc takes it back</source>
        <translation>Ctrl aimante aux coins, arêtes, faces et repères · Échap annule</translation>
    </message>
    <message>
        <source>Ctrl+I imports a solid, Ctrl+Shift+I adds a robot, Ctrl+O opens a workcell.</source>
        <translation>Ctrl+I importe un solide, Ctrl+Maj+I ajoute un robot, Ctrl+O ouvre une cellule.</translation>
    </message>
    <message>
        <source>Ctrl+Space</source>
        <translation>Ctrl+Espace</translation>
    </message>
    <message>
        <source>Ctrl+Space turns them on</source>
        <translation>Ctrl+Espace les met en marche</translation>
    </message>
    <message>
        <source>Curl fingers</source>
        <translation>Plier les doigts</translation>
    </message>
    <message>
        <source>Curved edge, </source>
        <translation>Arête courbe, </translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Courbes</translation>
    </message>
    <message>
        <source>Curves of</source>
        <translation>Courbes de</translation>
    </message>
    <message>
        <source>Curves of the motion</source>
        <translation>Courbes du mouvement</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Cylindre</translation>
    </message>
    <message>
        <source>Damping (0: the stylus's own)</source>
        <translation>Amortissement (0 : celui du stylet)</translation>
    </message>
    <message>
        <source>Damping (2 is a loose grip)</source>
        <translation>Amortissement (2 : prise lâche)</translation>
    </message>
    <message>
        <source>Damping of what is held (Dynamics)</source>
        <translation>Amortissement de ce qui est tenu (Dynamique)</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>Dashed in the scene: the row chosen.</source>
        <translation>En tirets dans la scène : la ligne choisie.</translation>
    </message>
    <message>
        <source>Decimals</source>
        <translation>Décimales</translation>
    </message>
    <message>
        <source>Degrees</source>
        <translation>Degrés</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Delete this frame</source>
        <translation>Supprimer cette image</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profondeur</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>Détacher</translation>
    </message>
    <message>
        <source>Detach %1</source>
        <translation>Détacher %1</translation>
    </message>
    <message>
        <source>Detents</source>
        <translation>Crans</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Périphérique</translation>
    </message>
    <message>
        <source>Device check</source>
        <translation>Vérification du périphérique</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diamètre</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Discard copy</source>
        <translation>Supprimer la copie</translation>
    </message>
    <message>
        <source>Discard the copy</source>
        <translation>Supprimer la copie</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Déconnecter</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>Does</source>
        <translation>Fait</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fait</translation>
    </message>
    <message>
        <source>Done as a copy: %1. The recording is as it was</source>
        <translation>Fait en copie : %1. L'enregistrement est comme avant</translation>
    </message>
    <message>
        <source>Done: %1</source>
        <translation>Fait : %1</translation>
    </message>
    <message>
        <source>Drag the TCP of %1</source>
        <translation>Tirer le TCP de %1</translation>
    </message>
    <message>
        <source>Drag the arrows at the hand, or take it with the stylus.</source>
        <translation>Tirez les flèches à la main, ou prenez-la avec le stylet.</translation>
    </message>
    <message>
        <source>Drag the stylus to move it · B %1 · H: follow the mouse</source>
        <translation>Tirez le stylet pour le déplacer · B %1 · H : suivre la souris</translation>
    </message>
    <message>
        <source>Drag to move</source>
        <translation>Tirez pour déplacer</translation>
    </message>
    <message>
        <source>Drag to move in the plane of the screen</source>
        <translation>Tirez pour déplacer dans le plan de l'écran</translation>
    </message>
    <message>
        <source>Drag to move it; the body follows</source>
        <translation>Tirez pour la déplacer ; le corps suit</translation>
    </message>
    <message>
        <source>Drag to move the frame</source>
        <translation>Tirez pour déplacer l'image</translation>
    </message>
    <message>
        <source>Drag to move the tool</source>
        <translation>Tirez pour déplacer l'outil</translation>
    </message>
    <message>
        <source>Drag to turn</source>
        <translation>Tirez pour tourner</translation>
    </message>
    <message>
        <source>Drag to turn it; the body follows</source>
        <translation>Tirez pour la tourner ; le corps suit</translation>
    </message>
    <message>
        <source>Drag to turn the frame</source>
        <translation>Tirez pour tourner l'image</translation>
    </message>
    <message>
        <source>Drag to turn the tool</source>
        <translation>Tirez pour tourner l'outil</translation>
    </message>
    <message>
        <source>Drag: move · wheel: depth · Ctrl: turn · right button or B %1</source>
        <translation>Tirer : déplacer · molette : profondeur · Ctrl : tourner · bouton droit ou B %1</translation>
    </message>
    <message>
        <source>Draw the %1 of %2</source>
        <translation>Tirer %1 de %2</translation>
    </message>
    <message>
        <source>Drift at the edge of the stylus's reach (0: none)</source>
        <translation>Dérive au bord de la portée du stylet (0 : aucune)</translation>
    </message>
    <message>
        <source>Driven by %1. </source>
        <translation>Déterminé par %1. </translation>
    </message>
    <message>
        <source>Driver</source>
        <translation>Cause</translation>
    </message>
    <message>
        <source>Dropped: %1 triangles that were there twice.</source>
        <translation>Écartés : %1 triangles présents deux fois.</translation>
    </message>
    <message>
        <source>Dropped: %1 triangles without area.</source>
        <translation>Écartés : %1 triangles sans surface.</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>Dupliquer %1</translation>
    </message>
    <message>
        <source>Dynamics</source>
        <translation>Dynamique</translation>
    </message>
    <message>
        <source>EAWS (outline)</source>
        <translation>EAWS (esquisse)</translation>
    </message>
    <message>
        <source>EN 1005-4 and ISO 11226: zones and holding times of the parts; the outline of EAWS; joint comfort</source>
        <translation>EN 1005-4 et ISO 11226 : zones et durées de maintien des parties ; l'esquisse d'EAWS ; confort des articulations</translation>
    </message>
    <message>
        <source>EN, ISO</source>
        <translation>EN, ISO</translation>
    </message>
    <message>
        <source>Each its own</source>
        <translation>Chacune la sienne</translation>
    </message>
    <message>
        <source>Ear to top of head</source>
        <translation>Oreille au sommet du crâne</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Arête</translation>
    </message>
    <message>
        <source>Edge, </source>
        <translation>Arête, </translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Arêtes</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Édition</translation>
    </message>
    <message>
        <source>Edit and export motions…</source>
        <translation>Modifier et exporter des mouvements…</translation>
    </message>
    <message>
        <source>Edit joints…</source>
        <translation>Modifier les articulations…</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>Modifier…</translation>
    </message>
    <message>
        <source>Elsewhere letters and digits are text: lists and panels are searched by typing.</source>
        <translation>Ailleurs lettres et chiffres sont du texte : taper cherche dans les listes et les panneaux.</translation>
    </message>
    <message>
        <source>End stops, from where it stands now</source>
        <translation>Butées, à partir d'où il est</translation>
    </message>
    <message>
        <source>End the recording  (R)</source>
        <translation>Finir l'enregistrement  (R)</translation>
    </message>
    <message>
        <source>End the run</source>
        <translation>Finir l'essai</translation>
    </message>
    <message>
        <source>English</source>
        <translation>Anglais</translation>
    </message>
    <message>
        <source>Enter the arguments that have no value</source>
        <translation>Saisissez les arguments sans valeur</translation>
    </message>
    <message>
        <source>Entity</source>
        <translation>Entité</translation>
    </message>
    <message>
        <source>Ergonomics</source>
        <translation>Ergonomie</translation>
    </message>
    <message>
        <source>Ergonomics over time</source>
        <translation>Ergonomie au fil du temps</translation>
    </message>
    <message>
        <source>Ergonomics report…</source>
        <translation>Rapport d'ergonomie…</translation>
    </message>
    <message>
        <source>Ergonomics, live</source>
        <translation>Ergonomie, en direct</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Échap</translation>
    </message>
    <message>
        <source>Esc closes it · F1 helps · ? shows the keys</source>
        <translation>Échap la ferme · F1 aide · ? montre les touches</translation>
    </message>
    <message>
        <source>Esc takes the drag back</source>
        <translation>Échap annule le glissement</translation>
    </message>
    <message>
        <source>Esc, Space and B keep their meaning: forces off, clutch, stylus button.</source>
        <translation>Échap, Espace et B gardent leur sens : couper les efforts, débrayer, bouton du stylet.</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Événement</translation>
    </message>
    <message>
        <source>Every</source>
        <translation>Tous les</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Tout</translation>
    </message>
    <message>
        <source>Everything against everything</source>
        <translation>Tout contre tout</translation>
    </message>
    <message>
        <source>Everything on this page is kept in %1; more materials and drivers' keys can be added there.</source>
        <translation>Tout ce qui est sur cette page est gardé dans %1 ; on peut y ajouter des matériaux et les clés des pilotes.</translation>
    </message>
    <message>
        <source>Everything. Drag entities here from the tree to narrow it.</source>
        <translation>Tout. Tirez ici des entités de l'arbre pour le restreindre.</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Exercice</translation>
    </message>
    <message>
        <source>Exercise, a copy</source>
        <translation>Exercice, une copie</translation>
    </message>
    <message>
        <source>Exercises (*.hexercise)</source>
        <translation>Exercices (*.hexercise)</translation>
    </message>
    <message>
        <source>Expert</source>
        <translation>Expert</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Export cell…</source>
        <translation>Exporter la cellule…</translation>
    </message>
    <message>
        <source>Export motion</source>
        <translation>Exporter le mouvement</translation>
    </message>
    <message>
        <source>Export results</source>
        <translation>Exporter les résultats</translation>
    </message>
    <message>
        <source>Export results…</source>
        <translation>Exporter les résultats…</translation>
    </message>
    <message>
        <source>Export selection…</source>
        <translation>Exporter la sélection…</translation>
    </message>
    <message>
        <source>Exported program</source>
        <translation>Programme exporté</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>Exportation de %1</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>External axes follow the tool with the robot's own joints</source>
        <translation>Les axes externes suivent l'outil avec les articulations du robot</translation>
    </message>
    <message>
        <source>External axes go along</source>
        <translation>Les axes externes suivent</translation>
    </message>
    <message>
        <source>Eye height, sitting</source>
        <translation>Hauteur des yeux, assis</translation>
    </message>
    <message>
        <source>FANUC (.ls)</source>
        <translation>FANUC (.ls)</translation>
    </message>
    <message>
        <source>FRONT</source>
        <translation>FACE</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Face</translation>
    </message>
    <message>
        <source>Fair</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Fastest in the limits</source>
        <translation>Au plus vite dans les limites</translation>
    </message>
    <message>
        <source>Fastest, limited jerk</source>
        <translation>Au plus vite, à-coup limité</translation>
    </message>
    <message>
        <source>Feel and files</source>
        <translation>Toucher et fichiers</translation>
    </message>
    <message>
        <source>Feel of this entity</source>
        <translation>Toucher de cette entité</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Pieds</translation>
    </message>
    <message>
        <source>Feet locked</source>
        <translation>Pieds bloqués</translation>
    </message>
    <message>
        <source>Feet may step</source>
        <translation>Pieds libres</translation>
    </message>
    <message>
        <source>Felt as the boundary</source>
        <translation>Senti comme la frontière</translation>
    </message>
    <message>
        <source>Felt at once while it is edited.</source>
        <translation>Senti aussitôt pendant la modification.</translation>
    </message>
    <message>
        <source>Felt in the class Dynamics; counts in the load of the robot that carries it</source>
        <translation>Sentie dans la classe Dynamique ; compte dans la charge du robot qui la porte</translation>
    </message>
    <message>
        <source>Fence</source>
        <translation>Grillage</translation>
    </message>
    <message>
        <source>Fields also take a number with its unit: 2 in, 0.5 m, 1.57 rad. Files stay as they are.</source>
        <translation>Les champs acceptent aussi un nombre avec son unité : 2 in, 0.5 m, 1.57 rad. Les fichiers restent tels quels.</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Figure</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>File size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Fichiers</translation>
    </message>
    <message>
        <source>Filter by name</source>
        <translation>Filtrer par nom</translation>
    </message>
    <message>
        <source>Filter by name or state</source>
        <translation>Filtrer par nom ou état</translation>
    </message>
    <message>
        <source>Filter by what it does or by key</source>
        <translation>Filtrer par action ou par touche</translation>
    </message>
    <message>
        <source>Find a command</source>
        <translation>Trouver une commande</translation>
    </message>
    <message>
        <source>Find a command, panel, button or setting</source>
        <translation>Trouver une commande, un panneau, un bouton, un réglage</translation>
    </message>
    <message>
        <source>Fine</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>Finger curl</source>
        <translation>Pli des doigts</translation>
    </message>
    <message>
        <source>First a face, edge or corner of what moves, then where it shall go</source>
        <translation>D'abord une face, une arête ou un coin de ce qui bouge, puis où cela doit aller</translation>
    </message>
    <message>
        <source>First column</source>
        <translation>Première colonne</translation>
    </message>
    <message>
        <source>First page</source>
        <translation>Première page</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Premiers pas</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Cadrer</translation>
    </message>
    <message>
        <source>Fit all</source>
        <translation>Tout cadrer</translation>
    </message>
    <message>
        <source>Fit selection</source>
        <translation>Cadrer la sélection</translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation>Fixe</translation>
    </message>
    <message>
        <source>Fixed to</source>
        <translation>Fixé à</translation>
    </message>
    <message>
        <source>Flags</source>
        <translation>Options</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>À plat</translation>
    </message>
    <message>
        <source>Foam</source>
        <translation>Mousse</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>Folder %1</source>
        <translation>Dossier %1</translation>
    </message>
    <message>
        <source>Folder above</source>
        <translation>Dossier parent</translation>
    </message>
    <message>
        <source>Folder after</source>
        <translation>Dossier suivant</translation>
    </message>
    <message>
        <source>Folder before</source>
        <translation>Dossier précédent</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Suivre</translation>
    </message>
    <message>
        <source>Follow %1.</source>
        <translation>Suivre %1.</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>Suit</translation>
    </message>
    <message>
        <source>Foot breadth</source>
        <translation>Largeur du pied</translation>
    </message>
    <message>
        <source>Foot length</source>
        <translation>Longueur du pied</translation>
    </message>
    <message>
        <source>For print, 6000 × 4000…</source>
        <translation>Pour impression, 6000 × 4000…</translation>
    </message>
    <message>
        <source>For the mannequin's other hand, or whatever its tip touches</source>
        <translation>Pour l'autre main du mannequin, ou ce que touche sa pointe</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Effort</translation>
    </message>
    <message>
        <source>Force N</source>
        <translation>Effort N</translation>
    </message>
    <message>
        <source>Force above the expert's that costs all its points</source>
        <translation>Force au-dessus de celle de l'expert qui coûte tous ses points</translation>
    </message>
    <message>
        <source>Force and gap over the last seconds</source>
        <translation>Effort et distance sur les dernières secondes</translation>
    </message>
    <message>
        <source>Force loop</source>
        <translation>Boucle d'effort</translation>
    </message>
    <message>
        <source>Force on the hand</source>
        <translation>Effort sur la main</translation>
    </message>
    <message>
        <source>Force test</source>
        <translation>Essai d'effort</translation>
    </message>
    <message>
        <source>Force, unless the part says otherwise</source>
        <translation>Effort, sauf avis contraire de la pièce</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Efforts</translation>
    </message>
    <message>
        <source>Forces and contacts</source>
        <translation>Efforts et contacts</translation>
    </message>
    <message>
        <source>Forces are off.</source>
        <translation>Les efforts sont coupés.</translation>
    </message>
    <message>
        <source>Forces are off. Connect again to start it anew.</source>
        <translation>Les efforts sont coupés. Connectez de nouveau pour repartir.</translation>
    </message>
    <message>
        <source>Forces are off. The server is started again; Ctrl+Space then turns them on.</source>
        <translation>Les forces sont coupées. Le serveur est relancé ; Ctrl+Espace les remet ensuite.</translation>
    </message>
    <message>
        <source>Forces are off. Without them the guide is not felt.</source>
        <translation>Les forces sont coupées. Sans elles, le guide ne se sent pas.</translation>
    </message>
    <message>
        <source>Forces are off: a second stylus has come</source>
        <translation>Les forces sont coupées : un second stylet est arrivé</translation>
    </message>
    <message>
        <source>Forces are off: the guide is not felt.</source>
        <translation>Les forces sont coupées : le guide ne se sent pas.</translation>
    </message>
    <message>
        <source>Forces are on, %1 now.</source>
        <translation>Les efforts sont en marche, %1 maintenant.</translation>
    </message>
    <message>
        <source>Forces are on.</source>
        <translation>Les forces sont actives.</translation>
    </message>
    <message>
        <source>Forces did not come on: the device is not ready.</source>
        <translation>Les efforts ne sont pas venus : le périphérique n'est pas prêt.</translation>
    </message>
    <message>
        <source>Forces of the stylus</source>
        <translation>Efforts du stylet</translation>
    </message>
    <message>
        <source>Forces off</source>
        <translation>Efforts coupés</translation>
    </message>
    <message>
        <source>Forces off; else ends a pick or a tool</source>
        <translation>Coupe les efforts ; sinon quitte pointage ou outil</translation>
    </message>
    <message>
        <source>Forces on</source>
        <translation>Efforts en marche</translation>
    </message>
    <message>
        <source>Forces on (Ctrl+Space), off (Esc)</source>
        <translation>Efforts en marche (Ctrl+Espace), coupés (Échap)</translation>
    </message>
    <message>
        <source>Forces on and start</source>
        <translation>Activer les forces et commencer</translation>
    </message>
    <message>
        <source>Forces wait</source>
        <translation>Efforts en attente</translation>
    </message>
    <message>
        <source>Forces, N</source>
        <translation>Efforts, N</translation>
    </message>
    <message>
        <source>Forearm</source>
        <translation>Avant-bras</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Oublier</translation>
    </message>
    <message>
        <source>Forget these</source>
        <translation>Les oublier</translation>
    </message>
    <message>
        <source>Four bodies at the same task</source>
        <translation>Quatre corps à la même tâche</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Repère</translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>Repère %1</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Repère %1 de %2</translation>
    </message>
    <message>
        <source>Frame %1 of %2 at %3 s: %4, %5, %6</source>
        <translation>Image %1 sur %2 à %3 s : %4, %5, %6</translation>
    </message>
    <message>
        <source>Frame %1 · %2 s</source>
        <translation>Point %1 · %2 s</translation>
    </message>
    <message>
        <source>Frames recorded: %1</source>
        <translation>Images enregistrées : %1</translation>
    </message>
    <message>
        <source>Frames so near in time go along when a frame is moved</source>
        <translation>Les images proches dans le temps suivent quand on en déplace une</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Libre</translation>
    </message>
    <message>
        <source>Free %1 only</source>
        <translation>Libérer %1 seul</translation>
    </message>
    <message>
        <source>Free to move</source>
        <translation>Libre</translation>
    </message>
    <message>
        <source>French</source>
        <translation>Français</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Fréquence</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Frottement</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>From %1 to %2 %3</source>
        <translation>De %1 à %2 %3</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>D'un fichier…</translation>
    </message>
    <message>
        <source>From a recording…</source>
        <translation>D'un enregistrement…</translation>
    </message>
    <message>
        <source>From, to</source>
        <translation>De, à</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Face</translation>
    </message>
    <message>
        <source>Full force after</source>
        <translation>Effort entier après</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Plein écran</translation>
    </message>
    <message>
        <source>Gap, nearest pair</source>
        <translation>Distance minimale</translation>
    </message>
    <message>
        <source>Gaze of %1</source>
        <translation>Regard de %1</translation>
    </message>
    <message>
        <source>Geometric centre, %1 from own origin</source>
        <translation>Centre géométrique, à %1 de l'origine propre</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Géométrie</translation>
    </message>
    <message>
        <source>Give it a name.</source>
        <translation>Donnez-lui un nom.</translation>
    </message>
    <message>
        <source>Give the other station's address: its name in the network, or four numbers like 192.168.1.20.</source>
        <translation>Donnez l'adresse de l'autre poste : son nom sur le réseau, ou quatre nombres comme 192.168.1.20.</translation>
    </message>
    <message>
        <source>Give up: what was changed is not felt until the next change</source>
        <translation>Abandonner : ce qui a changé n'est pas senti avant le prochain changement</translation>
    </message>
    <message>
        <source>Glove</source>
        <translation>Gant</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>Revenir</translation>
    </message>
    <message>
        <source>Go back %1 s</source>
        <translation>Revenir de %1 s</translation>
    </message>
    <message>
        <source>Go back ten seconds of motion</source>
        <translation>Revenir de dix secondes de mouvement</translation>
    </message>
    <message>
        <source>Go home</source>
        <translation>Aller à l'origine</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Bonne</translation>
    </message>
    <message>
        <source>Grasp</source>
        <translation>Prise</translation>
    </message>
    <message>
        <source>Grasp of %1</source>
        <translation>Prise de %1</translation>
    </message>
    <message>
        <source>Grid %1</source>
        <translation>Grille %1</translation>
    </message>
    <message>
        <source>Grid %1 m</source>
        <translation>Grille %1 m</translation>
    </message>
    <message>
        <source>Grip</source>
        <translation>Saisie</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>Pince</translation>
    </message>
    <message>
        <source>Guidance and score</source>
        <translation>Guidage et points</translation>
    </message>
    <message>
        <source>Guides</source>
        <translation>Guides</translation>
    </message>
    <message>
        <source>Guide…</source>
        <translation>Guide…</translation>
    </message>
    <message>
        <source>Hand breadth</source>
        <translation>Largeur de la main</translation>
    </message>
    <message>
        <source>Hand in the device's workspace</source>
        <translation>Main dans l'espace du périphérique</translation>
    </message>
    <message>
        <source>Hand length</source>
        <translation>Longueur de la main</translation>
    </message>
    <message>
        <source>Hand of %1 to %2</source>
        <translation>Main de %1 à %2</translation>
    </message>
    <message>
        <source>Hand that holds a simulated stylus</source>
        <translation>Main qui tient un stylet simulé</translation>
    </message>
    <message>
        <source>Handle at</source>
        <translation>Poignée à</translation>
    </message>
    <message>
        <source>Hands away</source>
        <translation>Mains éloignées</translation>
    </message>
    <message>
        <source>Hands, size and posture</source>
        <translation>Mains, taille et posture</translation>
    </message>
    <message>
        <source>HaptiCell %1</source>
        <translation>HaptiCell %1</translation>
    </message>
    <message>
        <source>HaptiCell %1, driver interface %2, protocol %3, kernel %4</source>
        <translation>HaptiCell %1, interface de pilotes %2, protocole %3, noyau %4</translation>
    </message>
    <message>
        <source>HaptiCell crashed; nothing was unsaved</source>
        <translation>HaptiCell a planté ; rien n’était à enregistrer</translation>
    </message>
    <message>
        <source>HaptiCell trajectory (.htraj)</source>
        <translation>Trajectoire HaptiCell (.htraj)</translation>
    </message>
    <message>
        <source>HaptiCell tries again by itself; the key that is kept stays good.</source>
        <translation>HaptiCell réessaie de lui-même ; la clé conservée reste valable.</translation>
    </message>
    <message>
        <source>HaptiCell was not closed properly</source>
        <translation>HaptiCell n’a pas été fermé correctement</translation>
    </message>
    <message>
        <source>HaptiCell: the middle button turns</source>
        <translation>HaptiCell : le bouton du milieu tourne</translation>
    </message>
    <message>
        <source>Haptic</source>
        <translation>Haptique</translation>
    </message>
    <message>
        <source>Haptic loop</source>
        <translation>Boucle haptique</translation>
    </message>
    <message>
        <source>Haptics</source>
        <translation>Haptique</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Tête</translation>
    </message>
    <message>
        <source>Head breadth</source>
        <translation>Largeur de la tête</translation>
    </message>
    <message>
        <source>Head length</source>
        <translation>Longueur de la tête</translation>
    </message>
    <message>
        <source>Head, gaze</source>
        <translation>Tête, regard</translation>
    </message>
    <message>
        <source>Heel to ball</source>
        <translation>Talon à l'avant-pied</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Height of the ankle</source>
        <translation>Hauteur de la cheville</translation>
    </message>
    <message>
        <source>Height of the breastbone</source>
        <translation>Hauteur du sternum</translation>
    </message>
    <message>
        <source>Height of the crotch</source>
        <translation>Hauteur de l'entrejambe</translation>
    </message>
    <message>
        <source>Height of the hip joint</source>
        <translation>Hauteur de la hanche</translation>
    </message>
    <message>
        <source>Height of the hip's crest</source>
        <translation>Hauteur de la crête iliaque</translation>
    </message>
    <message>
        <source>Height of the knee</source>
        <translation>Hauteur du genou</translation>
    </message>
    <message>
        <source>Height of the neck</source>
        <translation>Hauteur du cou</translation>
    </message>
    <message>
        <source>Height of the shoulder</source>
        <translation>Hauteur de l'épaule</translation>
    </message>
    <message>
        <source>Height of the tenth rib</source>
        <translation>Hauteur de la dixième côte</translation>
    </message>
    <message>
        <source>Height of the work and RULA, four bodies</source>
        <translation>Hauteur du travail et RULA, quatre corps</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Tenu</translation>
    </message>
    <message>
        <source>Held along %1</source>
        <translation>Tenu le long de %1</translation>
    </message>
    <message>
        <source>Held by</source>
        <translation>Tenu par</translation>
    </message>
    <message>
        <source>Held by the stylus</source>
        <translation>Tenu par le stylet</translation>
    </message>
    <message>
        <source>Held by the stylus: %1.</source>
        <translation>Tenu par le stylet : %1.</translation>
    </message>
    <message>
        <source>Held over 1 min</source>
        <translation>Tenue plus d'1 min</translation>
    </message>
    <message>
        <source>Held: the hand moves without the entity (clutch)</source>
        <translation>Tenu : la main bouge sans l'entité (débrayage)</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Help fades by a fifth with each success, to nothing; after two failures it grows again.</source>
        <translation>L'aide baisse d'un cinquième à chaque réussite, jusqu'à rien ; après deux échecs elle remonte.</translation>
    </message>
    <message>
        <source>Help on this panel</source>
        <translation>Aide sur ce panneau</translation>
    </message>
    <message>
        <source>Here it is for reading: save it under another name, or when it is closed there.</source>
        <translation>Ici il est en lecture : enregistrez-le sous un autre nom, ou quand il sera fermé là-bas.</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Cacher</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>Cacher %1</translation>
    </message>
    <message>
        <source>Hinge</source>
        <translation>Charnière</translation>
    </message>
    <message>
        <source>Hip breadth</source>
        <translation>Largeur des hanches</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>Hit colour</source>
        <translation>Couleur de contact</translation>
    </message>
    <message>
        <source>Hold an entity with the stylus, move it and feel what it touches</source>
        <translation>Tenir une entité avec le stylet, la déplacer et sentir ce qu'elle touche</translation>
    </message>
    <message>
        <source>Hold one thing</source>
        <translation>Tenir une chose</translation>
    </message>
    <message>
        <source>Hold the hand flat and lay the thumb across under the palm.</source>
        <translation>Tenez la main à plat et passez le pouce sous la paume.</translation>
    </message>
    <message>
        <source>Hold the hand flat and spread the fingers, the thumb far out.</source>
        <translation>Tenez la main à plat, écartez les doigts, le pouce loin dehors.</translation>
    </message>
    <message>
        <source>Hold the hand flat, fingers straight and together, the thumb beside the palm.</source>
        <translation>Tenez la main à plat, doigts droits et joints, le pouce contre la paume.</translation>
    </message>
    <message>
        <source>Hold the stylus with the mouse</source>
        <translation>Tenir le stylet avec la souris</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>How %1 was read</source>
        <translation>Comment %1 a été lu</translation>
    </message>
    <message>
        <source>How far</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>How far ahead of the trainee the help pulls</source>
        <translation>Distance devant l'élève à laquelle l'aide tire</translation>
    </message>
    <message>
        <source>How far the arms of three people of its sex reach who stand as it does</source>
        <translation>Jusqu'où atteignent les bras de trois personnes de son sexe qui se tiennent comme lui</translation>
    </message>
    <message>
        <source>Hu&amp;e:</source>
        <translation>T&amp;einte :</translation>
    </message>
    <message>
        <source>I hold it: next</source>
        <translation>Je le tiens : suite</translation>
    </message>
    <message>
        <source>I hold it: push</source>
        <translation>Je le tiens : pousser</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Importer %1</translation>
    </message>
    <message>
        <source>Import CAD or a robot…</source>
        <translation>Importer de la CAO ou un robot…</translation>
    </message>
    <message>
        <source>Import all</source>
        <translation>Tout importer</translation>
    </message>
    <message>
        <source>Import all %1</source>
        <translation>Tout importer, %1</translation>
    </message>
    <message>
        <source>Import motions</source>
        <translation>Importer des mouvements</translation>
    </message>
    <message>
        <source>Import motions…</source>
        <translation>Importer des mouvements…</translation>
    </message>
    <message>
        <source>Import — %1</source>
        <translation>Importer — %1</translation>
    </message>
    <message>
        <source>Imported program</source>
        <translation>Programme importé</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importer…</translation>
    </message>
    <message>
        <source>In a shift</source>
        <translation>Par poste</translation>
    </message>
    <message>
        <source>In steps of</source>
        <translation>Par pas de</translation>
    </message>
    <message>
        <source>In the cell: %1.</source>
        <translation>Dans la cellule : %1.</translation>
    </message>
    <message>
        <source>In the hand</source>
        <translation>Dans la main</translation>
    </message>
    <message>
        <source>In two at the cursor</source>
        <translation>En deux au curseur</translation>
    </message>
    <message>
        <source>Inner radius</source>
        <translation>Rayon intérieur</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Insérer</translation>
    </message>
    <message>
        <source>Insert %1</source>
        <translation>Insérer %1</translation>
    </message>
    <message>
        <source>Insert a frame after this one</source>
        <translation>Insérer une image après celle-ci</translation>
    </message>
    <message>
        <source>Insert part</source>
        <translation>Insérer une pièce</translation>
    </message>
    <message>
        <source>Iso</source>
        <translation>Iso</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>Isoler</translation>
    </message>
    <message>
        <source>Isolate %1</source>
        <translation>Isoler %1</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isométrique</translation>
    </message>
    <message>
        <source>It does not answer: its force is zero</source>
        <translation>Il ne répond pas : sa force est nulle</translation>
    </message>
    <message>
        <source>It goes with the hand and is checked with it</source>
        <translation>Elle suit la main et est vérifiée avec elle</translation>
    </message>
    <message>
        <source>It has no frame yet: the panel Solid makes one</source>
        <translation>Pas encore de repère : le panneau Solide en crée un</translation>
    </message>
    <message>
        <source>It is locked in place. Unlock it in the tree first.</source>
        <translation>Verrouillé sur place. Déverrouillez-le d'abord dans l'arbre.</translation>
    </message>
    <message>
        <source>It is out of reach</source>
        <translation>C'est hors d'atteinte</translation>
    </message>
    <message>
        <source>It moves</source>
        <translation>Il bouge</translation>
    </message>
    <message>
        <source>It needs nothing of you.</source>
        <translation>Il n'attend rien de vous.</translation>
    </message>
    <message>
        <source>It stands below nothing</source>
        <translation>Il n'est sous rien</translation>
    </message>
    <message>
        <source>It stays in the cell until the program ends; export it to keep it.</source>
        <translation>Il reste dans la cellule jusqu'à la fin du programme ; exportez-le pour le garder.</translation>
    </message>
    <message>
        <source>It stays where it is</source>
        <translation>Il reste où il est</translation>
    </message>
    <message>
        <source>Its pairs and sets</source>
        <translation>Ses paires et ensembles</translation>
    </message>
    <message>
        <source>Its picture is made when it is saved or left here.</source>
        <translation>Son image est faite quand on l'enregistre ou la quitte ici.</translation>
    </message>
    <message>
        <source>Its way is being checked.</source>
        <translation>Sa voie est vérifiée.</translation>
    </message>
    <message>
        <source>Its way is free.</source>
        <translation>Sa voie est libre.</translation>
    </message>
    <message>
        <source>Itself</source>
        <translation>Lui-même</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>À-coup</translation>
    </message>
    <message>
        <source>Jog %1 of %2</source>
        <translation>Marche manuelle de %1 de %2</translation>
    </message>
    <message>
        <source>Jog %1 of the TCP of %2</source>
        <translation>Marche manuelle de %1 du TCP de %2</translation>
    </message>
    <message>
        <source>Join parts to a mechanism…</source>
        <translation>Relier des pièces en mécanisme…</translation>
    </message>
    <message>
        <source>Join with the next</source>
        <translation>Joindre au suivant</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Articulation</translation>
    </message>
    <message>
        <source>Joint comfort</source>
        <translation>Confort</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Articulations</translation>
    </message>
    <message>
        <source>Joints, with their limits</source>
        <translation>Articulations et leurs butées</translation>
    </message>
    <message>
        <source>KUKA KRL (.src, .dat)</source>
        <translation>KUKA KRL (.src, .dat)</translation>
    </message>
    <message>
        <source>Keep checked</source>
        <translation>Garder sous vérification</translation>
    </message>
    <message>
        <source>Keep it free of collisions</source>
        <translation>Éviter les collisions</translation>
    </message>
    <message>
        <source>Keep joint 4</source>
        <translation>Garder l'axe 4</translation>
    </message>
    <message>
        <source>Keep orientation</source>
        <translation>Garder l'orientation</translation>
    </message>
    <message>
        <source>Keep position</source>
        <translation>Garder la position</translation>
    </message>
    <message>
        <source>Keep the part between the brackets as a new motion</source>
        <translation>Garder la partie entre crochets comme nouveau mouvement</translation>
    </message>
    <message>
        <source>Keep this pose</source>
        <translation>Garder cette pose</translation>
    </message>
    <message>
        <source>Keep this pose…</source>
        <translation>Garder cette pose…</translation>
    </message>
    <message>
        <source>Keep this view</source>
        <translation>Garder cette vue</translation>
    </message>
    <message>
        <source>Keeps the part between the brackets</source>
        <translation>Garde la partie entre crochets</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Touche</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>Clavier</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Genre</translation>
    </message>
    <message>
        <source>Kneeling</source>
        <translation>À genoux</translation>
    </message>
    <message>
        <source>Kneeling on one knee</source>
        <translation>Sur un genou</translation>
    </message>
    <message>
        <source>Known; type another to change it</source>
        <translation>Connu ; tapez-en un autre pour le changer</translation>
    </message>
    <message>
        <source>LEFT</source>
        <translation>GAUCHE</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>Language of the report</source>
        <translation>Langue du rapport</translation>
    </message>
    <message>
        <source>Largest mass whose inertia is felt</source>
        <translation>Plus grande masse dont l'inertie est sentie</translation>
    </message>
    <message>
        <source>Last run: %1 points. %2 s (expert %3 s), %4 off the path, at most %5 N, contacts: %8, smoothness %6 (expert %7).</source>
        <translation>Dernier essai : %1 points. %2 s (expert %3 s), %4 hors du chemin, au plus %5 N, contacts : %8, régularité %6 (expert %7).</translation>
    </message>
    <message>
        <source>Lasted</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Plus tard</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Disposition</translation>
    </message>
    <message>
        <source>Layout as drawn</source>
        <translation>Disposition d'origine</translation>
    </message>
    <message>
        <source>Leave %1 unchecked</source>
        <translation>Ne pas vérifier %1</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Écarter</translation>
    </message>
    <message>
        <source>Leave out %1 pairs that touch at rest</source>
        <translation>Écarter %1 paires qui se touchent au repos</translation>
    </message>
    <message>
        <source>Leave out %1 – %2</source>
        <translation>Écarter %1 – %2</translation>
    </message>
    <message>
        <source>Leave out a pair that touches at rest</source>
        <translation>Écarter une paire qui se touche au repos</translation>
    </message>
    <message>
        <source>Leave this pair out</source>
        <translation>Écarter cette paire</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Left arm and hand</source>
        <translation>Bras et main gauches</translation>
    </message>
    <message>
        <source>Left elbow</source>
        <translation>Coude gauche</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>Main gauche</translation>
    </message>
    <message>
        <source>Left hand here</source>
        <translation>Main gauche ici</translation>
    </message>
    <message>
        <source>Left hand to a part…</source>
        <translation>Main gauche à une pièce…</translation>
    </message>
    <message>
        <source>Left leg</source>
        <translation>Jambe gauche</translation>
    </message>
    <message>
        <source>Left shoulder</source>
        <translation>Épaule gauche</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Length of the approach or retract, along the tool's axis</source>
        <translation>Longueur de l'approche ou du retrait, le long de l'axe de l'outil</translation>
    </message>
    <message>
        <source>Lengths in</source>
        <translation>Longueurs en</translation>
    </message>
    <message>
        <source>Let go</source>
        <translation>Lâcher</translation>
    </message>
    <message>
        <source>Let go of what is held first.</source>
        <translation>Lâchez d'abord ce qui est tenu.</translation>
    </message>
    <message>
        <source>Let go of what is held first; then start the run.</source>
        <translation>Lâchez d'abord ce qui est tenu ; commencez ensuite l'essai.</translation>
    </message>
    <message>
        <source>Libraries and their licences</source>
        <translation>Bibliothèques et leurs licences</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>Levage</translation>
    </message>
    <message>
        <source>Lift (NIOSH) and forces on the hands</source>
        <translation>Levage (NIOSH) et forces sur les mains</translation>
    </message>
    <message>
        <source>Lifting (NIOSH)</source>
        <translation>Levage (NIOSH)</translation>
    </message>
    <message>
        <source>Lifting index</source>
        <translation>Indice de levage</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Butée</translation>
    </message>
    <message>
        <source>Limits and collisions along the whole motion</source>
        <translation>Limites et collisions sur tout le mouvement</translation>
    </message>
    <message>
        <source>Limits, singular places, configurations and collisions, between the frames too</source>
        <translation>Limites, places singulières, configurations et collisions, entre les images aussi</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Line: rate. Bars: late in 99 of 100 ticks, full height %1 ms</source>
        <translation>Ligne : fréquence. Barres : retard (99 %), au plus %1 ms</translation>
    </message>
    <message>
        <source>Links of a robot are checked against each other</source>
        <translation>Les segments d'un robot sont vérifiés entre eux</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Charge</translation>
    </message>
    <message>
        <source>Load %1 of %2 allowed</source>
        <translation>Charge %1 sur %2 admis</translation>
    </message>
    <message>
        <source>Load %1; the payload is not known</source>
        <translation>Charge %1 ; la charge admise n'est pas connue</translation>
    </message>
    <message>
        <source>Load, left hand</source>
        <translation>Charge à gauche</translation>
    </message>
    <message>
        <source>Load, right hand</source>
        <translation>Charge à droite</translation>
    </message>
    <message>
        <source>Load: none, payload %1</source>
        <translation>Charge : aucune, charge admise %1</translation>
    </message>
    <message>
        <source>Load: none, payload not known</source>
        <translation>Charge : aucune. La charge admise n'est pas connue</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Verrouiller</translation>
    </message>
    <message>
        <source>Lock %1</source>
        <translation>Verrouiller %1</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Verrouillé</translation>
    </message>
    <message>
        <source>Locked in place</source>
        <translation>Verrouillé sur place</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>Log of contacts</source>
        <translation>Journal des contacts</translation>
    </message>
    <message>
        <source>Logo</source>
        <translation>Logo</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>Regarder de nouveau</translation>
    </message>
    <message>
        <source>Look at it</source>
        <translation>La regarder</translation>
    </message>
    <message>
        <source>Looking at the mesh</source>
        <translation>Examen du maillage</translation>
    </message>
    <message>
        <source>Looking for it</source>
        <translation>Recherche</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>Recherche…</translation>
    </message>
    <message>
        <source>Low back</source>
        <translation>Bas du dos</translation>
    </message>
    <message>
        <source>Lower stop</source>
        <translation>Butée basse</translation>
    </message>
    <message>
        <source>Lower the part onto its locators and feel what it touches.</source>
        <translation>Descendez la pièce sur ses appuis et sentez ce qu'elle touche.</translation>
    </message>
    <message>
        <source>Lowering the work by %1</source>
        <translation>En abaissant le travail de %1</translation>
    </message>
    <message>
        <source>Lying</source>
        <translation>Allongé</translation>
    </message>
    <message>
        <source>Make a fist, every finger joint bent by a right angle.</source>
        <translation>Fermez le poing, chaque articulation des doigts pliée à angle droit.</translation>
    </message>
    <message>
        <source>Make the mechanism</source>
        <translation>Faire le mécanisme</translation>
    </message>
    <message>
        <source>Maker</source>
        <translation>Constructeur</translation>
    </message>
    <message>
        <source>Man</source>
        <translation>Homme</translation>
    </message>
    <message>
        <source>Man, %1, %2 kg</source>
        <translation>Homme, %1, %2 kg</translation>
    </message>
    <message>
        <source>Mannequin</source>
        <translation>Mannequin</translation>
    </message>
    <message>
        <source>Mannequin and ergonomics</source>
        <translation>Mannequin et ergonomie</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Manuel</translation>
    </message>
    <message>
        <source>Markers (*.c3d);;All files (*)</source>
        <translation>Marqueurs (*.c3d);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Mass not entered, 1 kg taken: %1</source>
        <translation>Masse non saisie, 1 kg pris : %1</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>Materials: how a touched part feels</source>
        <translation>Matériaux : le toucher d'une pièce</translation>
    </message>
    <message>
        <source>Max mm</source>
        <translation>Max mm</translation>
    </message>
    <message>
        <source>Mean deviation that costs all its points</source>
        <translation>Écart moyen qui coûte tous ses points</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mesurer</translation>
    </message>
    <message>
        <source>Measure…</source>
        <translation>Mesurer…</translation>
    </message>
    <message>
        <source>Mechanism</source>
        <translation>Mécanisme</translation>
    </message>
    <message>
        <source>Mechanism joints</source>
        <translation>Articulations du mécanisme</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Moyen</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Maillage</translation>
    </message>
    <message>
        <source>Mesh and collision shape…</source>
        <translation>Maillage et forme de collision…</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Messages</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Mètres</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Milieu</translation>
    </message>
    <message>
        <source>Middle button</source>
        <translation>Bouton du milieu</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimètres</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Miroir</translation>
    </message>
    <message>
        <source>Mirror %1</source>
        <translation>Mettre %1 en miroir</translation>
    </message>
    <message>
        <source>Mirrored on the plane</source>
        <translation>Symétrique par rapport au plan</translation>
    </message>
    <message>
        <source>Missed: %1 is %2, asked %3 (%4). %5</source>
        <translation>Manqué : %1 vaut %2, demandé %3 (%4). %5</translation>
    </message>
    <message>
        <source>Moment of the recording</source>
        <translation>Instant de l'enregistrement</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Motions</source>
        <translation>Mouvements</translation>
    </message>
    <message>
        <source>Motions (*.bvh *.amc *.c3d);;All files (*)</source>
        <translation>Mouvements (*.bvh *.amc *.c3d);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Motions (*.bvh);;All files (*)</source>
        <translation>Mouvements (*.bvh);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Motions imported: %1</source>
        <translation>Mouvements importés : %1</translation>
    </message>
    <message>
        <source>Mount on</source>
        <translation>Monter sur</translation>
    </message>
    <message>
        <source>Mouse and view</source>
        <translation>Souris et vue</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Déplacer</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Déplacer %1</translation>
    </message>
    <message numerus="yes">
        <source>Move %n entities</source>
        <translation><numerusform>Déplacer %n entité</numerusform><numerusform>Déplacer %n entités</numerusform></translation>
    </message>
    <message>
        <source>Move by %1</source>
        <translation>Déplacer de %1</translation>
    </message>
    <message>
        <source>Move by numbers…</source>
        <translation>Déplacer par des nombres…</translation>
    </message>
    <message>
        <source>Move by this</source>
        <translation>Déplacer de cela</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Descendre</translation>
    </message>
    <message>
        <source>Move joints of %1</source>
        <translation>Bouger les articulations de %1</translation>
    </message>
    <message>
        <source>Move solids, robots and people in a CAD workcell, and feel the contacts.</source>
        <translation>Déplacer solides, robots et personnes dans une cellule CAO, et sentir les contacts.</translation>
    </message>
    <message>
        <source>Move the TCP of %1</source>
        <translation>Déplacer le TCP de %1</translation>
    </message>
    <message>
        <source>Move the stylus into free space</source>
        <translation>Menez le stylet en espace libre</translation>
    </message>
    <message>
        <source>Move the stylus to all sides and press each button once.</source>
        <translation>Menez le stylet de tous côtés et pressez chaque bouton une fois.</translation>
    </message>
    <message>
        <source>Move the workplace</source>
        <translation>Déplacer le poste de travail</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Monter</translation>
    </message>
    <message>
        <source>Moved</source>
        <translation>Déplacé</translation>
    </message>
    <message>
        <source>Moved by</source>
        <translation>Déplacé par</translation>
    </message>
    <message>
        <source>Moved: %1.</source>
        <translation>Déplacé : %1.</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>Bouge</translation>
    </message>
    <message>
        <source>Moves the guide to where the entity is held, turned as it is</source>
        <translation>Mène le guide où l'entité est tenue, tourné comme elle</translation>
    </message>
    <message>
        <source>Moving the view</source>
        <translation>Bouger la vue</translation>
    </message>
    <message>
        <source>Moving the work %1 further away</source>
        <translation>En éloignant le travail de %1</translation>
    </message>
    <message>
        <source>Moving the work %1 to the side</source>
        <translation>En décalant le travail de %1 de côté</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>N m</source>
        <translation>N m</translation>
    </message>
    <message>
        <source>N s/m</source>
        <translation>N s/m</translation>
    </message>
    <message>
        <source>N/m</source>
        <translation>N/m</translation>
    </message>
    <message>
        <source>N/mm</source>
        <translation>N/mm</translation>
    </message>
    <message>
        <source>NIOSH does not apply: %1</source>
        <translation>NIOSH ne s'applique pas : %1</translation>
    </message>
    <message>
        <source>NIOSH does not apply: nothing is lifted. A lift and its load are entered in Task data.</source>
        <translation>NIOSH ne s'applique pas : rien n'est levé. Levage et charge se saisissent dans Données de la tâche.</translation>
    </message>
    <message>
        <source>NIOSH does not apply: the load is held. Where it is lifted, tick so in Task data.</source>
        <translation>NIOSH ne s'applique pas : la charge est tenue. Si elle est levée, cochez-le dans Données de la tâche.</translation>
    </message>
    <message>
        <source>NIOSH: lifting index %1, %2 (%3 kg of a limit of %4 kg)</source>
        <translation>NIOSH : indice de levage %1, %2 (%3 kg pour une limite de %4 kg)</translation>
    </message>
    <message>
        <source>NIOSH: limit 0 kg, no load is acceptable from this place</source>
        <translation>NIOSH : limite 0 kg, aucune charge n'est acceptable à cet endroit</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Name a point of %1</source>
        <translation>Nommer un point de %1</translation>
    </message>
    <message>
        <source>Name of the pose (home replaces home)</source>
        <translation>Nom de la pose (home remplace home)</translation>
    </message>
    <message>
        <source>Name, maker, kind or payload</source>
        <translation>Nom, constructeur, genre ou charge</translation>
    </message>
    <message>
        <source>Name, or 192.168.1.20</source>
        <translation>Nom, ou 192.168.1.20</translation>
    </message>
    <message>
        <source>Name, task, guidance; of a shipped exercise a copy</source>
        <translation>Nom, tâche, guidage ; d'un exercice fourni, une copie</translation>
    </message>
    <message>
        <source>Named poses</source>
        <translation>Poses nommées</translation>
    </message>
    <message>
        <source>Named poses: go to one, keep this one</source>
        <translation>Poses nommées : aller à l'une, garder celle-ci</translation>
    </message>
    <message>
        <source>Names only</source>
        <translation>Noms seuls</translation>
    </message>
    <message>
        <source>Near a singular position: a direction is nearly lost</source>
        <translation>Près d'une place singulière : une direction est presque perdue</translation>
    </message>
    <message>
        <source>Near colour</source>
        <translation>Couleur proche</translation>
    </message>
    <message>
        <source>Near miss</source>
        <translation>Quasi-contact</translation>
    </message>
    <message>
        <source>Near miss %1</source>
        <translation>Quasi-contact %1</translation>
    </message>
    <message>
        <source>Near miss 00</source>
        <translation>Quasi-contact 00</translation>
    </message>
    <message>
        <source>Near miss under %1</source>
        <translation>Quasi-contact sous %1</translation>
    </message>
    <message>
        <source>Near miss: shown and heard from</source>
        <translation>Quasi-contact : montré et entendu dès</translation>
    </message>
    <message>
        <source>Nearest posture: %1. </source>
        <translation>Posture la plus proche : %1. </translation>
    </message>
    <message>
        <source>Neck and head</source>
        <translation>Cou et tête</translation>
    </message>
    <message>
        <source>Never in front of the scene. The newest also stands in the status bar for 8 seconds.</source>
        <translation>Jamais devant la scène. Le plus récent reste aussi 8 secondes dans la ligne d'état.</translation>
    </message>
    <message>
        <source>Never saved. Kept up to %1.</source>
        <translation>Jamais enregistrée. Gardée jusqu’au %1.</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nouveau</translation>
    </message>
    <message>
        <source>New exercise</source>
        <translation>Nouvel exercice</translation>
    </message>
    <message>
        <source>New folder</source>
        <translation>Nouveau dossier</translation>
    </message>
    <message>
        <source>New frame…</source>
        <translation>Nouveau repère…</translation>
    </message>
    <message>
        <source>New guide</source>
        <translation>Nouveau guide</translation>
    </message>
    <message>
        <source>New joint</source>
        <translation>Nouvelle articulation</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Touche</translation>
    </message>
    <message>
        <source>New pair set</source>
        <translation>Nouvel ensemble de paires</translation>
    </message>
    <message>
        <source>New times along the same path</source>
        <translation>Nouveaux temps sur le même chemin</translation>
    </message>
    <message>
        <source>New workcell</source>
        <translation>Nouvelle cellule</translation>
    </message>
    <message>
        <source>New…</source>
        <translation>Nouveau…</translation>
    </message>
    <message>
        <source>Next page</source>
        <translation>Page suivante</translation>
    </message>
    <message>
        <source>Next panel</source>
        <translation>Panneau suivant</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Non</translation>
    </message>
    <message>
        <source>No application was found beside the program</source>
        <translation>Aucune application n'a été trouvée près du programme</translation>
    </message>
    <message>
        <source>No body of that size</source>
        <translation>Aucun corps de cette taille</translation>
    </message>
    <message>
        <source>No contact on the screen yet</source>
        <translation>Pas encore de contact à l'écran</translation>
    </message>
    <message>
        <source>No contact yet</source>
        <translation>Pas encore de contact</translation>
    </message>
    <message>
        <source>No contacts sent lately</source>
        <translation>Aucun contact envoyé récemment</translation>
    </message>
    <message>
        <source>No copy against a crash could be written</source>
        <translation>Aucune copie contre une panne n'a pu être écrite</translation>
    </message>
    <message>
        <source>No device</source>
        <translation>Pas de périphérique</translation>
    </message>
    <message>
        <source>No exercise</source>
        <translation>Aucun exercice</translation>
    </message>
    <message>
        <source>No figures yet</source>
        <translation>Pas encore de chiffres</translation>
    </message>
    <message>
        <source>No forces</source>
        <translation>Pas d'efforts</translation>
    </message>
    <message>
        <source>No frames</source>
        <translation>Aucune image</translation>
    </message>
    <message>
        <source>No guides yet</source>
        <translation>Pas encore de guide</translation>
    </message>
    <message>
        <source>No hand was added</source>
        <translation>Aucune main n'a été ajoutée</translation>
    </message>
    <message>
        <source>No haptic server answers at %1</source>
        <translation>Aucun serveur haptique ne répond à %1</translation>
    </message>
    <message>
        <source>No haptic server answers at %1.</source>
        <translation>Aucun serveur haptique ne répond à %1.</translation>
    </message>
    <message>
        <source>No haptic server answers at %1:%2.</source>
        <translation>Aucun serveur haptique ne répond à %1:%2.</translation>
    </message>
    <message>
        <source>No haptic server answers.</source>
        <translation>Aucun serveur haptique ne répond.</translation>
    </message>
    <message>
        <source>No inverse model: jog the joints.</source>
        <translation>Pas de modèle inverse : bougez les articulations.</translation>
    </message>
    <message>
        <source>No key</source>
        <translation>Pas de touche</translation>
    </message>
    <message>
        <source>No logo</source>
        <translation>Sans logo</translation>
    </message>
    <message>
        <source>No mannequin in the cell</source>
        <translation>Aucun mannequin dans la cellule</translation>
    </message>
    <message>
        <source>No mannequin is in the cell, so there is nobody to score.</source>
        <translation>Aucun mannequin dans la cellule : il n'y a personne à noter.</translation>
    </message>
    <message>
        <source>No mannequin was added</source>
        <translation>Aucun mannequin n'a été ajouté</translation>
    </message>
    <message>
        <source>No map yet</source>
        <translation>Pas encore de carte</translation>
    </message>
    <message>
        <source>No messages yet.</source>
        <translation>Aucun message.</translation>
    </message>
    <message>
        <source>No motion yet. Press R, move an entity, press R again; or import one.</source>
        <translation>Pas encore de mouvement. Pressez R, déplacez une entité, pressez R de nouveau ; ou importez-en un.</translation>
    </message>
    <message>
        <source>No motion yet. Record one, or import a file.</source>
        <translation>Pas encore de mouvement. Enregistrez-en un, ou importez un fichier.</translation>
    </message>
    <message>
        <source>No multiplier is below 1.</source>
        <translation>Aucun facteur n'est inférieur à 1.</translation>
    </message>
    <message>
        <source>No other joint</source>
        <translation>Pas d'autre articulation</translation>
    </message>
    <message>
        <source>No placement suits all four bodies.</source>
        <translation>Aucune place ne convient aux quatre corps.</translation>
    </message>
    <message>
        <source>No program on this computer opened %1. Open it in a text editor.</source>
        <translation>Aucun programme n'a ouvert %1. Ouvrez-le dans un éditeur de texte.</translation>
    </message>
    <message>
        <source>No real device could be held while this was written: the drivers are tested against models and recorded layouts.</source>
        <translation>Aucun vrai périphérique n'a pu être tenu pendant l'écriture : les pilotes sont essayés sur des modèles et des formats enregistrés.</translation>
    </message>
    <message>
        <source>No robot is chosen</source>
        <translation>Aucun robot n'est choisi</translation>
    </message>
    <message>
        <source>No robot of that name</source>
        <translation>Aucun robot de ce nom</translation>
    </message>
    <message>
        <source>No run without guidance yet.</source>
        <translation>Pas encore d'essai sans guidage.</translation>
    </message>
    <message>
        <source>No run yet</source>
        <translation>Pas encore d'essai</translation>
    </message>
    <message>
        <source>No shift of the work by up to %1 lowers the level for this body.</source>
        <translation>Aucun déplacement du travail jusqu'à %1 n'abaisse le niveau pour ce corps.</translation>
    </message>
    <message>
        <source>No solid is selected</source>
        <translation>Aucun solide n'est choisi</translation>
    </message>
    <message>
        <source>No solid is selected. Click a part in the scene or in the tree.</source>
        <translation>Aucun solide n'est choisi. Cliquez une pièce dans la scène ou dans l'arbre.</translation>
    </message>
    <message>
        <source>No sound output</source>
        <translation>Pas de sortie son</translation>
    </message>
    <message>
        <source>No stylus is connected</source>
        <translation>Aucun stylet n'est connecté</translation>
    </message>
    <message>
        <source>No stylus is connected: the guide is seen, not felt.</source>
        <translation>Aucun stylet n'est connecté : le guide se voit, sans se sentir.</translation>
    </message>
    <message>
        <source>No table of strength is shipped; yours can be read in.</source>
        <translation>Aucune table de force n'est fournie ; la vôtre peut être lue.</translation>
    </message>
    <message>
        <source>No turning about %1</source>
        <translation>Pas de rotation autour de %1</translation>
    </message>
    <message>
        <source>Nobody to report on: add a mannequin.</source>
        <translation>Personne pour le rapport : ajoutez un mannequin.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>None yet: Keep this view adds one</source>
        <translation>Aucune encore : Garder cette vue en ajoute une</translation>
    </message>
    <message>
        <source>Not calibrated: it exerts no force until it is.</source>
        <translation>Non étalonné : il n'exerce aucune force d'ici là.</translation>
    </message>
    <message>
        <source>Not checked yet</source>
        <translation>Pas encore vérifié</translation>
    </message>
    <message>
        <source>Not chosen yet</source>
        <translation>Pas encore choisi</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Pas connecté</translation>
    </message>
    <message>
        <source>Not entered</source>
        <translation>Non saisi</translation>
    </message>
    <message>
        <source>Not felt yet: preparing contacts %1 %</source>
        <translation>Pas encore ressenti : préparation des contacts %1 %</translation>
    </message>
    <message>
        <source>Not known yet</source>
        <translation>Pas encore connue</translation>
    </message>
    <message>
        <source>Not tried yet: the server has to answer first</source>
        <translation>Pas encore essayé : le serveur doit d'abord répondre</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Rien</translation>
    </message>
    <message>
        <source>Nothing but the simulated stylus, and nothing is in the way.</source>
        <translation>Rien que le stylet simulé, et rien ne gêne.</translation>
    </message>
    <message>
        <source>Nothing has moved since.</source>
        <translation>Rien n'a bougé depuis.</translation>
    </message>
    <message>
        <source>Nothing is checked against this entity. Choose sets at the left.</source>
        <translation>Rien n'est vérifié contre cette entité. Choisissez des ensembles à gauche.</translation>
    </message>
    <message>
        <source>Nothing is felt</source>
        <translation>On ne sent rien</translation>
    </message>
    <message>
        <source>Nothing is held.</source>
        <translation>Rien n'est tenu.</translation>
    </message>
    <message>
        <source>Nothing is held: the stylus button takes it</source>
        <translation>Rien n'est tenu : le bouton du stylet le prend</translation>
    </message>
    <message>
        <source>Nothing is measured yet. Connect a stylus and hold an entity.</source>
        <translation>Rien n'est encore mesuré. Connectez un stylet et tenez une entité.</translation>
    </message>
    <message>
        <source>Nothing is picked yet. The middle button and the wheel still move the view.</source>
        <translation>Rien n'est encore désigné. Le bouton du milieu et la molette bougent toujours la vue.</translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation>Rien n'est choisi</translation>
    </message>
    <message>
        <source>Nothing is selected. Click a part in the scene or in the tree.</source>
        <translation>Rien n'est choisi. Cliquez une pièce dans la scène ou dans l'arbre.</translation>
    </message>
    <message>
        <source>Nothing is ticked: tick the bench, a shelf, a fixture.</source>
        <translation>Rien n'est coché : cochez l'établi, une étagère, un posage.</translation>
    </message>
    <message>
        <source>Nothing moved: there is nothing to keep.</source>
        <translation>Rien n'a bougé : il n'y a rien à garder.</translation>
    </message>
    <message>
        <source>Nothing moves before you have agreed.</source>
        <translation>Rien ne bouge avant votre accord.</translation>
    </message>
    <message>
        <source>Nothing needs to change.</source>
        <translation>Rien n'est à changer.</translation>
    </message>
    <message>
        <source>Nothing was opened yet</source>
        <translation>Rien n'a encore été ouvert</translation>
    </message>
    <message>
        <source>Nothing yet. Files can also be dropped here.</source>
        <translation>Rien encore. On peut aussi déposer des fichiers ici.</translation>
    </message>
    <message>
        <source>Nothing: it stands free</source>
        <translation>Rien : elle se pose librement</translation>
    </message>
    <message>
        <source>OBJ (*.obj)</source>
        <translation>OBJ (*.obj)</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>OWAS</source>
        <translation>OWAS</translation>
    </message>
    <message>
        <source>Of the pull at full help</source>
        <translation>De la traction avec toute l'aide</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Arrêt</translation>
    </message>
    <message>
        <source>Off by at most</source>
        <translation>Écart d'au plus</translation>
    </message>
    <message>
        <source>Off mm</source>
        <translation>Écart mm</translation>
    </message>
    <message>
        <source>Off the path</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>Off: the figure may step to where the hand is reached</source>
        <translation>Arrêt : le corps peut avancer jusqu'où la main atteint</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Décalage</translation>
    </message>
    <message>
        <source>On a seat</source>
        <translation>Sur un siège</translation>
    </message>
    <message>
        <source>On contact</source>
        <translation>Au contact</translation>
    </message>
    <message>
        <source>On contact of %1 – %2</source>
        <translation>Au contact de %1 – %2</translation>
    </message>
    <message>
        <source>On contact, unless the part says otherwise</source>
        <translation>Au contact, sauf avis contraire de la pièce</translation>
    </message>
    <message>
        <source>On link</source>
        <translation>Sur le corps</translation>
    </message>
    <message>
        <source>On the other station, once: hapticell-haptic-server --pair shows the code; then hapticell-haptic-server --listen and that station's address.</source>
        <translation>Sur l'autre poste, une fois : hapticell-haptic-server --pair montre le code ; puis hapticell-haptic-server --listen et l'adresse de ce poste.</translation>
    </message>
    <message>
        <source>One frame back (Left, in the time bar)</source>
        <translation>Une image en arrière (Gauche, dans la barre de temps)</translation>
    </message>
    <message>
        <source>One frame on (Right, in the time bar)</source>
        <translation>Une image en avant (Droite, dans la barre de temps)</translation>
    </message>
    <message>
        <source>One is attached to the other: they cannot move against each other</source>
        <translation>L'une est attachée à l'autre : elles ne peuvent pas bouger l'une par rapport à l'autre</translation>
    </message>
    <message>
        <source>One pair touches as the cell stands: %1. Leave it out of the check?</source>
        <translation>Une paire se touche dans la cellule au repos : %1. L'écarter de la vérification ?</translation>
    </message>
    <message>
        <source>One solid</source>
        <translation>Un solide</translation>
    </message>
    <message>
        <source>One undo step</source>
        <translation>Une étape d'annulation</translation>
    </message>
    <message>
        <source>Only the frames that are needed</source>
        <translation>Seulement les images nécessaires</translation>
    </message>
    <message>
        <source>Only where the arm's last three of six or more turning joints are a wrist</source>
        <translation>Seulement où les trois dernières de six articulations tournantes ou plus forment un poignet</translation>
    </message>
    <message>
        <source>Only while the robot is held by its tool</source>
        <translation>Seulement pendant que le robot est tenu par son outil</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Open a posture</source>
        <translation>Ouvrir une posture</translation>
    </message>
    <message>
        <source>Open a posture…</source>
        <translation>Ouvrir une posture…</translation>
    </message>
    <message>
        <source>Open a recorded motion</source>
        <translation>Ouvrir un mouvement enregistré</translation>
    </message>
    <message>
        <source>Open a recorded motion (BVH, AMC, C3D)…</source>
        <translation>Ouvrir un mouvement enregistré (BVH, AMC, C3D)…</translation>
    </message>
    <message>
        <source>Open a recording (BVH, AMC, C3D) to score each of its frames.</source>
        <translation>Ouvrez un enregistrement (BVH, AMC, C3D) pour noter chacune de ses images.</translation>
    </message>
    <message>
        <source>Open a recording of markers (C3D) to see them in the scene.</source>
        <translation>Ouvrez un enregistrement de marqueurs (C3D) pour les voir dans la scène.</translation>
    </message>
    <message>
        <source>Open a workcell</source>
        <translation>Ouvrir une cellule</translation>
    </message>
    <message>
        <source>Open a workcell…</source>
        <translation>Ouvrir une cellule…</translation>
    </message>
    <message>
        <source>Open an exercise</source>
        <translation>Ouvrir un exercice</translation>
    </message>
    <message>
        <source>Open it by the handle: a guide leads, stops and a detent are felt.</source>
        <translation>Ouvrez-la par la poignée : un guide mène, on sent les butées et un cran.</translation>
    </message>
    <message>
        <source>Open markers…</source>
        <translation>Ouvrir des marqueurs…</translation>
    </message>
    <message>
        <source>Open motion…</source>
        <translation>Ouvrir un mouvement…</translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation>Ouverts récemment</translation>
    </message>
    <message>
        <source>Open recorded markers</source>
        <translation>Ouvrir des marqueurs enregistrés</translation>
    </message>
    <message>
        <source>Open the file</source>
        <translation>Ouvrir le fichier</translation>
    </message>
    <message>
        <source>Open — %1</source>
        <translation>Ouvrir — %1</translation>
    </message>
    <message>
        <source>Opened last</source>
        <translation>Ouverts en dernier</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Ouverture</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Ouvrir…</translation>
    </message>
    <message>
        <source>Orientation kept</source>
        <translation>Orientation gardée</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>Origin in frame</source>
        <translation>Origine dans le repère</translation>
    </message>
    <message>
        <source>Origin in world</source>
        <translation>Origine dans le monde</translation>
    </message>
    <message>
        <source>Origin of %1</source>
        <translation>Origine de %1</translation>
    </message>
    <message>
        <source>Orthographic</source>
        <translation>Orthographique</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Autre côté</translation>
    </message>
    <message>
        <source>Other way</source>
        <translation>Autre sens</translation>
    </message>
    <message>
        <source>Out of balance by %1</source>
        <translation>Hors d'équilibre de %1</translation>
    </message>
    <message>
        <source>Outer radius</source>
        <translation>Rayon extérieur</translation>
    </message>
    <message>
        <source>Overhead</source>
        <translation>Au-dessus de la tête</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Propre</translation>
    </message>
    <message>
        <source>Own frame %1</source>
        <translation>Repère propre %1</translation>
    </message>
    <message>
        <source>Own limit, left</source>
        <translation>Limite propre, gauche</translation>
    </message>
    <message>
        <source>Own limit, right</source>
        <translation>Limite propre, droite</translation>
    </message>
    <message>
        <source>Own limits</source>
        <translation>Limites propres</translation>
    </message>
    <message>
        <source>Own limits of the hands' force</source>
        <translation>Limites propres de l'effort aux mains</translation>
    </message>
    <message>
        <source>Own limits of the hands…</source>
        <translation>Limites propres des mains…</translation>
    </message>
    <message>
        <source>Own limits: %1</source>
        <translation>Limites propres : %1</translation>
    </message>
    <message>
        <source>Own measure</source>
        <translation>Mesure propre</translation>
    </message>
    <message>
        <source>Own origin</source>
        <translation>Origine propre</translation>
    </message>
    <message>
        <source>Own origin, as the file has it</source>
        <translation>Origine propre, comme dans le fichier</translation>
    </message>
    <message>
        <source>Own postures</source>
        <translation>Postures personnelles</translation>
    </message>
    <message>
        <source>P</source>
        <translation>P</translation>
    </message>
    <message>
        <source>P %1</source>
        <translation>P %1</translation>
    </message>
    <message>
        <source>P5 w.</source>
        <translation>P5 f.</translation>
    </message>
    <message>
        <source>P5 woman</source>
        <translation>P5 f.</translation>
    </message>
    <message>
        <source>P50 m.</source>
        <translation>P50 h.</translation>
    </message>
    <message>
        <source>P50 man</source>
        <translation>P50 h.</translation>
    </message>
    <message>
        <source>P50 w.</source>
        <translation>P50 f.</translation>
    </message>
    <message>
        <source>P50 woman</source>
        <translation>P50 f.</translation>
    </message>
    <message>
        <source>P95 m.</source>
        <translation>P95 h.</translation>
    </message>
    <message>
        <source>P95 man</source>
        <translation>P95 h.</translation>
    </message>
    <message>
        <source>PDF (*.pdf);;CSV (*.csv)</source>
        <translation>PDF (*.pdf);;CSV (*.csv)</translation>
    </message>
    <message>
        <source>PDF (*.pdf);;HTML (*.html);;Comma-separated values (*.csv);;JSON (*.json)</source>
        <translation>PDF (*.pdf);;HTML (*.html);;Valeurs séparées par des virgules (*.csv);;JSON (*.json)</translation>
    </message>
    <message>
        <source>PDF (*.pdf);;Table (*.csv)</source>
        <translation>PDF (*.pdf);;Tableau (*.csv)</translation>
    </message>
    <message>
        <source>PDF, HTML, CSV…</source>
        <translation>PDF, HTML, CSV…</translation>
    </message>
    <message>
        <source>PLY (*.ply)</source>
        <translation>PLY (*.ply)</translation>
    </message>
    <message>
        <source>Pack the workcell with its files</source>
        <translation>Empaqueter la cellule avec ses fichiers</translation>
    </message>
    <message>
        <source>Pack them too</source>
        <translation>Les archiver aussi</translation>
    </message>
    <message>
        <source>Pack with all files…</source>
        <translation>Empaqueter avec tous les fichiers…</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Page %1 sur %2</translation>
    </message>
    <message>
        <source>Page after</source>
        <translation>Page suivante</translation>
    </message>
    <message>
        <source>Page before</source>
        <translation>Page précédente</translation>
    </message>
    <message>
        <source>Pages of the settings</source>
        <translation>Pages des réglages</translation>
    </message>
    <message>
        <source>Pair and use</source>
        <translation>Associer et utiliser</translation>
    </message>
    <message>
        <source>Pair sets</source>
        <translation>Ensembles de paires</translation>
    </message>
    <message>
        <source>Pair them anew: hapticell-haptic-server --pair there, hapticell-cli pair here.</source>
        <translation>Appairez-les de nouveau : hapticell-haptic-server --pair là-bas, hapticell-cli pair ici.</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Paires</translation>
    </message>
    <message>
        <source>Pairs, sets and log</source>
        <translation>Paires, jeux et journal</translation>
    </message>
    <message>
        <source>Pallet</source>
        <translation>Palette</translation>
    </message>
    <message>
        <source>Palm length</source>
        <translation>Longueur de la paume</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Panneau</translation>
    </message>
    <message>
        <source>Panel before</source>
        <translation>Panneau précédent</translation>
    </message>
    <message>
        <source>Parent</source>
        <translation>Parent</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <source>Part of the body</source>
        <translation>Partie du corps</translation>
    </message>
    <message>
        <source>Part to attach</source>
        <translation>Pièce à attacher</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Pièces</translation>
    </message>
    <message>
        <source>Parts in their full colours</source>
        <translation>Pièces en pleines couleurs</translation>
    </message>
    <message>
        <source>Parts of a mechanism are solids of the cell.</source>
        <translation>Les pièces d'un mécanisme sont des solides de la cellule.</translation>
    </message>
    <message>
        <source>Parts that may move</source>
        <translation>Pièces qui peuvent bouger</translation>
    </message>
    <message>
        <source>Part…</source>
        <translation>Pièce…</translation>
    </message>
    <message>
        <source>Pass</source>
        <translation>Traverser</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Réussi</translation>
    </message>
    <message>
        <source>Passed from</source>
        <translation>Réussi dès</translation>
    </message>
    <message>
        <source>Passed with %1 points</source>
        <translation>Réussi avec %1 points</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Coller</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>Coller %1</translation>
    </message>
    <message>
        <source>Paste here</source>
        <translation>Coller ici</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Chemin</translation>
    </message>
    <message>
        <source>Path of %1 points</source>
        <translation>Chemin de %1 points</translation>
    </message>
    <message>
        <source>Path of a recording</source>
        <translation>Chemin d'un enregistrement</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Payload</source>
        <translation>Charge</translation>
    </message>
    <message>
        <source>Pelvis</source>
        <translation>Bassin</translation>
    </message>
    <message>
        <source>Percentile</source>
        <translation>Percentile</translation>
    </message>
    <message>
        <source>Percentile of stature</source>
        <translation>Percentile de stature</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspective</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Désigner</translation>
    </message>
    <message>
        <source>Pick a face, edge or corner of what moves · Esc: end</source>
        <translation>Désignez une face, une arête ou un coin de ce qui bouge · Échap : terminer</translation>
    </message>
    <message>
        <source>Pick a part to measure from</source>
        <translation>Désignez une pièce d'où mesurer</translation>
    </message>
    <message>
        <source>Pick axis</source>
        <translation>Désigner l'axe</translation>
    </message>
    <message>
        <source>Pick entities for the first column · Esc: end</source>
        <translation>Désignez des entités pour la première colonne · Échap : terminer</translation>
    </message>
    <message>
        <source>Pick entities for the second column · Esc: end</source>
        <translation>Désignez des entités pour la seconde colonne · Échap : terminer</translation>
    </message>
    <message>
        <source>Pick from and to</source>
        <translation>Désigner départ et arrivée</translation>
    </message>
    <message>
        <source>Pick in the scene</source>
        <translation>Désigner dans la scène</translation>
    </message>
    <message>
        <source>Pick measures again.</source>
        <translation>Désigner mesure de nouveau.</translation>
    </message>
    <message>
        <source>Pick the axes: a face, an edge or a corner</source>
        <translation>Désignez les axes : une face, une arête ou un coin</translation>
    </message>
    <message>
        <source>Pick the axis: a round face, an edge, or a flat face for its normal</source>
        <translation>Désignez l'axe : une face ronde, une arête, ou une face plane pour sa normale</translation>
    </message>
    <message>
        <source>Pick the circle: a round edge or a round face</source>
        <translation>Désignez le cercle : une arête ronde ou une face ronde</translation>
    </message>
    <message>
        <source>Pick the other part</source>
        <translation>Désignez l'autre pièce</translation>
    </message>
    <message>
        <source>Pick the path: an edge</source>
        <translation>Désignez le chemin : une arête</translation>
    </message>
    <message>
        <source>Pick the plane: a flat face or a round edge</source>
        <translation>Désignez le plan : une face plane ou une arête ronde</translation>
    </message>
    <message>
        <source>Pick the point that the hand holds · Esc: end</source>
        <translation>Désignez le point que tient la main · Échap : terminer</translation>
    </message>
    <message>
        <source>Pick the point: a corner, an edge or a face</source>
        <translation>Désignez le point : un coin, une arête ou une face</translation>
    </message>
    <message>
        <source>Pick the surface to follow</source>
        <translation>Désignez la surface à suivre</translation>
    </message>
    <message>
        <source>Pick what to measure</source>
        <translation>Désignez ce qu'il faut mesurer</translation>
    </message>
    <message>
        <source>Pick what to measure to</source>
        <translation>Désignez jusqu'où mesurer</translation>
    </message>
    <message>
        <source>Pick where it shall go · Esc: end</source>
        <translation>Désignez où cela doit aller · Échap : terminer</translation>
    </message>
    <message>
        <source>Pick where the frame shall be · Esc: end</source>
        <translation>Désignez où sera le repère · Échap : terminer</translation>
    </message>
    <message>
        <source>Picked: %1. %2.</source>
        <translation>Désigné : %1. %2.</translation>
    </message>
    <message>
        <source>Picture of the robot</source>
        <translation>Image du robot</translation>
    </message>
    <message>
        <source>Picture of the view</source>
        <translation>Image de la vue</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.svg);;All files (*)</source>
        <translation>Images (*.png *.jpg *.jpeg *.svg);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.tiff)</source>
        <translation>Images (*.png *.jpg *.tiff)</translation>
    </message>
    <message>
        <source>Pinch</source>
        <translation>Pince</translation>
    </message>
    <message>
        <source>Pipe</source>
        <translation>Tube</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Place in</source>
        <translation>Place dans</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Plane at %1</source>
        <translation>Plan en %1</translation>
    </message>
    <message>
        <source>Plastic</source>
        <translation>Plastique</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Jouer</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Jouer ou suspendre</translation>
    </message>
    <message>
        <source>Played; click to leave it out</source>
        <translation>Joué ; un clic le met de côté</translation>
    </message>
    <message>
        <source>Plays slower than recorded: fewer than 10 pictures a second can be drawn</source>
        <translation>Lecture ralentie : moins de 10 images par seconde peuvent être dessinées</translation>
    </message>
    <message>
        <source>Plugged in at</source>
        <translation>Branché sur</translation>
    </message>
    <message>
        <source>Plugged in, and what is in the way</source>
        <translation>Branchés, et ce qui gêne</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>Point %1</source>
        <translation>Point %1</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Points and help by run</source>
        <translation>Points et aide par essai</translation>
    </message>
    <message>
        <source>Points from which a run is passed</source>
        <translation>Points à partir desquels un essai est réussi</translation>
    </message>
    <message>
        <source>Poor</source>
        <translation>Mauvaise</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Port; 4747 unless the server was started with another</source>
        <translation>Port ; 4747, sauf si le serveur a été lancé avec un autre</translation>
    </message>
    <message>
        <source>Pose %1 of %2: %3</source>
        <translation>Pose %1 sur %2 : %3</translation>
    </message>
    <message>
        <source>Pose the mannequin, look at its reach and its posture.</source>
        <translation>Posez le mannequin, regardez son atteinte et sa posture.</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Position kept</source>
        <translation>Position gardée</translation>
    </message>
    <message>
        <source>Position kept, %1 at rest</source>
        <translation>Position gardée, %1 au repos</translation>
    </message>
    <message>
        <source>Position kept, wrist joint at rest</source>
        <translation>Position gardée, articulation du poignet au repos</translation>
    </message>
    <message>
        <source>Posture</source>
        <translation>Posture</translation>
    </message>
    <message>
        <source>Posture %1</source>
        <translation>Posture %1</translation>
    </message>
    <message>
        <source>Posture from a file</source>
        <translation>Posture d'un fichier</translation>
    </message>
    <message>
        <source>Posture of %1 at frame %2</source>
        <translation>Posture de %1 à l'image %2</translation>
    </message>
    <message>
        <source>Postures (*.json);;All files (*)</source>
        <translation>Postures (*.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Postures (*.json);;H-Anim figures (*.x3d);;Motions of one frame (*.bvh)</source>
        <translation>Postures (*.json);;Figures H-Anim (*.x3d);;Mouvements d'une image (*.bvh)</translation>
    </message>
    <message>
        <source>Postures…</source>
        <translation>Postures…</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Force</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>Entraînement</translation>
    </message>
    <message>
        <source>Preparing contacts</source>
        <translation>Préparation des contacts</translation>
    </message>
    <message>
        <source>Preparing the contacts was given up: what was changed is not felt yet</source>
        <translation>La préparation des contacts a été abandonnée : ce qui a changé ne se sent pas encore</translation>
    </message>
    <message>
        <source>Press the buttons here, with Ctrl, Alt, Shift</source>
        <translation>Pressez les boutons ici, avec Ctrl, Alt, Maj</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problème</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Propriétés</translation>
    </message>
    <message>
        <source>Pull ahead</source>
        <translation>Traction devant</translation>
    </message>
    <message>
        <source>Pushing</source>
        <translation>En poussant</translation>
    </message>
    <message>
        <source>Pushing down, %1 %</source>
        <translation>Poussée vers le bas, %1 %</translation>
    </message>
    <message>
        <source>Put %1 below %2</source>
        <translation>Mettre %1 sous %2</translation>
    </message>
    <message>
        <source>Put %1 onto %2</source>
        <translation>Poser %1 sur %2</translation>
    </message>
    <message>
        <source>Put into a new folder</source>
        <translation>Mettre dans un nouveau dossier</translation>
    </message>
    <message>
        <source>Put it there</source>
        <translation>Le mettre là</translation>
    </message>
    <message>
        <source>Put onto</source>
        <translation>Poser sur</translation>
    </message>
    <message>
        <source>Quantity of the curves</source>
        <translation>Grandeur des courbes</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>R records, Shift+R adds a frame. Recording begins with the first motion.</source>
        <translation>R enregistre, Maj+R ajoute une image. L'enregistrement commence au premier mouvement.</translation>
    </message>
    <message>
        <source>REBA</source>
        <translation>REBA</translation>
    </message>
    <message>
        <source>RIGHT</source>
        <translation>DROITE</translation>
    </message>
    <message>
        <source>ROS 2 JointTrajectory (.yaml)</source>
        <translation>ROS 2 JointTrajectory (.yaml)</translation>
    </message>
    <message>
        <source>RULA</source>
        <translation>RULA</translation>
    </message>
    <message>
        <source>RULA along the motion, four bodies</source>
        <translation>RULA le long du mouvement, quatre corps</translation>
    </message>
    <message>
        <source>RULA by the height of the work</source>
        <translation>RULA selon la hauteur du travail</translation>
    </message>
    <message>
        <source>Radians</source>
        <translation>Radians</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Radius about the expert's path</source>
        <translation>Rayon autour du chemin de l'expert</translation>
    </message>
    <message>
        <source>Raising the work by %1</source>
        <translation>En relevant le travail de %1</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>Ramp %1 %, 1 N/ms limit</source>
        <translation>Rampe %1 %, limite 1 N/ms</translation>
    </message>
    <message>
        <source>Ramp done, 1 N/ms limit</source>
        <translation>Rampe finie, limite 1 N/ms</translation>
    </message>
    <message>
        <source>Range of motion</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>Range of motion and button</source>
        <translation>Amplitude et bouton</translation>
    </message>
    <message>
        <source>Range of motion and buttons</source>
        <translation>Amplitude et boutons</translation>
    </message>
    <message>
        <source>Rapid changes</source>
        <translation>Gestes rapides</translation>
    </message>
    <message>
        <source>Rate and lateness of the force loop</source>
        <translation>Fréquence et retard de la boucle d'effort</translation>
    </message>
    <message>
        <source>Rates and connection</source>
        <translation>Cadences et connexion</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Re-time</source>
        <translation>Nouveaux temps</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Atteinte</translation>
    </message>
    <message>
        <source>Reach of P5, P50 and P95</source>
        <translation>Atteinte des P5, P50 et P95</translation>
    </message>
    <message>
        <source>Reach of the arms</source>
        <translation>Atteinte des bras</translation>
    </message>
    <message>
        <source>Reach with the trunk</source>
        <translation>Atteinte avec le tronc</translation>
    </message>
    <message>
        <source>Reached: width %1 %, depth %2 %, height %3 %</source>
        <translation>Atteint : largeur %1 %, profondeur %2 %, hauteur %3 %</translation>
    </message>
    <message>
        <source>Reaching</source>
        <translation>En atteignant</translation>
    </message>
    <message>
        <source>Read %1 again</source>
        <translation>Relire %1</translation>
    </message>
    <message>
        <source>Read %1 files again</source>
        <translation>Relire %1 fichiers</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>Relire</translation>
    </message>
    <message>
        <source>Read again from disk</source>
        <translation>Relire depuis le disque</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lecture de %1</translation>
    </message>
    <message>
        <source>Reading motions</source>
        <translation>Lecture des mouvements</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Prêt</translation>
    </message>
    <message>
        <source>Ready. One step of undo.</source>
        <translation>Prêt. Une étape d'annulation.</translation>
    </message>
    <message>
        <source>Rec %1:%2</source>
        <translation>Enr. %1:%2</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Capturer</translation>
    </message>
    <message>
        <source>Record %1</source>
        <translation>Capturer %1</translation>
    </message>
    <message>
        <source>Record the expert's motion first (R), then choose it here.</source>
        <translation>Enregistrez d'abord le mouvement de l'expert (R), puis choisissez-le ici.</translation>
    </message>
    <message>
        <source>Record what moves  (R)</source>
        <translation>Capturer ce qui bouge  (R)</translation>
    </message>
    <message>
        <source>Recorded markers</source>
        <translation>Marqueurs enregistrés</translation>
    </message>
    <message>
        <source>Recorded markers (C3D)…</source>
        <translation>Marqueurs enregistrés (C3D)…</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Enregistrement</translation>
    </message>
    <message>
        <source>Recordings (*.htraj *.csv *.json);;All files (*)</source>
        <translation>Enregistrements (*.htraj *.csv *.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Lâcher</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Retirer %1</translation>
    </message>
    <message>
        <source>Remove from the cell</source>
        <translation>Retirer de la cellule</translation>
    </message>
    <message>
        <source>Remove the pair set</source>
        <translation>Retirer l'ensemble de paires</translation>
    </message>
    <message>
        <source>Remove this frame</source>
        <translation>Retirer ce repère</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>Renommer %1</translation>
    </message>
    <message>
        <source>Repaired: %1 corners of neighbouring triangles were made one.</source>
        <translation>Réparés : %1 coins de triangles voisins ont été réunis.</translation>
    </message>
    <message>
        <source>Repetition</source>
        <translation>Répétition</translation>
    </message>
    <message>
        <source>Replay beside the expert</source>
        <translation>Rejouer à côté de l'expert</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Report changes</source>
        <translation>Rapport des changements</translation>
    </message>
    <message>
        <source>Report what was changed</source>
        <translation>Rapporter ce qui a changé</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Rapport…</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Restaurer</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Résultats</translation>
    </message>
    <message>
        <source>Retention</source>
        <translation>Rétention</translation>
    </message>
    <message>
        <source>Retention after %1: %2 points.</source>
        <translation>Rétention après %1 : %2 points.</translation>
    </message>
    <message>
        <source>Retention: %1 points.</source>
        <translation>Rétention : %1 points.</translation>
    </message>
    <message>
        <source>Retract</source>
        <translation>Retrait</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Inverser</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Right arm and hand</source>
        <translation>Bras et main droits</translation>
    </message>
    <message>
        <source>Right elbow</source>
        <translation>Coude droit</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Main droite</translation>
    </message>
    <message>
        <source>Right hand here</source>
        <translation>Main droite ici</translation>
    </message>
    <message>
        <source>Right hand to a part…</source>
        <translation>Main droite à une pièce…</translation>
    </message>
    <message>
        <source>Right leg</source>
        <translation>Jambe droite</translation>
    </message>
    <message>
        <source>Right shoulder</source>
        <translation>Épaule droite</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>Anneau</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Robot over a fixture</source>
        <translation>Robot au-dessus d'un montage</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Robots</translation>
    </message>
    <message>
        <source>Robots (*.urdf *.xacro *.sdf *.toml);;All files (*)</source>
        <translation>Robots (*.urdf *.xacro *.sdf *.toml);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Tourner</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Rough</source>
        <translation>Gros</translation>
    </message>
    <message>
        <source>Rounding between lines</source>
        <translation>Arrondi entre lignes</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Essai</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>Essai %1</translation>
    </message>
    <message>
        <source>Runs: %1, the last with %2 points</source>
        <translation>Essais : %1, le dernier avec %2 points</translation>
    </message>
    <message>
        <source>STEP (*.step)</source>
        <translation>STEP (*.step)</translation>
    </message>
    <message>
        <source>STL (*.stl)</source>
        <translation>STL (*.stl)</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>Sécurité</translation>
    </message>
    <message>
        <source>Safety distance: felt from</source>
        <translation>Distance de sécurité : sentie dès</translation>
    </message>
    <message>
        <source>Same task, four bodies</source>
        <translation>Même tâche, quatre corps</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Exemples</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Save anyway</source>
        <translation>Enregistrer quand même</translation>
    </message>
    <message>
        <source>Save as BVH…</source>
        <translation>Enregistrer en BVH…</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Enregistrer sous…</translation>
    </message>
    <message>
        <source>Save log</source>
        <translation>Enregistrer le journal</translation>
    </message>
    <message>
        <source>Save log…</source>
        <translation>Enregistrer le journal…</translation>
    </message>
    <message>
        <source>Save the cell first (Ctrl+S): the exercise opens its file.</source>
        <translation>Enregistrez d'abord la cellule (Ctrl+S) : l'exercice ouvre son fichier.</translation>
    </message>
    <message>
        <source>Save the exercise</source>
        <translation>Enregistrer l'exercice</translation>
    </message>
    <message>
        <source>Save the motion</source>
        <translation>Enregistrer le mouvement</translation>
    </message>
    <message>
        <source>Save the workcell</source>
        <translation>Enregistrer la cellule</translation>
    </message>
    <message>
        <source>Save this cell first; then choose the exercise again.</source>
        <translation>Enregistrez d'abord cette cellule ; puis choisissez de nouveau l'exercice.</translation>
    </message>
    <message>
        <source>Save this posture</source>
        <translation>Enregistrer cette posture</translation>
    </message>
    <message>
        <source>Save this posture (JSON, H-Anim X3D, BVH)…</source>
        <translation>Enregistrer cette posture (JSON, H-Anim X3D, BVH)…</translation>
    </message>
    <message>
        <source>Save this posture…</source>
        <translation>Enregistrer cette posture…</translation>
    </message>
    <message>
        <source>Saved views</source>
        <translation>Vues gardées</translation>
    </message>
    <message>
        <source>Say what the trainee is to do.</source>
        <translation>Dites ce que l'élève doit faire.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation>Échelle %1</translation>
    </message>
    <message>
        <source>Scale: way of the part for the same way of the hand</source>
        <translation>Échelle : chemin de la pièce pour le même chemin de la main</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Scène</translation>
    </message>
    <message>
        <source>Scoring the motion…</source>
        <translation>Notation du mouvement…</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Écran</translation>
    </message>
    <message>
        <source>Screen: widths of the view</source>
        <translation>Écran : largeurs de la vue</translation>
    </message>
    <message>
        <source>Screw</source>
        <translation>Vis</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Chercher</translation>
    </message>
    <message>
        <source>Search the library</source>
        <translation>Chercher dans la bibliothèque</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Chercher dans le manuel</translation>
    </message>
    <message>
        <source>Search the workplace…</source>
        <translation>Chercher le poste de travail…</translation>
    </message>
    <message>
        <source>Seat height</source>
        <translation>Hauteur d'assise</translation>
    </message>
    <message>
        <source>Seated</source>
        <translation>Assis</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>Second</translation>
    </message>
    <message>
        <source>Second column</source>
        <translation>Seconde colonne</translation>
    </message>
    <message>
        <source>Second stylus button adds a frame</source>
        <translation>Le second bouton du stylet ajoute une image</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>Section %1</source>
        <translation>Coupe %1</translation>
    </message>
    <message>
        <source>Section %1 %2</source>
        <translation>Coupe %1 %2</translation>
    </message>
    <message>
        <source>Section off</source>
        <translation>Coupe inactive</translation>
    </message>
    <message>
        <source>Section plane</source>
        <translation>Plan de coupe</translation>
    </message>
    <message>
        <source>Seen from</source>
        <translation>Vu depuis</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Choisir</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Tout choisir</translation>
    </message>
    <message>
        <source>Select or hold an entity: what it is checked against stands here.</source>
        <translation>Choisissez ou tenez une entité : ce contre quoi elle est vérifiée se trouve ici.</translation>
    </message>
    <message>
        <source>Selected: %1, at X %2, Y %3, Z %4.</source>
        <translation>Choisi : %1, en X %2, Y %3, Z %4.</translation>
    </message>
    <message>
        <source>Sensor %1 hardly moved between the poses. The calibration is as it was.</source>
        <translation>Le capteur %1 a à peine bougé entre les poses. L'étalonnage est comme avant.</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Fixer</translation>
    </message>
    <message>
        <source>Set %1</source>
        <translation>Ensemble %1</translation>
    </message>
    <message>
        <source>Set: %1</source>
        <translation>Ensemble : %1</translation>
    </message>
    <message>
        <source>Sets</source>
        <translation>Ensembles</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>Settings and keys</source>
        <translation>Réglages et touches</translation>
    </message>
    <message>
        <source>Settings…</source>
        <translation>Réglages…</translation>
    </message>
    <message>
        <source>Sex</source>
        <translation>Sexe</translation>
    </message>
    <message>
        <source>Shaded</source>
        <translation>Ombré</translation>
    </message>
    <message>
        <source>Shaded, edges</source>
        <translation>Ombré, arêtes</translation>
    </message>
    <message>
        <source>Shelf</source>
        <translation>Étagère</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Maj</translation>
    </message>
    <message>
        <source>Shoulder breadth</source>
        <translation>Largeur des épaules</translation>
    </message>
    <message>
        <source>Shoulder joints apart</source>
        <translation>Écart des épaules</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Montrer</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>Montrer %1</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Tout montrer</translation>
    </message>
    <message>
        <source>Show all four in the scene</source>
        <translation>Montrer les quatre dans la scène</translation>
    </message>
    <message>
        <source>Show folder</source>
        <translation>Montrer le dossier</translation>
    </message>
    <message>
        <source>Show folder…</source>
        <translation>Montrer un dossier…</translation>
    </message>
    <message>
        <source>Show me</source>
        <translation>Montrer</translation>
    </message>
    <message>
        <source>Show one there with hapticell-haptic-server --pair, and type it here: hapticell-cli pair %1.</source>
        <translation>Affichez-en une là-bas avec hapticell-haptic-server --pair, et saisissez-la ici : hapticell-cli pair %1.</translation>
    </message>
    <message>
        <source>Show the first page at start</source>
        <translation>Montrer la première page au démarrage</translation>
    </message>
    <message>
        <source>Show the keys</source>
        <translation>Montrer les touches</translation>
    </message>
    <message>
        <source>Show the motion in the scene; off: the cell as it stands</source>
        <translation>Montrer le mouvement dans la scène ; arrêt : la cellule telle qu'elle est</translation>
    </message>
    <message>
        <source>Show the room that the motion needs: all its places at once</source>
        <translation>Montrer la place que demande le mouvement : toutes ses positions à la fois</translation>
    </message>
    <message>
        <source>Show this page at start</source>
        <translation>Montrer cette page au démarrage</translation>
    </message>
    <message>
        <source>Show this posture</source>
        <translation>Montrer cette posture</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Montré</translation>
    </message>
    <message>
        <source>Shown and heard from here on, not felt</source>
        <translation>Montré et entendu à partir d'ici, pas senti</translation>
    </message>
    <message>
        <source>Shown in the scene</source>
        <translation>Montré dans la scène</translation>
    </message>
    <message>
        <source>Side panels</source>
        <translation>Panneaux latéraux</translation>
    </message>
    <message>
        <source>Silent for too long: %1 controls the stylus now.</source>
        <translation>Silence trop long : %1 commande maintenant le stylet.</translation>
    </message>
    <message>
        <source>Simplify</source>
        <translation>Simplifier</translation>
    </message>
    <message>
        <source>Simplify first</source>
        <translation>Simplifier d'abord</translation>
    </message>
    <message>
        <source>Single keys act while the pointer is over the scene; elsewhere they are text.</source>
        <translation>Les touches seules agissent tant que le pointeur est sur la scène ; ailleurs c'est du texte.</translation>
    </message>
    <message>
        <source>Single keys without Ctrl are on</source>
        <translation>Les touches seules, sans Ctrl, sont en service</translation>
    </message>
    <message>
        <source>Singularity</source>
        <translation>Singularité</translation>
    </message>
    <message>
        <source>Sit here</source>
        <translation>S'asseoir ici</translation>
    </message>
    <message>
        <source>Sitting height</source>
        <translation>Taille assise</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Dimensions</translation>
    </message>
    <message>
        <source>Size %1</source>
        <translation>Taille %1</translation>
    </message>
    <message>
        <source>Size of %1</source>
        <translation>Taille de %1</translation>
    </message>
    <message>
        <source>Size of the page</source>
        <translation>Taille de la page</translation>
    </message>
    <message>
        <source>Size of the page; Ctrl and the wheel change it as well</source>
        <translation>Taille de la page ; Ctrl et la molette la changent aussi</translation>
    </message>
    <message>
        <source>Size, ANSUR II</source>
        <translation>Taille, ANSUR II</translation>
    </message>
    <message>
        <source>Slide</source>
        <translation>Glisser</translation>
    </message>
    <message>
        <source>Slider</source>
        <translation>Glissière</translation>
    </message>
    <message>
        <source>Slowness</source>
        <translation>Lenteur</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Lisser</translation>
    </message>
    <message>
        <source>Smooth…</source>
        <translation>Lisser…</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Aimanter</translation>
    </message>
    <message>
        <source>Snap to corner, edge, face, frame</source>
        <translation>Aimanter aux coins, arêtes, faces, repères</translation>
    </message>
    <message>
        <source>Snaps to corners, edges, faces and frames · Ctrl: free · Esc takes it back</source>
        <translation>Aimante aux coins, arêtes, faces et repères · Ctrl : libre · Échap annule</translation>
    </message>
    <message>
        <source>So contacts stay easy to see. Settings, Appearance, &quot;Parts in their full colours&quot; changes it.</source>
        <translation>Ainsi les contacts restent bien visibles. Réglages, Apparence, « Pièces en pleines couleurs » le change.</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Solide</translation>
    </message>
    <message>
        <source>Solution %1</source>
        <translation>Solution %1</translation>
    </message>
    <message>
        <source>Sound at start</source>
        <translation>Son au démarrage</translation>
    </message>
    <message>
        <source>Sound off</source>
        <translation>Son coupé</translation>
    </message>
    <message>
        <source>Sound on</source>
        <translation>Son en marche</translation>
    </message>
    <message>
        <source>Sound on or off</source>
        <translation>Son en marche ou coupé</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Speed of the play</source>
        <translation>Vitesse de lecture</translation>
    </message>
    <message>
        <source>Speed, drag</source>
        <translation>Vitesse, frein</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Sphère</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Couper</translation>
    </message>
    <message>
        <source>Squatting</source>
        <translation>Accroupi</translation>
    </message>
    <message>
        <source>Standing</source>
        <translation>Debout</translation>
    </message>
    <message>
        <source>Stands in frame</source>
        <translation>Place dans le repère</translation>
    </message>
    <message>
        <source>Stands in world</source>
        <translation>Place dans le monde</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>Start hapticell-haptic-server.</source>
        <translation>Démarrez hapticell-haptic-server.</translation>
    </message>
    <message>
        <source>Start the run</source>
        <translation>Commencer l'essai</translation>
    </message>
    <message>
        <source>Start the server</source>
        <translation>Lancer le serveur</translation>
    </message>
    <message>
        <source>Start the server with its key (hapticell-haptic-server --listen ADDRESS), or see what else answers there.</source>
        <translation>Démarrez le serveur avec sa clé (hapticell-haptic-server --listen ADRESSE), ou voyez ce qui d'autre répond là-bas.</translation>
    </message>
    <message>
        <source>Start without forces</source>
        <translation>Commencer sans forces</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Stature</source>
        <translation>Stature</translation>
    </message>
    <message>
        <source>Stature, mass</source>
        <translation>Stature, masse</translation>
    </message>
    <message>
        <source>Steel</source>
        <translation>Acier</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Étape %1 sur %2 : %3</translation>
    </message>
    <message>
        <source>Step of angle</source>
        <translation>Pas d'angle</translation>
    </message>
    <message>
        <source>Step of length</source>
        <translation>Pas de longueur</translation>
    </message>
    <message>
        <source>Steps of angle</source>
        <translation>Pas d'angle</translation>
    </message>
    <message>
        <source>Steps of length</source>
        <translation>Pas de longueur</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Raideur</translation>
    </message>
    <message>
        <source>Stiffness (0: the stylus's own)</source>
        <translation>Raideur (0 : celle du stylet)</translation>
    </message>
    <message>
        <source>Stool</source>
        <translation>Tabouret</translation>
    </message>
    <message>
        <source>Stooping</source>
        <translation>Penché</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Stop before it</source>
        <translation>S'arrêter avant</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Arrêter l'enregistrement</translation>
    </message>
    <message>
        <source>Stop the video, %1 % done</source>
        <translation>Arrêter la vidéo, %1 % faits</translation>
    </message>
    <message>
        <source>Stop, slide, pass in turn</source>
        <translation>Arrêter, glisser, traverser tour à tour</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Arrêté</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>Butées</translation>
    </message>
    <message>
        <source>Stops and feel</source>
        <translation>Butées et toucher</translation>
    </message>
    <message>
        <source>Stylus</source>
        <translation>Stylet</translation>
    </message>
    <message>
        <source>Stylus at start</source>
        <translation>Stylet au démarrage</translation>
    </message>
    <message>
        <source>Stylus in the device's workspace</source>
        <translation>Stylet dans l'espace du périphérique</translation>
    </message>
    <message>
        <source>Stäubli VAL3 (folder)</source>
        <translation>Stäubli VAL3 (dossier)</translation>
    </message>
    <message>
        <source>Sub-scores of the worse side</source>
        <translation>Notes partielles du côté le plus défavorable</translation>
    </message>
    <message>
        <source>Sudden loads</source>
        <translation>À-coups</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Surface of %1</source>
        <translation>Surface de %1</translation>
    </message>
    <message>
        <source>Swap hands</source>
        <translation>Échanger les mains</translation>
    </message>
    <message>
        <source>Swap hands of %1</source>
        <translation>Échanger les mains de %1</translation>
    </message>
    <message>
        <source>Switch the forces off first: no panel moves while the hand works.</source>
        <translation>Coupez d'abord les efforts : aucun panneau ne déplace pendant que la main travaille.</translation>
    </message>
    <message>
        <source>TCP</source>
        <translation>TCP</translation>
    </message>
    <message>
        <source>TCP in frame</source>
        <translation>TCP dans le repère</translation>
    </message>
    <message>
        <source>TCP in world</source>
        <translation>TCP dans le monde</translation>
    </message>
    <message>
        <source>TOP</source>
        <translation>DESSUS</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Table</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tableau (*.csv)</translation>
    </message>
    <message>
        <source>Table (.csv)</source>
        <translation>Tableau (.csv)</translation>
    </message>
    <message>
        <source>Tables (*.csv);;All files (*)</source>
        <translation>Tables (*.csv);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>Prendre</translation>
    </message>
    <message>
        <source>Take %1</source>
        <translation>Prise %1</translation>
    </message>
    <message>
        <source>Take apart</source>
        <translation>Démonter</translation>
    </message>
    <message>
        <source>Take out</source>
        <translation>Sortir</translation>
    </message>
    <message>
        <source>Take the hand's tremor, keep the path</source>
        <translation>Ôter le tremblement de la main, garder le chemin</translation>
    </message>
    <message>
        <source>Take the part with the stylus</source>
        <translation>Prendre la pièce avec le stylet</translation>
    </message>
    <message>
        <source>Take the stylus</source>
        <translation>Prendre le stylet</translation>
    </message>
    <message>
        <source>Take the stylus in the panel Virtual Desktop takes it back.</source>
        <translation>« Prendre le stylet » dans le panneau Virtual Desktop le reprend.</translation>
    </message>
    <message>
        <source>Take this one</source>
        <translation>Prendre celle-ci</translation>
    </message>
    <message>
        <source>Take this posture</source>
        <translation>Prendre cette posture</translation>
    </message>
    <message>
        <source>Takes along</source>
        <translation>Emmène</translation>
    </message>
    <message>
        <source>Takes it out of the cell; its file stays</source>
        <translation>Le retire de la cellule ; son fichier reste</translation>
    </message>
    <message>
        <source>Takes the hand's tremor, keeps the path</source>
        <translation>Ôte le tremblement de la main, garde le chemin</translation>
    </message>
    <message>
        <source>Taking the stylus.</source>
        <translation>Prise du stylet.</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Tâche</translation>
    </message>
    <message>
        <source>Task data</source>
        <translation>Données de la tâche</translation>
    </message>
    <message>
        <source>Task data…</source>
        <translation>Données de la tâche…</translation>
    </message>
    <message>
        <source>Task of %1</source>
        <translation>Tâche de %1</translation>
    </message>
    <message>
        <source>Teach</source>
        <translation>Apprendre</translation>
    </message>
    <message>
        <source>Teach the current motion</source>
        <translation>Apprendre le mouvement actuel</translation>
    </message>
    <message>
        <source>Test the force…</source>
        <translation>Essayer l'effort…</translation>
    </message>
    <message>
        <source>That is the same part. Pick another one to measure to.</source>
        <translation>C'est la même pièce. Désignez-en une autre jusqu'où mesurer.</translation>
    </message>
    <message>
        <source>That key does &quot;%1&quot; now; it would lose it.</source>
        <translation>Cette touche fait « %1 » ; elle le perdrait.</translation>
    </message>
    <message>
        <source>The 3-D mouse moves the view</source>
        <translation>La souris 3D déplace la vue</translation>
    </message>
    <message>
        <source>The TCP of %1 is at the gripper's finger tips</source>
        <translation>Le TCP de %1 est au bout des doigts de la pince</translation>
    </message>
    <message>
        <source>The TCP stays where it is</source>
        <translation>Le TCP reste où il est</translation>
    </message>
    <message>
        <source>The arm changes its configuration: %1</source>
        <translation>Le bras change de configuration : %1</translation>
    </message>
    <message>
        <source>The arm is at the edge of its reach</source>
        <translation>Le bras est au bord de son atteinte</translation>
    </message>
    <message>
        <source>The arm is near a singularity</source>
        <translation>Le bras est près d'une singularité</translation>
    </message>
    <message>
        <source>The axis or normal points the other way</source>
        <translation>L'axe ou la normale va dans l'autre sens</translation>
    </message>
    <message>
        <source>The base follows the hand; the joints keep the tool where it is in the cell</source>
        <translation>La base suit la main ; les articulations gardent l'outil où il est dans la cellule</translation>
    </message>
    <message>
        <source>The bodies that bound most users: P5 and P50 woman, P50 and P95 man</source>
        <translation>Les corps qui encadrent la plupart des utilisateurs : femmes P5 et P50, hommes P50 et P95</translation>
    </message>
    <message>
        <source>The cell is as it was.</source>
        <translation>La cellule est comme avant.</translation>
    </message>
    <message>
        <source>The cell is empty</source>
        <translation>La cellule est vide</translation>
    </message>
    <message>
        <source>The cell is empty.</source>
        <translation>La cellule est vide.</translation>
    </message>
    <message>
        <source>The cell shows what it held before. Placements, names and colours stay when it is read again.</source>
        <translation>La cellule montre ce qu'elle contenait. Places, noms et couleurs restent à la relecture.</translation>
    </message>
    <message>
        <source>The cell stays usable meanwhile.</source>
        <translation>La cellule reste utilisable pendant ce temps.</translation>
    </message>
    <message>
        <source>The cell was changed or saved, so the run was given up. The part stands where it stood before.</source>
        <translation>La cellule a été modifiée ou enregistrée : l'essai est abandonné. La pièce est revenue à sa place.</translation>
    </message>
    <message>
        <source>The cell was never saved. Compare it with the import instead.</source>
        <translation>La cellule n'a jamais été enregistrée. Comparez-la plutôt à l'importation.</translation>
    </message>
    <message>
        <source>The chosen motion becomes the expert's, in the cell as it is</source>
        <translation>Le mouvement choisi devient celui de l'expert, dans la cellule telle qu'elle est</translation>
    </message>
    <message>
        <source>The device does not answer.</source>
        <translation>L'appareil ne répond pas.</translation>
    </message>
    <message>
        <source>The device does not answer: check its cable and power</source>
        <translation>Le périphérique ne répond pas : vérifiez son câble et son alimentation</translation>
    </message>
    <message>
        <source>The device is at its end: hold Space and bring the hand back</source>
        <translation>L'appareil est en bout de course : tenez Espace et ramenez la main</translation>
    </message>
    <message>
        <source>The device reports a fault: no force was exerted.</source>
        <translation>Le périphérique signale une panne : aucun effort n'a été exercé.</translation>
    </message>
    <message>
        <source>The devices could not be listed: %1</source>
        <translation>Les périphériques n'ont pas pu être listés : %1</translation>
    </message>
    <message>
        <source>The exercise cannot be opened</source>
        <translation>L'exercice ne peut pas être ouvert</translation>
    </message>
    <message>
        <source>The exercise is saved.</source>
        <translation>L'exercice est enregistré.</translation>
    </message>
    <message>
        <source>The expert's recording has no frames.</source>
        <translation>L'enregistrement de l'expert n'a pas d'images.</translation>
    </message>
    <message>
        <source>The feet of %1 do not reach the floor</source>
        <translation>Les pieds de %1 n'atteignent pas le sol</translation>
    </message>
    <message>
        <source>The figure in its posture</source>
        <translation>Le corps dans sa posture</translation>
    </message>
    <message>
        <source>The file holds one part.</source>
        <translation>Le fichier contient une pièce.</translation>
    </message>
    <message>
        <source>The file holds triangles.</source>
        <translation>Le fichier contient des triangles.</translation>
    </message>
    <message>
        <source>The file is being read</source>
        <translation>Le fichier est en lecture</translation>
    </message>
    <message>
        <source>The file names no unit. Is this size right?</source>
        <translation>Le fichier n'indique pas d'unité. Cette taille est-elle la bonne ?</translation>
    </message>
    <message>
        <source>The file names no unit. Which size is right?</source>
        <translation>Le fichier n'indique pas d'unité. Quelle taille est la bonne ?</translation>
    </message>
    <message>
        <source>The file of %1 names no home, and at zero it is singular: it could hardly be dragged. It starts with %2 bent. Keep a home of your own in the Robot dock.</source>
        <translation>Le fichier de %1 n'indique pas de position d'origine, et à zéro il est singulier : on pourrait à peine le tirer. Il démarre avec %2 plié. Gardez votre propre origine dans le volet Robot.</translation>
    </message>
    <message>
        <source>The file was written since by another program; the copy does not have that.</source>
        <translation>Le fichier a été écrit depuis par un autre programme ; la copie n’a pas ces changements.</translation>
    </message>
    <message>
        <source>The force loop is late at times</source>
        <translation>La boucle d'effort est parfois en retard</translation>
    </message>
    <message>
        <source>The force loop keeps its time</source>
        <translation>La boucle d'effort tient son rythme</translation>
    </message>
    <message>
        <source>The forces went off</source>
        <translation>Les efforts se sont coupés</translation>
    </message>
    <message>
        <source>The forces went off: another window took the stylus</source>
        <translation>Les forces sont coupées : une autre fenêtre a pris le stylet</translation>
    </message>
    <message>
        <source>The forces went off: the haptic server is gone</source>
        <translation>Les forces sont coupées : le serveur haptique a disparu</translation>
    </message>
    <message>
        <source>The frame goes with it, and keeps its place now</source>
        <translation>Le repère le suit, et garde sa place pour l'instant</translation>
    </message>
    <message>
        <source>The frame, or all between the brackets</source>
        <translation>L'image, ou tout entre les crochets</translation>
    </message>
    <message>
        <source>The glove does not answer: nothing was taken.</source>
        <translation>Le gant ne répond pas : rien n'a été pris.</translation>
    </message>
    <message>
        <source>The hand moves it along %1 (%1: only that)</source>
        <translation>La main le mène le long de %1 (%1 : cela seulement)</translation>
    </message>
    <message>
        <source>The hand turns it about %1 (%1 twice: only that)</source>
        <translation>La main le tourne autour de %1 (%1 deux fois : cela seulement)</translation>
    </message>
    <message>
        <source>The hands were not moved</source>
        <translation>Les mains n'ont pas bougé</translation>
    </message>
    <message>
        <source>The haptic server answers</source>
        <translation>Le serveur haptique répond</translation>
    </message>
    <message>
        <source>The haptic server at %1 and this station do not have the same key: %2.</source>
        <translation>Le serveur haptique à %1 et ce poste n'ont pas la même clé : %2.</translation>
    </message>
    <message>
        <source>The haptic server at %1 closed the connection at once: it may be one that wants a key (hapticell-cli pair), or busy with many connections.</source>
        <translation>Le serveur haptique à %1 a fermé la connexion aussitôt : il exige peut-être une clé (hapticell-cli pair), ou a trop de connexions.</translation>
    </message>
    <message>
        <source>The haptic server at %1 closed the connection.</source>
        <translation>Le serveur haptique à %1 a fermé la connexion.</translation>
    </message>
    <message>
        <source>The haptic server at %1 does not answer any more.</source>
        <translation>Le serveur haptique à %1 ne répond plus.</translation>
    </message>
    <message>
        <source>The haptic server at %1 is there, but %2: it may be busy with many connections.</source>
        <translation>Le serveur haptique à %1 est là, mais %2 : il a peut-être trop de connexions.</translation>
    </message>
    <message>
        <source>The haptic server could not be started: %1 is not there or may not be run.</source>
        <translation>Le serveur haptique n'a pas pu être lancé : %1 n'est pas là ou ne peut pas être lancé.</translation>
    </message>
    <message>
        <source>The haptic server ended, and the forces with it. Ctrl+Space turns them on again</source>
        <translation>Le serveur haptique s’est arrêté, et les forces avec lui. Ctrl+Espace les remet</translation>
    </message>
    <message>
        <source>The haptic server has %1 connections from this machine already.</source>
        <translation>Le serveur haptique a déjà %1 connexions de cette machine.</translation>
    </message>
    <message>
        <source>The haptic server has ended. %1</source>
        <translation>Le serveur haptique s'est terminé. %1</translation>
    </message>
    <message>
        <source>The haptic server has its %1 connections already.</source>
        <translation>Le serveur haptique a déjà ses %1 connexions.</translation>
    </message>
    <message>
        <source>The head goes no further: neck and trunk are at their limits</source>
        <translation>La tête ne va pas plus loin : la nuque et le tronc sont à leurs butées</translation>
    </message>
    <message>
        <source>The inner radius must be smaller than the outer one</source>
        <translation>Le rayon intérieur doit être plus petit que le rayon extérieur</translation>
    </message>
    <message>
        <source>The key for the haptic server cannot be used.</source>
        <translation>La clé du serveur haptique n'est pas utilisable.</translation>
    </message>
    <message>
        <source>The left arm is supported</source>
        <translation>Le bras gauche est appuyé</translation>
    </message>
    <message>
        <source>The left button is free: a click chooses, a drag draws a box.</source>
        <translation>Le bouton gauche est libre : un clic choisit, un glissement trace un cadre.</translation>
    </message>
    <message>
        <source>The left hand is %1 from the end of its reach</source>
        <translation>La main gauche est à %1 de la fin de sa portée</translation>
    </message>
    <message>
        <source>The left hand is %1 short.</source>
        <translation>Il manque %1 à la main gauche.</translation>
    </message>
    <message>
        <source>The lifting equation and what the hands bear; the colours stay those of RULA</source>
        <translation>L'équation de levage et ce que portent les mains ; les couleurs restent celles de RULA</translation>
    </message>
    <message>
        <source>The lifting equation does not take this lift.</source>
        <translation>L'équation de levage ne s'applique pas à ce levage.</translation>
    </message>
    <message>
        <source>The limits were not read</source>
        <translation>Les limites n'ont pas été lues</translation>
    </message>
    <message>
        <source>The link in memory is closed.</source>
        <translation>La liaison en mémoire est fermée.</translation>
    </message>
    <message>
        <source>The link to the haptic server failed: %1.</source>
        <translation>La liaison avec le serveur haptique a échoué : %1.</translation>
    </message>
    <message>
        <source>The load is lifted or lowered</source>
        <translation>La charge est levée ou baissée</translation>
    </message>
    <message>
        <source>The log is saved</source>
        <translation>Le journal est enregistré</translation>
    </message>
    <message>
        <source>The log was not saved</source>
        <translation>Le journal n'a pas été enregistré</translation>
    </message>
    <message>
        <source>The logo was not read</source>
        <translation>Le logo n'a pas été lu</translation>
    </message>
    <message>
        <source>The mannequin cannot be drawn so</source>
        <translation>Le mannequin ne peut pas être dessiné ainsi</translation>
    </message>
    <message>
        <source>The markers are shown; they are of no set that a figure can be fitted to: %1</source>
        <translation>Les marqueurs sont affichés ; ils ne forment aucun jeu sur lequel un mannequin puisse être ajusté : %1</translation>
    </message>
    <message>
        <source>The markers cannot be shown</source>
        <translation>Les marqueurs ne peuvent pas être montrés</translation>
    </message>
    <message>
        <source>The material's, from hapticell.toml; the server lowers it to what the device bears</source>
        <translation>Celle du matériau, de hapticell.toml ; le serveur l'abaisse à ce que le périphérique supporte</translation>
    </message>
    <message>
        <source>The mesh as it is drawn.</source>
        <translation>Le maillage tel qu'il est dessiné.</translation>
    </message>
    <message>
        <source>The module %1 was left out. %2</source>
        <translation>Le module %1 a été laissé de côté. %2</translation>
    </message>
    <message>
        <source>The motion as it is on this mannequin</source>
        <translation>Le mouvement tel qu'il est sur ce mannequin</translation>
    </message>
    <message>
        <source>The motion cannot be shown</source>
        <translation>Le mouvement ne peut pas être montré</translation>
    </message>
    <message>
        <source>The motion is not exported</source>
        <translation>Le mouvement n'est pas exporté</translation>
    </message>
    <message>
        <source>The motion is not imported</source>
        <translation>Le mouvement n'est pas importé</translation>
    </message>
    <message>
        <source>The motion is saved</source>
        <translation>Le mouvement est enregistré</translation>
    </message>
    <message>
        <source>The motion was not saved</source>
        <translation>Le mouvement n'a pas été enregistré</translation>
    </message>
    <message>
        <source>The one it has</source>
        <translation>Celui qu'il a</translation>
    </message>
    <message>
        <source>The part goes the expert's way; the cell stays as it is</source>
        <translation>La pièce suit le chemin de l'expert ; la cellule reste comme elle est</translation>
    </message>
    <message>
        <source>The part goes the way of the run, a ghost the expert's, both at once</source>
        <translation>La pièce suit le chemin de l'essai, un fantôme celui de l'expert, en même temps</translation>
    </message>
    <message>
        <source>The part is shown in a quieter colour than %1</source>
        <translation>La pièce est montrée dans une couleur plus sobre que %1</translation>
    </message>
    <message>
        <source>The parts are moved; undo it, or search again in the cell as it is now.</source>
        <translation>Les pièces sont déplacées : annulez, ou relancez la recherche dans la cellule telle qu’elle est.</translation>
    </message>
    <message>
        <source>The parts become solids again, where they stand now</source>
        <translation>Les pièces redeviennent des solides, où elles sont maintenant</translation>
    </message>
    <message>
        <source>The path of a recorded motion, thinned</source>
        <translation>Le chemin d'un mouvement enregistré, éclairci</translation>
    </message>
    <message>
        <source>The pelvis stays on the seat, which bears the body</source>
        <translation>Le bassin reste sur le siège, qui porte le corps</translation>
    </message>
    <message>
        <source>The posture is saved</source>
        <translation>La posture est enregistrée</translation>
    </message>
    <message>
        <source>The posture was not saved</source>
        <translation>La posture n'a pas été enregistrée</translation>
    </message>
    <message>
        <source>The posture was not taken</source>
        <translation>La posture n'a pas été prise</translation>
    </message>
    <message>
        <source>The program was ended from outside, or the power failed.</source>
        <translation>Le programme a été arrêté de l’extérieur, ou le courant a manqué.</translation>
    </message>
    <message>
        <source>The program would have %1 moves.</source>
        <translation>Le programme aurait %1 déplacements.</translation>
    </message>
    <message>
        <source>The recording was not read</source>
        <translation>L'enregistrement n'a pas été lu</translation>
    </message>
    <message>
        <source>The report is written</source>
        <translation>Le rapport est écrit</translation>
    </message>
    <message>
        <source>The report was not written</source>
        <translation>Le rapport n'a pas été écrit</translation>
    </message>
    <message>
        <source>The result is not kept</source>
        <translation>Le résultat n'est pas gardé</translation>
    </message>
    <message>
        <source>The right arm is supported</source>
        <translation>Le bras droit est appuyé</translation>
    </message>
    <message>
        <source>The right hand is %1 from the end of its reach</source>
        <translation>La main droite est à %1 de la fin de sa portée</translation>
    </message>
    <message>
        <source>The right hand is %1 short.</source>
        <translation>Il manque %1 à la main droite.</translation>
    </message>
    <message>
        <source>The robot cannot reach the frame: it stays up to %1 or %2 beside it</source>
        <translation>Le robot n’atteint pas l’image : il reste jusqu’à %1 ou %2 à côté</translation>
    </message>
    <message>
        <source>The robot stands so now.</source>
        <translation>Le robot se tient ainsi maintenant.</translation>
    </message>
    <message>
        <source>The robot was not added</source>
        <translation>Le robot n'a pas été ajouté</translation>
    </message>
    <message>
        <source>The robot's tool centre point</source>
        <translation>Le centre outil du robot</translation>
    </message>
    <message>
        <source>The run cannot be replayed later</source>
        <translation>L'essai ne pourra pas être rejoué</translation>
    </message>
    <message>
        <source>The run has no frames: take the part with the stylus and move it.</source>
        <translation>L'essai n'a pas d'images : prenez la pièce avec le stylet et déplacez-la.</translation>
    </message>
    <message>
        <source>The sample was not added</source>
        <translation>L'exemple n'a pas été ajouté</translation>
    </message>
    <message>
        <source>The scene</source>
        <translation>La scène</translation>
    </message>
    <message>
        <source>The scene in words</source>
        <translation>La scène en mots</translation>
    </message>
    <message>
        <source>The scene's loop stands still: forces return once it answers</source>
        <translation>La boucle de la scène est arrêtée : les forces reviennent dès qu'elle répond</translation>
    </message>
    <message>
        <source>The scores are partial: %1 not entered. Task data… completes them.</source>
        <translation>Les notes sont partielles ; à saisir dans Données de la tâche… : %1.</translation>
    </message>
    <message>
        <source>The second stylus is gone. Choose it again to start it.</source>
        <translation>Le second stylet n'est plus là. Choisissez-le de nouveau pour le démarrer.</translation>
    </message>
    <message>
        <source>The server took them away: let the stylus go free, or turn them off (Esc) and on again (Ctrl+Space)</source>
        <translation>Le serveur les a coupés : libérez le stylet, ou désactivez-les (Échap) puis réactivez-les (Ctrl+Espace)</translation>
    </message>
    <message>
        <source>The simulated stylus needs none.</source>
        <translation>Le stylet simulé n'en a pas besoin.</translation>
    </message>
    <message>
        <source>The size was not changed</source>
        <translation>La dimension n'a pas été changée</translation>
    </message>
    <message>
        <source>The stylus button must stay pressed to move</source>
        <translation>Le bouton du stylet doit rester appuyé pour déplacer</translation>
    </message>
    <message>
        <source>The stylus button: grabs and releases</source>
        <translation>Le bouton du stylet : saisit et lâche</translation>
    </message>
    <message>
        <source>The stylus follows the mouse · wheel: depth · Ctrl: turn · left button %1 · H: end</source>
        <translation>Le stylet suit la souris · molette : profondeur · Ctrl : tourner · bouton gauche %1 · H : terminer</translation>
    </message>
    <message>
        <source>The stylus is as it was</source>
        <translation>Le stylet est comme avant</translation>
    </message>
    <message>
        <source>The stylus is in its inkwell.</source>
        <translation>Le stylet est dans son encrier.</translation>
    </message>
    <message>
        <source>The stylus will be pulled down, slowly up to %1 N, for four seconds. Hold it loosely in the middle of its workspace. What you hold in the cell is let go first.</source>
        <translation>Le stylet sera tiré vers le bas, lentement jusqu'à %1 N, pendant quatre secondes. Tenez-le sans serrer au milieu de son espace. Ce que vous tenez dans la cellule est lâché avant.</translation>
    </message>
    <message>
        <source>The task is no lift; the forces stand below.</source>
        <translation>La tâche n'est pas un levage ; les efforts sont ci-dessous.</translation>
    </message>
    <message>
        <source>The test was stopped.</source>
        <translation>L'essai a été arrêté.</translation>
    </message>
    <message>
        <source>The ticked parts move, and what is attached to them: %1. Everything else stays.</source>
        <translation>Les pièces cochées bougent, avec ce qui leur est attaché : %1. Tout le reste ne bouge pas.</translation>
    </message>
    <message>
        <source>The ticked parts move; everything else stays.</source>
        <translation>Les pièces cochées bougent ; tout le reste ne bouge pas.</translation>
    </message>
    <message>
        <source>The trunk is supported (backrest)</source>
        <translation>Le tronc est appuyé (dossier)</translation>
    </message>
    <message>
        <source>The unsaved changes of %1 are lost for good if its copy is discarded.</source>
        <translation>Les modifications non enregistrées de %1 sont perdues pour de bon si sa copie est supprimée.</translation>
    </message>
    <message>
        <source>The workcell was not saved</source>
        <translation>La cellule n'a pas été enregistrée</translation>
    </message>
    <message>
        <source>The workplace was not searched</source>
        <translation>Le poste de travail n'a pas été cherché</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thème</translation>
    </message>
    <message>
        <source>There is an exercise of this name: choose another.</source>
        <translation>Un exercice porte déjà ce nom : choisissez-en un autre.</translation>
    </message>
    <message>
        <source>There is no %1 in this cell.</source>
        <translation>Il n'y a pas de %1 dans cette cellule.</translation>
    </message>
    <message>
        <source>There is no frame '%1' to move along; the cell's axes are used</source>
        <translation>Il n'y a pas de repère « %1 » à suivre ; les axes de la cellule sont utilisés</translation>
    </message>
    <message>
        <source>There is no motion below this one.</source>
        <translation>Il n'y a pas de mouvement sous celui-ci.</translation>
    </message>
    <message>
        <source>There is no practice yet that could be retained: practise first.</source>
        <translation>Il n'y a pas encore d'entraînement à retenir : entraînez-vous d'abord.</translation>
    </message>
    <message>
        <source>There was not enough memory</source>
        <translation>La mémoire n'a pas suffi</translation>
    </message>
    <message>
        <source>There was not enough memory to prepare the contacts: what was changed is not felt. Remove large parts</source>
        <translation>La mémoire n'a pas suffi pour préparer les contacts : ce qui a changé n'est pas senti. Retirez de grandes pièces</translation>
    </message>
    <message>
        <source>These are the markers of %1. Mannequin, Open a recorded motion, puts the recording on the figure.</source>
        <translation>Ce sont les marqueurs de %1. Mannequin, Ouvrir un mouvement enregistré, les pose sur le mannequin.</translation>
    </message>
    <message>
        <source>These parts may move, with the hands' targets</source>
        <translation>Ces pièces peuvent bouger, avec les cibles des mains</translation>
    </message>
    <message>
        <source>They are lost if they are not saved.</source>
        <translation>Ils sont perdus s'ils ne sont pas enregistrés.</translation>
    </message>
    <message>
        <source>They hang %1 above it: lower the seat or put a rest under them.</source>
        <translation>Ils pendent à %1 au-dessus : abaissez le siège ou mettez un repose-pieds.</translation>
    </message>
    <message>
        <source>They move together, about the one chosen last.</source>
        <translation>Elles bougent ensemble, autour de celle choisie en dernier.</translation>
    </message>
    <message>
        <source>Thigh clearance</source>
        <translation>Épaisseur de la cuisse</translation>
    </message>
    <message>
        <source>This cell has no frame yet: Insert, Frame makes one</source>
        <translation>Cette cellule n'a pas encore de repère : Insérer, Repère en pose un</translation>
    </message>
    <message>
        <source>This device exerts no force.</source>
        <translation>Ce périphérique n'exerce pas d'effort.</translation>
    </message>
    <message>
        <source>This device moves things, but exerts no force</source>
        <translation>Ce périphérique déplace, mais n'exerce pas d'effort</translation>
    </message>
    <message>
        <source>This entity has no frames</source>
        <translation>Cette entité n'a pas de repère</translation>
    </message>
    <message>
        <source>This exercise was practised: transfer is shown at another one, here choose Retention.</source>
        <translation>Cet exercice a été pratiqué : le transfert se montre sur un autre ; ici, choisissez Rétention.</translation>
    </message>
    <message>
        <source>This motion and the one below it, one after the other</source>
        <translation>Ce mouvement et celui du dessous, l'un après l'autre</translation>
    </message>
    <message>
        <source>This motion has no joints.</source>
        <translation>Ce mouvement n'a pas d'articulations.</translation>
    </message>
    <message>
        <source>This motion has no way: choose another.</source>
        <translation>Ce mouvement n'a pas de chemin : choisissez-en un autre.</translation>
    </message>
    <message>
        <source>This pair's own choice; click to change it</source>
        <translation>Le choix propre à cette paire ; un clic le change</translation>
    </message>
    <message>
        <source>This picture stands at the head of every report</source>
        <translation>Cette image figure en tête de chaque rapport</translation>
    </message>
    <message>
        <source>This place does not keep what the search found</source>
        <translation>Cet emplacement ne tient pas ce que la recherche avait trouvé</translation>
    </message>
    <message>
        <source>This pose is out of reach</source>
        <translation>Cette pose est hors d'atteinte</translation>
    </message>
    <message>
        <source>This solid has no frame yet: make one below</source>
        <translation>Ce solide n'a pas encore de repère : créez-en un ci-dessous</translation>
    </message>
    <message>
        <source>This station</source>
        <translation>Ce poste</translation>
    </message>
    <message>
        <source>This station has no key for the haptic server at %1.</source>
        <translation>Ce poste n'a pas de clé pour le serveur haptique à %1.</translation>
    </message>
    <message>
        <source>Through entity</source>
        <translation>Par l'entité</translation>
    </message>
    <message>
        <source>Through its eyes</source>
        <translation>Par ses yeux</translation>
    </message>
    <message>
        <source>Through the mannequin's eyes</source>
        <translation>Par les yeux du mannequin</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Time bar</source>
        <translation>Barre de temps</translation>
    </message>
    <message>
        <source>Time in which the greatest acceleration is reached</source>
        <translation>Temps en lequel la plus grande accélération est atteinte</translation>
    </message>
    <message>
        <source>Time s</source>
        <translation>Temps s</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Times the expert's time that cost all its points</source>
        <translation>Multiple du temps de l'expert qui coûte tous ses points</translation>
    </message>
    <message>
        <source>Timing</source>
        <translation>Minutage</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>To the beginning</source>
        <translation>Au début</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>À la fin</translation>
    </message>
    <message>
        <source>To, fro ±</source>
        <translation>Vers, depuis ±</translation>
    </message>
    <message>
        <source>Told once the figure rests</source>
        <translation>Dit dès que le corps est au repos</translation>
    </message>
    <message>
        <source>Too heavy: %1 of %2 allowed</source>
        <translation>Trop lourd : %1 pour %2 admis</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Outil</translation>
    </message>
    <message>
        <source>Tool centre point</source>
        <translation>Centre outil</translation>
    </message>
    <message>
        <source>Tool centre points</source>
        <translation>Centres outil</translation>
    </message>
    <message>
        <source>Tool, base and safety stay the controller's own</source>
        <translation>Outil, base et sécurité restent ceux de la commande</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Tools and carried parts…</source>
        <translation>Outils et pièces portées…</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>Touch something with forces on: how long after it is felt it is seen is told here</source>
        <translation>Touchez quelque chose avec les forces : ici est dit combien de temps après le ressenti le contact se voit</translation>
    </message>
    <message>
        <source>Touches from the beginning: %1 and %2</source>
        <translation>Se touchent dès le début : %1 et %2</translation>
    </message>
    <message>
        <source>Touchpad</source>
        <translation>Pavé tactile</translation>
    </message>
    <message>
        <source>Train along a motion…</source>
        <translation>S'exercer le long d'un mouvement…</translation>
    </message>
    <message>
        <source>Trainee</source>
        <translation>Élève</translation>
    </message>
    <message>
        <source>Training</source>
        <translation>Entraînement</translation>
    </message>
    <message>
        <source>Training of %1</source>
        <translation>Entraînement de %1</translation>
    </message>
    <message>
        <source>Trajectories</source>
        <translation>Trajectoires</translation>
    </message>
    <message>
        <source>Trajectories (*.htraj *.json *.csv *.yaml *.yml);;Robot programs: KRL, RAPID, FANUC, URScript, INFORM (*.src *.mod *.modx *.prg *.ls *.script *.urscript *.jbi)</source>
        <translation>Trajectoires (*.htraj *.json *.csv *.yaml *.yml);;Programmes de robots : KRL, RAPID, FANUC, URScript, INFORM (*.src *.mod *.modx *.prg *.ls *.script *.urscript *.jbi)</translation>
    </message>
    <message>
        <source>Trajectory</source>
        <translation>Trajectoire</translation>
    </message>
    <message>
        <source>Transfer</source>
        <translation>Transfert</translation>
    </message>
    <message>
        <source>Transfer: %1 points.</source>
        <translation>Transfert : %1 points.</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>Arbre</translation>
    </message>
    <message>
        <source>Tree of %1</source>
        <translation>Arbre de %1</translation>
    </message>
    <message>
        <source>Trim</source>
        <translation>Rogner</translation>
    </message>
    <message>
        <source>Trunk</source>
        <translation>Tronc</translation>
    </message>
    <message>
        <source>Try sitting as well</source>
        <translation>Essayer aussi assis</translation>
    </message>
    <message>
        <source>Trying every placement with four bodies…</source>
        <translation>Essai de chaque place avec quatre corps…</translation>
    </message>
    <message>
        <source>Tube</source>
        <translation>Tube</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Tourner</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>Tourner %1</translation>
    </message>
    <message>
        <source>Turn %1 of %2</source>
        <translation>Tourner %1 de %2</translation>
    </message>
    <message numerus="yes">
        <source>Turn %n entities</source>
        <translation><numerusform>Tourner %n entité</numerusform><numerusform>Tourner %n entités</numerusform></translation>
    </message>
    <message>
        <source>Turn faces outwards</source>
        <translation>Tourner les faces vers l'extérieur</translation>
    </message>
    <message>
        <source>Turn it too: axes along, faces flat</source>
        <translation>Tourner aussi : axes alignés, faces à plat</translation>
    </message>
    <message>
        <source>Turn round</source>
        <translation>Retourner</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Turns about</source>
        <translation>Pivot</translation>
    </message>
    <message>
        <source>Turns its eyes, as far as they go, to the part that was chosen last</source>
        <translation>Tourne ses yeux, autant qu'ils le peuvent, vers la dernière pièce choisie</translation>
    </message>
    <message>
        <source>Turns the view; with Shift it shifts it</source>
        <translation>Tourne la vue ; avec Maj la décale</translation>
    </message>
    <message>
        <source>Two fingers turn; with Shift they shift, with Ctrl they zoom</source>
        <translation>Deux doigts tournent ; avec Maj ils décalent, avec Ctrl ils zooment</translation>
    </message>
    <message>
        <source>Two hands</source>
        <translation>Deux mains</translation>
    </message>
    <message>
        <source>Typing</source>
        <translation>À la frappe</translation>
    </message>
    <message>
        <source>URDF (*.urdf)</source>
        <translation>URDF (*.urdf)</translation>
    </message>
    <message>
        <source>URDF of the one robot (*.urdf)</source>
        <translation>URDF du seul robot (*.urdf)</translation>
    </message>
    <message>
        <source>URDF, xacro, SDF or robot.toml</source>
        <translation>URDF, xacro, SDF ou robot.toml</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Undock</source>
        <translation>Détacher</translation>
    </message>
    <message>
        <source>Undock or dock</source>
        <translation>Détacher ou attacher</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Unités</translation>
    </message>
    <message>
        <source>Units and decimals</source>
        <translation>Unités et décimales</translation>
    </message>
    <message>
        <source>Universal Robots script (.script)</source>
        <translation>Script Universal Robots (.script)</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Déverrouiller</translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <translation>Déverrouiller %1</translation>
    </message>
    <message>
        <source>Unsaved changes, kept up to %1.</source>
        <translation>Modifications non enregistrées, gardées jusqu’au %1.</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Axe vers le haut</translation>
    </message>
    <message>
        <source>Up, down ±</source>
        <translation>Haut, bas ±</translation>
    </message>
    <message>
        <source>Upper arm</source>
        <translation>Bras</translation>
    </message>
    <message>
        <source>Upper stop</source>
        <translation>Butée haute</translation>
    </message>
    <message>
        <source>Use this one</source>
        <translation>Utiliser celui-ci</translation>
    </message>
    <message>
        <source>Video of a turn round it</source>
        <translation>Vidéo d'un tour</translation>
    </message>
    <message>
        <source>Video of a turn round it…</source>
        <translation>Vidéo d'un tour…</translation>
    </message>
    <message>
        <source>Video of the motion</source>
        <translation>Vidéo du mouvement</translation>
    </message>
    <message>
        <source>Video of the motion…</source>
        <translation>Vidéo du mouvement…</translation>
    </message>
    <message>
        <source>Videos, by ffmpeg (*.mp4 *.webm *.mkv *.gif)</source>
        <translation>Vidéos, par ffmpeg (*.mp4 *.webm *.mkv *.gif)</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Vue %1</translation>
    </message>
    <message>
        <source>View, Saved views goes back to it.</source>
        <translation>Vue, Vues gardées y revient.</translation>
    </message>
    <message>
        <source>Views turn smoothly</source>
        <translation>Les vues tournent en douceur</translation>
    </message>
    <message>
        <source>Virtual Desktop</source>
        <translation>Virtual Desktop</translation>
    </message>
    <message>
        <source>Wait here</source>
        <translation>Attendre ici</translation>
    </message>
    <message>
        <source>Waiting for the haptic server</source>
        <translation>En attente du serveur haptique</translation>
    </message>
    <message>
        <source>Waits for the file before it</source>
        <translation>Attend le fichier précédent</translation>
    </message>
    <message>
        <source>Walking</source>
        <translation>Marche</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avertissement</translation>
    </message>
    <message>
        <source>Watching: another window has the stylus</source>
        <translation>Observe : une autre fenêtre a le stylet</translation>
    </message>
    <message>
        <source>Way</source>
        <translation>Chemin</translation>
    </message>
    <message>
        <source>Way of the lift</source>
        <translation>Course du levage</translation>
    </message>
    <message>
        <source>Way there</source>
        <translation>Chemin</translation>
    </message>
    <message>
        <source>Weight of a held part that is not felt</source>
        <translation>Poids d'une pièce tenue qui n'est pas senti</translation>
    </message>
    <message>
        <source>Weight, or a force divided by 9.81</source>
        <translation>Poids, ou une force divisée par 9,81</translation>
    </message>
    <message>
        <source>What answers at %1 is not a haptic server of this release, or one that wants a key (hapticell-cli pair).</source>
        <translation>Ce qui répond à %1 n'est pas un serveur haptique de cette version, ou en est un qui exige une clé (hapticell-cli pair).</translation>
    </message>
    <message>
        <source>What answers at %1 is not a haptic server of this release.</source>
        <translation>Ce qui répond à %1 n'est pas un serveur haptique de cette version.</translation>
    </message>
    <message>
        <source>What brings it down is told once the figure rests.</source>
        <translation>Ce qui l'abaisse est dit dès que le corps est au repos.</translation>
    </message>
    <message>
        <source>What brings it down: %1.</source>
        <translation>Ce qui l'abaisse : %1.</translation>
    </message>
    <message>
        <source>What broke: %1</source>
        <translation>Ce qui a cassé : %1</translation>
    </message>
    <message>
        <source>What costs most first: %1.</source>
        <translation>Les plus coûteux d'abord : %1.</translation>
    </message>
    <message>
        <source>What is held</source>
        <translation>Ce qui est tenu</translation>
    </message>
    <message>
        <source>What is held is not checked for collision</source>
        <translation>Ce qui est tenu n'est pas vérifié pour les collisions</translation>
    </message>
    <message>
        <source>What is held stays where it is. Once a server answers again, Ctrl+Space turns the forces on.</source>
        <translation>Ce qui est tenu reste où il est. Dès qu’un serveur répond, Ctrl+Espace remet les forces.</translation>
    </message>
    <message>
        <source>What is kept where a wrist would have to swing round faster than it can</source>
        <translation>Ce qui est gardé où un poignet devrait tourner plus vite qu'il ne peut</translation>
    </message>
    <message>
        <source>What is picked</source>
        <translation>Ce qui est désigné</translation>
    </message>
    <message>
        <source>What it sees</source>
        <translation>Ce qu'il voit</translation>
    </message>
    <message>
        <source>What it sees of it</source>
        <translation>Ce qu'il en voit</translation>
    </message>
    <message>
        <source>What the 3-D mouse moves; its second button changes it</source>
        <translation>Ce que la souris 3D déplace ; son second bouton le change</translation>
    </message>
    <message>
        <source>What the check found</source>
        <translation>Ce que la vérification a trouvé</translation>
    </message>
    <message>
        <source>What the tip touches</source>
        <translation>Ce que touche la pointe</translation>
    </message>
    <message>
        <source>What the trainee is to do</source>
        <translation>Ce que l'élève doit faire</translation>
    </message>
    <message>
        <source>What you asked for last was not done, and the workcell is as it was before. Save it, then close other programs, or remove parts that are not needed.</source>
        <translation>Ce que vous avez demandé en dernier n'a pas été fait, et la cellule est comme avant. Enregistrez-la, puis fermez d'autres programmes ou retirez les pièces inutiles.</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Molette</translation>
    </message>
    <message>
        <source>Wheel and touchpad</source>
        <translation>Molette et pavé tactile</translation>
    </message>
    <message>
        <source>Wheel the other way round</source>
        <translation>Molette dans l'autre sens</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Quand</translation>
    </message>
    <message>
        <source>Where it snaps in, several with spaces between</source>
        <translation>Où il s'enclenche, plusieurs séparés par des espaces</translation>
    </message>
    <message>
        <source>Where it stands</source>
        <translation>Où elle se pose</translation>
    </message>
    <message>
        <source>Where it stands now</source>
        <translation>Où il est maintenant</translation>
    </message>
    <message>
        <source>Where its base stands</source>
        <translation>Où se tient sa base</translation>
    </message>
    <message>
        <source>Where the missing files are</source>
        <translation>Où sont les fichiers manquants</translation>
    </message>
    <message>
        <source>Where the stylus is plugged in and its haptic server runs</source>
        <translation>Là où le stylet est branché et où tourne son serveur haptique</translation>
    </message>
    <message>
        <source>While dragging</source>
        <translation>Pendant le glissement</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>Entier</translation>
    </message>
    <message>
        <source>Whole figure</source>
        <translation>Corps entier</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenêtre</translation>
    </message>
    <message>
        <source>With size and time</source>
        <translation>Avec taille et date</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>Dans</translation>
    </message>
    <message>
        <source>Without guidance, a day and a week after practice.</source>
        <translation>Sans guidage, un jour et une semaine après l'entraînement.</translation>
    </message>
    <message>
        <source>Without guidance, a day and a week after practice. Last practice: %1 ago.</source>
        <translation>Sans guidage, un jour et une semaine après l'entraînement. Dernier : il y a %1.</translation>
    </message>
    <message>
        <source>Without guidance, at an exercise that was not practised.</source>
        <translation>Sans guidage, sur un exercice qui n'a pas été pratiqué.</translation>
    </message>
    <message>
        <source>Woman</source>
        <translation>Femme</translation>
    </message>
    <message>
        <source>Woman, %1, %2 kg</source>
        <translation>Femme, %1, %2 kg</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Travail</translation>
    </message>
    <message>
        <source>Workcell</source>
        <translation>Cellule</translation>
    </message>
    <message>
        <source>Workcells (*.hcell)</source>
        <translation>Cellules (*.hcell)</translation>
    </message>
    <message>
        <source>Workcells (*.hcell);;All files (*)</source>
        <translation>Cellules (*.hcell);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Working zones (as EN ISO 14738)</source>
        <translation>Zones de travail (d'après EN ISO 14738)</translation>
    </message>
    <message>
        <source>Workplace search</source>
        <translation>Chercher le poste</translation>
    </message>
    <message>
        <source>World</source>
        <translation>Monde</translation>
    </message>
    <message>
        <source>Worst RULA by height and distance</source>
        <translation>Pire RULA selon hauteur et distance</translation>
    </message>
    <message>
        <source>Worst RULA of four bodies</source>
        <translation>Pire RULA de quatre corps</translation>
    </message>
    <message>
        <source>Worst phase</source>
        <translation>Pire phase</translation>
    </message>
    <message>
        <source>Write all moves</source>
        <translation>Écrire tous les déplacements</translation>
    </message>
    <message>
        <source>Write it as a file or a robot's program</source>
        <translation>L'écrire comme fichier ou programme de robot</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Écrire le rapport</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>Écriture de %1</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Écrit : %1</translation>
    </message>
    <message>
        <source>Written: %1; frames: %2. Tool, base and safety are the controller's own: check them there</source>
        <translation>Écrit : %1 ; images : %2. Outil, base et sécurité sont ceux de la commande : vérifiez-les là</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>X Y Z</source>
        <translation>X Y Z</translation>
    </message>
    <message>
        <source>X Y Z in %1 · A B C in %2</source>
        <translation>X Y Z en %1 · A B C en %2</translation>
    </message>
    <message>
        <source>X, width</source>
        <translation>X, largeur</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Y, depth</source>
        <translation>Y, profondeur</translation>
    </message>
    <message>
        <source>Yaskawa Motoman INFORM (.jbi)</source>
        <translation>Yaskawa Motoman INFORM (.jbi)</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Oui</translation>
    </message>
    <message>
        <source>Your own</source>
        <translation>À vous</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Z, height</source>
        <translation>Z, hauteur</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>Zéro</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Zoom to the pointer</source>
        <translation>Zoomer vers le pointeur</translation>
    </message>
    <message>
        <source>Zooms to the pointer</source>
        <translation>Zoome vers le pointeur</translation>
    </message>
    <message>
        <source>a high risk</source>
        <translation>un risque élevé</translation>
    </message>
    <message>
        <source>a raised risk for some</source>
        <translation>un risque accru pour certains</translation>
    </message>
    <message>
        <source>about </source>
        <translation>environ </translation>
    </message>
    <message>
        <source>acceptable for nearly all</source>
        <translation>acceptable pour presque tous</translation>
    </message>
    <message>
        <source>against</source>
        <translation>contre</translation>
    </message>
    <message>
        <source>along %1</source>
        <translation>le long de %1</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>et %1 de plus</translation>
    </message>
    <message>
        <source>another clicked</source>
        <translation>un autre cliqué</translation>
    </message>
    <message>
        <source>as it is held</source>
        <translation>comme il est tenu</translation>
    </message>
    <message>
        <source>at work</source>
        <translation>au travail</translation>
    </message>
    <message>
        <source>back</source>
        <translation>derrière</translation>
    </message>
    <message>
        <source>being read</source>
        <translation>en lecture</translation>
    </message>
    <message>
        <source>best %1</source>
        <translation>meilleur %1</translation>
    </message>
    <message>
        <source>borne by the seat</source>
        <translation>porté par le siège</translation>
    </message>
    <message>
        <source>by %1</source>
        <translation>de %1</translation>
    </message>
    <message>
        <source>centimetre</source>
        <translation>centimètre</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>centre</translation>
    </message>
    <message>
        <source>centre of mass</source>
        <translation>centre de masse</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>changée</translation>
    </message>
    <message>
        <source>check cancelled</source>
        <translation>vérification interrompue</translation>
    </message>
    <message>
        <source>checked</source>
        <translation>vérifié</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>fermé</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>contact</translation>
    </message>
    <message>
        <source>contacts felt: %1</source>
        <translation>contacts sentis : %1</translation>
    </message>
    <message>
        <source>contacts: %1</source>
        <translation>contacts : %1</translation>
    </message>
    <message>
        <source>d MMM yyyy, HH:mm</source>
        <translation>d MMM yyyy, HH:mm</translation>
    </message>
    <message>
        <source>d MMMM yyyy, HH:mm:ss</source>
        <translation>d MMMM yyyy, HH:mm:ss</translation>
    </message>
    <message>
        <source>d MMMM, HH:mm</source>
        <translation>d MMMM, HH:mm</translation>
    </message>
    <message>
        <source>down</source>
        <translation>bas</translation>
    </message>
    <message>
        <source>enter the grip in Task data.</source>
        <translation>saisissez la prise dans Données de la tâche.</translation>
    </message>
    <message>
        <source>enter the hours in a shift in Task data.</source>
        <translation>saisissez les heures par poste dans Données de la tâche.</translation>
    </message>
    <message>
        <source>enter the load in Task data.</source>
        <translation>saisissez la charge dans Données de la tâche.</translation>
    </message>
    <message>
        <source>enter the repetition in Task data.</source>
        <translation>saisissez la répétition dans Données de la tâche.</translation>
    </message>
    <message>
        <source>file missing</source>
        <translation>fichier manquant</translation>
    </message>
    <message>
        <source>final %1. Bound rule: an inner boundary belongs to the lower class.</source>
        <translation>finale %1. Règle des bornes : une borne intérieure appartient à la classe inférieure.</translation>
    </message>
    <message>
        <source>flip</source>
        <translation>ret.</translation>
    </message>
    <message>
        <source>foot</source>
        <translation>pied</translation>
    </message>
    <message>
        <source>force</source>
        <translation>effort</translation>
    </message>
    <message>
        <source>forces off</source>
        <translation>coupe les efforts</translation>
    </message>
    <message>
        <source>frame %1 ms</source>
        <translation>image %1 ms</translation>
    </message>
    <message>
        <source>frame moved</source>
        <translation>image déplacée</translation>
    </message>
    <message>
        <source>frames: %1</source>
        <translation>images : %1</translation>
    </message>
    <message>
        <source>free gap</source>
        <translation>espace libre</translation>
    </message>
    <message>
        <source>free of contact</source>
        <translation>sans contact</translation>
    </message>
    <message>
        <source>free to move</source>
        <translation>libre</translation>
    </message>
    <message>
        <source>front</source>
        <translation>devant</translation>
    </message>
    <message>
        <source>further away</source>
        <translation>plus loin</translation>
    </message>
    <message>
        <source>gaze down</source>
        <translation>regard vers le bas</translation>
    </message>
    <message>
        <source>gaze to the left</source>
        <translation>regard vers la gauche</translation>
    </message>
    <message>
        <source>glTF (*.glb)</source>
        <translation>glTF (*.glb)</translation>
    </message>
    <message>
        <source>grabs</source>
        <translation>saisit</translation>
    </message>
    <message>
        <source>h</source>
        <translation>h</translation>
    </message>
    <message>
        <source>held</source>
        <translation>tenu</translation>
    </message>
    <message>
        <source>held now</source>
        <translation>tenu maintenant</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>caché</translation>
    </message>
    <message>
        <source>hold: clutch</source>
        <translation>tenu : débrayer</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>au repos</translation>
    </message>
    <message>
        <source>in balance</source>
        <translation>en équilibre</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>pouce</translation>
    </message>
    <message>
        <source>inverse: %1</source>
        <translation>inverse : %1</translation>
    </message>
    <message>
        <source>it needs a grip that is good, fair or poor.</source>
        <translation>il lui faut une prise bonne, moyenne ou mauvaise.</translation>
    </message>
    <message>
        <source>joined</source>
        <translation>joint</translation>
    </message>
    <message>
        <source>joints: %1</source>
        <translation>articulations : %1</translation>
    </message>
    <message>
        <source>kg</source>
        <translation>kg</translation>
    </message>
    <message>
        <source>known</source>
        <translation>connu</translation>
    </message>
    <message>
        <source>late %1 ms</source>
        <translation>retard %1 ms</translation>
    </message>
    <message>
        <source>least gap %1 at %2 s</source>
        <translation>distance minimale %1 à %2 s</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>écarté</translation>
    </message>
    <message>
        <source>lets go</source>
        <translation>lâche</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>butée</translation>
    </message>
    <message>
        <source>limits passed: %1</source>
        <translation>limites dépassées : %1</translation>
    </message>
    <message>
        <source>links of %1 that touch at rest are not checked against each other: %2</source>
        <translation>les segments de %1 qui se touchent au repos ne sont pas vérifiés entre eux : %2</translation>
    </message>
    <message>
        <source>links of %1 that touch at rest are not checked against each other: %2 and %3 more pairs</source>
        <translation>les segments de %1 qui se touchent au repos ne sont pas vérifiés entre eux : %2 et %3 autres paires</translation>
    </message>
    <message>
        <source>live, both sides, %1 µs a posture · left RULA %2, right %3 · EAWS outline %4 points</source>
        <translation>en direct, deux côtés, %1 µs par posture · RULA gauche %2, droite %3 · EAWS en aperçu %4 points</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>verrouillé</translation>
    </message>
    <message>
        <source>locked in place</source>
        <translation>verrouillé sur place</translation>
    </message>
    <message>
        <source>metre</source>
        <translation>mètre</translation>
    </message>
    <message>
        <source>millimetre</source>
        <translation>millimètre</translation>
    </message>
    <message>
        <source>mirrored</source>
        <translation>en miroir</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>mm a turn</source>
        <translation>mm par tour</translation>
    </message>
    <message>
        <source>mm wide</source>
        <translation>mm de large</translation>
    </message>
    <message>
        <source>mm/s</source>
        <translation>mm/s</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>name</source>
        <translation>nom</translation>
    </message>
    <message>
        <source>near a singularity %1 would have to swing round</source>
        <translation>près d'une singularité, %1 devrait basculer</translation>
    </message>
    <message>
        <source>near miss</source>
        <translation>quasi-contact</translation>
    </message>
    <message>
        <source>needs none</source>
        <translation>n'en demande pas</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>no device</source>
        <translation>pas de périphérique</translation>
    </message>
    <message>
        <source>no flip</source>
        <translation>non ret.</translation>
    </message>
    <message>
        <source>no gap</source>
        <translation>pas de distance</translation>
    </message>
    <message>
        <source>no load is acceptable</source>
        <translation>aucune charge n'est acceptable</translation>
    </message>
    <message>
        <source>no path</source>
        <translation>aucun chemin</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>none in the task</source>
        <translation>aucun dans la tâche</translation>
    </message>
    <message>
        <source>none near</source>
        <translation>rien de proche</translation>
    </message>
    <message>
        <source>none; e.g. %1</source>
        <translation>aucun ; p. ex. %1</translation>
    </message>
    <message>
        <source>not checked</source>
        <translation>non vérifié</translation>
    </message>
    <message>
        <source>not near</source>
        <translation>pas proche</translation>
    </message>
    <message>
        <source>not picked</source>
        <translation>non désignée</translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>pas encore enregistrée</translation>
    </message>
    <message>
        <source>now</source>
        <translation>maintenant</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>maintenant %1</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>de %1</translation>
    </message>
    <message>
        <source>of reach left</source>
        <translation>d'atteinte restante</translation>
    </message>
    <message>
        <source>off</source>
        <translation>arrêt</translation>
    </message>
    <message>
        <source>on X = 0</source>
        <translation>sur X = 0</translation>
    </message>
    <message>
        <source>on Y = 0</source>
        <translation>sur Y = 0</translation>
    </message>
    <message>
        <source>on Z = 0</source>
        <translation>sur Z = 0</translation>
    </message>
    <message>
        <source>on contact</source>
        <translation>au contact</translation>
    </message>
    <message>
        <source>only one hand bears the load; it judges lifts with both hands. Use RULA or REBA.</source>
        <translation>une seule main porte la charge ; elle juge les levages à deux mains. Utilisez RULA ou REBA.</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>origine</translation>
    </message>
    <message>
        <source>out of balance</source>
        <translation>hors d'équilibre</translation>
    </message>
    <message>
        <source>part</source>
        <translation>pièce</translation>
    </message>
    <message>
        <source>partial: none entered for this place</source>
        <translation>partiel : aucune entrée pour cet endroit</translation>
    </message>
    <message>
        <source>parts</source>
        <translation>pièces</translation>
    </message>
    <message>
        <source>points</source>
        <translation>points</translation>
    </message>
    <message>
        <source>points reordered</source>
        <translation>points réordonnés</translation>
    </message>
    <message>
        <source>re-timed</source>
        <translation>nouveaux temps</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>enregistrement</translation>
    </message>
    <message>
        <source>resampled</source>
        <translation>rééchantillonné</translation>
    </message>
    <message>
        <source>results.pdf</source>
        <translation>resultats.pdf</translation>
    </message>
    <message>
        <source>reversed</source>
        <translation>inversé</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>saved</source>
        <translation>enregistrée</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>échelle</translation>
    </message>
    <message>
        <source>share of the limit</source>
        <translation>part de la limite</translation>
    </message>
    <message>
        <source>simplified</source>
        <translation>simplifié</translation>
    </message>
    <message>
        <source>singular places, changes of configuration: %1</source>
        <translation>places singulières, changements de configuration : %1</translation>
    </message>
    <message>
        <source>sitting</source>
        <translation>assis</translation>
    </message>
    <message>
        <source>smoothed</source>
        <translation>lissé</translation>
    </message>
    <message>
        <source>split</source>
        <translation>coupé</translation>
    </message>
    <message>
        <source>standing</source>
        <translation>debout</translation>
    </message>
    <message>
        <source>step %1 ms</source>
        <translation>pas %1 ms</translation>
    </message>
    <message>
        <source>stop, slide, pass</source>
        <translation>arrêter, glisser, traverser</translation>
    </message>
    <message>
        <source>stylus button</source>
        <translation>bouton du stylet</translation>
    </message>
    <message>
        <source>the arm is at the edge of its reach</source>
        <translation>le bras est au bord de son atteinte</translation>
    </message>
    <message>
        <source>the controller's</source>
        <translation>ceux de la commande</translation>
    </message>
    <message>
        <source>the equation covers shifts of up to 8 h.</source>
        <translation>l'équation vaut pour des postes de 8 h au plus.</translation>
    </message>
    <message>
        <source>the figure sits or kneels; it judges lifts while standing. Use RULA or REBA.</source>
        <translation>la personne est assise ou à genoux ; elle juge les levages debout. Utilisez RULA ou REBA.</translation>
    </message>
    <message>
        <source>the lift and the forces</source>
        <translation>le levage et les efforts</translation>
    </message>
    <message>
        <source>the placements of the imported files</source>
        <translation>les places des fichiers importés</translation>
    </message>
    <message>
        <source>the top</source>
        <translation>le haut</translation>
    </message>
    <message>
        <source>times</source>
        <translation>fois</translation>
    </message>
    <message>
        <source>to device edge</source>
        <translation>jusqu'au bord</translation>
    </message>
    <message>
        <source>touches %1</source>
        <translation>touche %1</translation>
    </message>
    <message>
        <source>trainee</source>
        <translation>élève</translation>
    </message>
    <message>
        <source>trimmed</source>
        <translation>rogné</translation>
    </message>
    <message>
        <source>trunk free</source>
        <translation>tronc libre</translation>
    </message>
    <message>
        <source>trunk locked</source>
        <translation>tronc bloqué</translation>
    </message>
    <message>
        <source>turn on</source>
        <translation>mettre en marche</translation>
    </message>
    <message>
        <source>turns about %1</source>
        <translation>tourne autour de %1</translation>
    </message>
    <message>
        <source>under 1 s</source>
        <translation>moins de 1 s</translation>
    </message>
    <message>
        <source>undone</source>
        <translation>annulé</translation>
    </message>
    <message>
        <source>up</source>
        <translation>haut</translation>
    </message>
    <message>
        <source>what the motion moves</source>
        <translation>ce que le mouvement déplace</translation>
    </message>
    <message>
        <source>with a frame</source>
        <translation>avec une image</translation>
    </message>
    <message>
        <source>with a wait</source>
        <translation>avec une attente</translation>
    </message>
    <message>
        <source>with approach</source>
        <translation>avec approche</translation>
    </message>
    <message>
        <source>with retract</source>
        <translation>avec retrait</translation>
    </message>
    <message>
        <source>without a frame</source>
        <translation>sans une image</translation>
    </message>
    <message>
        <source>without a part</source>
        <translation>sans une partie</translation>
    </message>
    <message>
        <source>worst RULA %1 (P5 woman %2, P50 woman %3, P50 man %4, P95 man %5).</source>
        <translation>pire RULA %1 (femme P5 %2, femme P50 %3, homme P50 %4, homme P95 %5).</translation>
    </message>
    <message>
        <source>x, y, z</source>
        <translation>x, y, z</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>× %1</source>
        <translation>× %1</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
</context>
<context>
    <name>Ergonomics</name>
    <message>
        <source>%1 %2 to %3</source>
        <translation>%1 %2 à %3</translation>
    </message>
    <message>
        <source>%1 gives %2</source>
        <translation>%1 donne %2</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 points</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>%1: lifting index at most %2</source>
        <translation>%1 : indice de levage d'au plus %2</translation>
    </message>
    <message>
        <source>%1; shown at %2 s</source>
        <translation>%1 ; montrée à %2 s</translation>
    </message>
    <message>
        <source>1.3.6, posture outline only</source>
        <translation>1.3.6, esquisse de la posture</translation>
    </message>
    <message>
        <source>Acceptable</source>
        <translation>Acceptable</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>As it stands in the cell.</source>
        <translation>Comme elle se tient dans la cellule.</translation>
    </message>
    <message>
        <source>Assessed by</source>
        <translation>Évalué par</translation>
    </message>
    <message>
        <source>Best place: %1 mm up, %2 mm away, %3; RULA %4</source>
        <translation>Meilleure place : %1 mm en hauteur, %2 mm en profondeur, %3; RULA %4</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Corps</translation>
    </message>
    <message>
        <source>Body size</source>
        <translation>Gabarit</translation>
    </message>
    <message>
        <source>Boundaries: an inner boundary belongs to the lower class; the last class of RULA includes its boundary.</source>
        <translation>Limites : une limite intérieure appartient à la classe inférieure ; la dernière classe de RULA comprend sa limite.</translation>
    </message>
    <message>
        <source>Change now</source>
        <translation>À changer maintenant</translation>
    </message>
    <message>
        <source>Change soon</source>
        <translation>À changer bientôt</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Condition</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Driven by (with that alone)</source>
        <translation>Déterminé par (cela seul changé)</translation>
    </message>
    <message>
        <source>Driver</source>
        <translation>Cause</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Effort</translation>
    </message>
    <message>
        <source>Forces on the hands</source>
        <translation>Efforts aux mains</translation>
    </message>
    <message>
        <source>Four bodies at the same task</source>
        <translation>Quatre corps à la même tâche</translation>
    </message>
    <message>
        <source>Held for over a minute: %1</source>
        <translation>Posture tenue plus d'une minute : %1</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Articulation</translation>
    </message>
    <message>
        <source>Joint angles</source>
        <translation>Angles des articulations</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Niveau</translation>
    </message>
    <message>
        <source>Lifting</source>
        <translation>Levage</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Limite</translation>
    </message>
    <message>
        <source>Load left %1, right %2</source>
        <translation>Charge gauche %1, droite %2</translation>
    </message>
    <message>
        <source>Look into it</source>
        <translation>À examiner</translation>
    </message>
    <message>
        <source>Measured angles of trunk, neck and wrist are neutral within 5° of 0; RULA's neck in extension: class 2 up to 6.5°, 3 up to 8°, beyond 4 (this program's choice).</source>
        <translation>Angles mesurés de tronc, cou et poignet : neutres à moins de 5° de 0 ; extension du cou pour RULA : classe 2 jusqu'à 6,5°, 3 jusqu'à 8°, 4 au-delà (choix de ce programme).</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Method and limits of this report</source>
        <translation>Méthode et limites de ce rapport</translation>
    </message>
    <message>
        <source>Moved, and nothing else: %1</source>
        <translation>Déplacé, et rien d'autre : %1</translation>
    </message>
    <message>
        <source>Nearest place of the work</source>
        <translation>Place du travail la plus proche</translation>
    </message>
    <message>
        <source>Nearest posture of the next lower level</source>
        <translation>Posture la plus proche du niveau inférieur</translation>
    </message>
    <message>
        <source>No arm is supported.</source>
        <translation>Aucun bras n'est soutenu.</translation>
    </message>
    <message>
        <source>No change of the posture alone lowers the level.</source>
        <translation>Aucun changement de la posture seule n'abaisse le niveau.</translation>
    </message>
    <message>
        <source>No change of this lift alone lowers the level.</source>
        <translation>Aucun changement de ce levage seul n'abaisse le niveau.</translation>
    </message>
    <message>
        <source>No place was found that suits all four bodies.</source>
        <translation>Aucune place ne convient aux quatre corps.</translation>
    </message>
    <message>
        <source>Over the recorded motion</source>
        <translation>Au fil du mouvement enregistré</translation>
    </message>
    <message>
        <source>Own limits:</source>
        <translation>Limites propres :</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Partie</translation>
    </message>
    <message>
        <source>Partial: no own limit of the hands' force is entered for this place.</source>
        <translation>Partiel : aucune limite propre de l'effort aux mains n'est entrée pour cet endroit.</translation>
    </message>
    <message>
        <source>Posture assessment</source>
        <translation>Évaluation de la posture</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Atteinte</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Raison</translation>
    </message>
    <message>
        <source>Repetitions %1, shift %2</source>
        <translation>Répétitions %1, durée %2</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Cote</translation>
    </message>
    <message>
        <source>Search of the workplace</source>
        <translation>Recherche du poste</translation>
    </message>
    <message>
        <source>Signature</source>
        <translation>Signature</translation>
    </message>
    <message>
        <source>Source of the posture: %1</source>
        <translation>Origine de la posture : %1</translation>
    </message>
    <message>
        <source>Standards and editions: %1</source>
        <translation>Normes et éditions : %1</translation>
    </message>
    <message>
        <source>Stature</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Sub-scores</source>
        <translation>Cotes partielles</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Tâche</translation>
    </message>
    <message>
        <source>Task assessment</source>
        <translation>Évaluation de la tâche</translation>
    </message>
    <message>
        <source>The %1 scores %2: %3.</source>
        <translation>Cause : %1, note %2 (%3).</translation>
    </message>
    <message>
        <source>The score is partial: not entered: %1.</source>
        <translation>La cote est partielle ; à saisir : %1.</translation>
    </message>
    <message>
        <source>Twisted or bent sideways from 10° on, abducted from 45°, shoulder raised from 10°, wrist twist at its end beyond 75 % of the range (this program's choice).</source>
        <translation>Tourné ou incliné à partir de 10°, écarté à partir de 45°, épaule levée à partir de 10°, torsion du poignet en fin de course au-delà de 75 % (choix de ce programme).</translation>
    </message>
    <message>
        <source>What drives the score</source>
        <translation>Ce qui détermine la cote</translation>
    </message>
    <message>
        <source>What would bring it down: %1</source>
        <translation>Ce qui l'abaisserait : %1</translation>
    </message>
    <message>
        <source>Worst phase: %1 s to %2 s (%3 s), RULA %4</source>
        <translation>Pire phase : %1 s à %2 s (%3 s), RULA %4</translation>
    </message>
    <message>
        <source>Zone</source>
        <translation>Zone</translation>
    </message>
    <message>
        <source>Zones by part</source>
        <translation>Zones par partie</translation>
    </message>
    <message>
        <source>abducted</source>
        <translation>écarté</translation>
    </message>
    <message>
        <source>acceptable</source>
        <translation>acceptable</translation>
    </message>
    <message>
        <source>across or outside</source>
        <translation>hors du plan</translation>
    </message>
    <message>
        <source>activity</source>
        <translation>activité</translation>
    </message>
    <message>
        <source>arm supported</source>
        <translation>bras soutenu</translation>
    </message>
    <message>
        <source>arm supported, or fewer than 10 movements a minute</source>
        <translation>bras soutenu, ou moins de 10 mouvements par minute</translation>
    </message>
    <message>
        <source>arms</source>
        <translation>bras</translation>
    </message>
    <message>
        <source>arms at or above the shoulder</source>
        <translation>bras à l'épaule ou plus haut</translation>
    </message>
    <message>
        <source>as early as possible</source>
        <translation>dès que possible</translation>
    </message>
    <message>
        <source>at once</source>
        <translation>tout de suite</translation>
    </message>
    <message>
        <source>back</source>
        <translation>dos</translation>
    </message>
    <message>
        <source>bent</source>
        <translation>penché</translation>
    </message>
    <message>
        <source>bent and twisted or bent sideways</source>
        <translation>penché et tourné ou incliné de côté</translation>
    </message>
    <message>
        <source>bent sideways</source>
        <translation>incliné de côté</translation>
    </message>
    <message>
        <source>both at or above shoulder level</source>
        <translation>les deux à l'épaule ou plus haut</translation>
    </message>
    <message>
        <source>both below shoulder level</source>
        <translation>les deux sous l'épaule</translation>
    </message>
    <message>
        <source>both feet</source>
        <translation>deux pieds</translation>
    </message>
    <message>
        <source>both feet bear</source>
        <translation>appui sur les deux pieds</translation>
    </message>
    <message>
        <source>both hands</source>
        <translation>les deux mains</translation>
    </message>
    <message>
        <source>climbing</source>
        <translation>grimpant</translation>
    </message>
    <message>
        <source>conditionally acceptable</source>
        <translation>acceptable sous condition</translation>
    </message>
    <message>
        <source>counts in</source>
        <translation>compte dans</translation>
    </message>
    <message>
        <source>coupling</source>
        <translation>prise</translation>
    </message>
    <message>
        <source>deviated</source>
        <translation>dévié</translation>
    </message>
    <message>
        <source>drives</source>
        <translation>détermine</translation>
    </message>
    <message>
        <source>elbow</source>
        <translation>coude</translation>
    </message>
    <message>
        <source>elbow at the shoulder or above</source>
        <translation>coude à l'épaule ou plus haut</translation>
    </message>
    <message>
        <source>end of range</source>
        <translation>fin de course</translation>
    </message>
    <message>
        <source>fewer than 2 movements a minute</source>
        <translation>moins de 2 mouvements par minute</translation>
    </message>
    <message>
        <source>fewer than 2 movements a minute, not held</source>
        <translation>moins de 2 mouvements par minute, non tenu</translation>
    </message>
    <message>
        <source>force, arm</source>
        <translation>effort, bras</translation>
    </message>
    <message>
        <source>force, body</source>
        <translation>effort, corps</translation>
    </message>
    <message>
        <source>from being seated</source>
        <translation>pour être assis</translation>
    </message>
    <message>
        <source>full trunk support</source>
        <translation>tronc entièrement soutenu</translation>
    </message>
    <message>
        <source>further away</source>
        <translation>plus loin</translation>
    </message>
    <message>
        <source>good grip</source>
        <translation>bonne prise</translation>
    </message>
    <message>
        <source>grip</source>
        <translation>prise</translation>
    </message>
    <message>
        <source>hands above the floor</source>
        <translation>mains au-dessus du sol</translation>
    </message>
    <message>
        <source>hands above the head</source>
        <translation>mains au-dessus de la tête</translation>
    </message>
    <message>
        <source>hands in front of the ankles</source>
        <translation>mains devant les chevilles</translation>
    </message>
    <message>
        <source>head forward</source>
        <translation>tête en avant</translation>
    </message>
    <message>
        <source>head inclination</source>
        <translation>inclinaison de la tête</translation>
    </message>
    <message>
        <source>heaviest class</source>
        <translation>classe la plus lourde</translation>
    </message>
    <message>
        <source>high</source>
        <translation>élevé</translation>
    </message>
    <message>
        <source>higher</source>
        <translation>plus haut</translation>
    </message>
    <message>
        <source>kneeling</source>
        <translation>à genoux</translation>
    </message>
    <message>
        <source>kneeling or crouching upright</source>
        <translation>à genoux ou accroupi, droit</translation>
    </message>
    <message>
        <source>kneeling or crouching, bent forward</source>
        <translation>à genoux ou accroupi, penché</translation>
    </message>
    <message>
        <source>knees</source>
        <translation>genoux</translation>
    </message>
    <message>
        <source>left</source>
        <translation>gauche</translation>
    </message>
    <message>
        <source>left elbow</source>
        <translation>coude gauche</translation>
    </message>
    <message>
        <source>left knee</source>
        <translation>genou gauche</translation>
    </message>
    <message>
        <source>left lower arm</source>
        <translation>avant-bras gauche</translation>
    </message>
    <message>
        <source>left shoulder</source>
        <translation>épaule gauche</translation>
    </message>
    <message>
        <source>left upper arm</source>
        <translation>bras gauche</translation>
    </message>
    <message>
        <source>left wrist</source>
        <translation>poignet gauche</translation>
    </message>
    <message>
        <source>left wrist twist</source>
        <translation>torsion du poignet gauche</translation>
    </message>
    <message>
        <source>legs</source>
        <translation>jambes</translation>
    </message>
    <message>
        <source>lifts a minute</source>
        <translation>levages par minute</translation>
    </message>
    <message>
        <source>line of sight</source>
        <translation>ligne de regard</translation>
    </message>
    <message>
        <source>line of sight below level</source>
        <translation>regard sous l'horizontale</translation>
    </message>
    <message>
        <source>load</source>
        <translation>charge</translation>
    </message>
    <message>
        <source>low</source>
        <translation>faible</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>plus bas</translation>
    </message>
    <message>
        <source>lower arm across or outside</source>
        <translation>avant-bras hors du plan</translation>
    </message>
    <message>
        <source>lying</source>
        <translation>couché</translation>
    </message>
    <message>
        <source>man</source>
        <translation>homme</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>mesuré</translation>
    </message>
    <message>
        <source>measured within 1.5 deg of the limit</source>
        <translation>mesuré à moins de 1,5° de la limite</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>moyen</translation>
    </message>
    <message>
        <source>mid range</source>
        <translation>mi-course</translation>
    </message>
    <message>
        <source>muscle use, arm</source>
        <translation>usage musculaire, bras</translation>
    </message>
    <message>
        <source>muscle use, body</source>
        <translation>usage musculaire, corps</translation>
    </message>
    <message>
        <source>nearer</source>
        <translation>plus près</translation>
    </message>
    <message>
        <source>neck</source>
        <translation>cou</translation>
    </message>
    <message>
        <source>neck bent sideways</source>
        <translation>cou incliné de côté</translation>
    </message>
    <message>
        <source>neck twisted</source>
        <translation>cou tourné</translation>
    </message>
    <message>
        <source>negligible</source>
        <translation>négligeable</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>not acceptable</source>
        <translation>non acceptable</translation>
    </message>
    <message>
        <source>not entered</source>
        <translation>à saisir</translation>
    </message>
    <message>
        <source>not held longer than the holding time</source>
        <translation>pas tenu plus longtemps que la durée de maintien</translation>
    </message>
    <message>
        <source>not reached, short by</source>
        <translation>hors d'atteinte, il manque</translation>
    </message>
    <message>
        <source>on one leg</source>
        <translation>sur une jambe</translation>
    </message>
    <message>
        <source>one at or above shoulder level</source>
        <translation>un à l'épaule ou plus haut</translation>
    </message>
    <message>
        <source>one foot</source>
        <translation>un pied</translation>
    </message>
    <message>
        <source>or</source>
        <translation>ou</translation>
    </message>
    <message>
        <source>over 10 and up to 20 kg</source>
        <translation>plus de 10 à 20 kg</translation>
    </message>
    <message>
        <source>over 20 kg</source>
        <translation>plus de 20 kg</translation>
    </message>
    <message>
        <source>own table</source>
        <translation>table propre</translation>
    </message>
    <message>
        <source>raised</source>
        <translation>épaule levée</translation>
    </message>
    <message>
        <source>right</source>
        <translation>droit</translation>
    </message>
    <message>
        <source>right elbow</source>
        <translation>coude droit</translation>
    </message>
    <message>
        <source>right knee</source>
        <translation>genou droit</translation>
    </message>
    <message>
        <source>right lower arm</source>
        <translation>avant-bras droit</translation>
    </message>
    <message>
        <source>right shoulder</source>
        <translation>épaule droite</translation>
    </message>
    <message>
        <source>right upper arm</source>
        <translation>bras droit</translation>
    </message>
    <message>
        <source>right wrist</source>
        <translation>poignet droit</translation>
    </message>
    <message>
        <source>right wrist twist</source>
        <translation>torsion du poignet droit</translation>
    </message>
    <message>
        <source>rotated</source>
        <translation>tourné</translation>
    </message>
    <message>
        <source>seated</source>
        <translation>assis</translation>
    </message>
    <message>
        <source>shoulder</source>
        <translation>épaule</translation>
    </message>
    <message>
        <source>shoulder raised</source>
        <translation>épaule levée</translation>
    </message>
    <message>
        <source>sitting</source>
        <translation>assis</translation>
    </message>
    <message>
        <source>sitting upright</source>
        <translation>assis droit</translation>
    </message>
    <message>
        <source>sitting with back support</source>
        <translation>assis avec dossier</translation>
    </message>
    <message>
        <source>sitting, bent forward</source>
        <translation>assis, penché en avant</translation>
    </message>
    <message>
        <source>sitting, elbow at or above shoulder</source>
        <translation>assis, coude à l'épaule ou plus haut</translation>
    </message>
    <message>
        <source>sitting, hands above head</source>
        <translation>assis, mains au-dessus de la tête</translation>
    </message>
    <message>
        <source>soon</source>
        <translation>bientôt</translation>
    </message>
    <message>
        <source>standing</source>
        <translation>debout</translation>
    </message>
    <message>
        <source>standing and walking in turn</source>
        <translation>debout et marchant en alternance</translation>
    </message>
    <message>
        <source>standing on one straight leg</source>
        <translation>debout, une jambe tendue</translation>
    </message>
    <message>
        <source>standing on two straight legs</source>
        <translation>debout, deux jambes tendues</translation>
    </message>
    <message>
        <source>standing or squatting on one bent leg</source>
        <translation>une jambe fléchie</translation>
    </message>
    <message>
        <source>standing or squatting on two bent legs</source>
        <translation>deux jambes fléchies</translation>
    </message>
    <message>
        <source>standing without support</source>
        <translation>debout sans appui</translation>
    </message>
    <message>
        <source>standing, bent forward 20 to 60 deg</source>
        <translation>debout, penché de 20 à 60°</translation>
    </message>
    <message>
        <source>standing, bent forward over 60 deg</source>
        <translation>debout, penché de plus de 60°</translation>
    </message>
    <message>
        <source>standing, elbow at or above shoulder</source>
        <translation>debout, coude à l'épaule ou plus haut</translation>
    </message>
    <message>
        <source>standing, hands above head</source>
        <translation>debout, mains au-dessus de la tête</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>droit</translation>
    </message>
    <message>
        <source>supported</source>
        <translation>soutenu</translation>
    </message>
    <message>
        <source>to the side</source>
        <translation>de côté</translation>
    </message>
    <message>
        <source>trunk</source>
        <translation>tronc</translation>
    </message>
    <message>
        <source>trunk bent sideways</source>
        <translation>tronc incliné de côté</translation>
    </message>
    <message>
        <source>trunk forward</source>
        <translation>tronc en avant</translation>
    </message>
    <message>
        <source>trunk inclination</source>
        <translation>inclinaison du tronc</translation>
    </message>
    <message>
        <source>trunk side bend</source>
        <translation>inclinaison latérale du tronc</translation>
    </message>
    <message>
        <source>trunk supported</source>
        <translation>tronc soutenu</translation>
    </message>
    <message>
        <source>trunk symmetry</source>
        <translation>symétrie du tronc</translation>
    </message>
    <message>
        <source>trunk twist</source>
        <translation>torsion du tronc</translation>
    </message>
    <message>
        <source>trunk twisted</source>
        <translation>tronc tourné</translation>
    </message>
    <message>
        <source>turned</source>
        <translation>rotation</translation>
    </message>
    <message>
        <source>twisted</source>
        <translation>tourné</translation>
    </message>
    <message>
        <source>twisted or bent sideways</source>
        <translation>tourné ou incliné de côté</translation>
    </message>
    <message>
        <source>up to 10 kg</source>
        <translation>jusqu'à 10 kg</translation>
    </message>
    <message>
        <source>upper arm</source>
        <translation>bras</translation>
    </message>
    <message>
        <source>upper arm abducted</source>
        <translation>bras écarté</translation>
    </message>
    <message>
        <source>upper arm elevation</source>
        <translation>élévation du bras</translation>
    </message>
    <message>
        <source>upper arm rotated</source>
        <translation>bras tourné</translation>
    </message>
    <message>
        <source>upper arm sideways</source>
        <translation>bras de côté</translation>
    </message>
    <message>
        <source>very high</source>
        <translation>très élevé</translation>
    </message>
    <message>
        <source>walking</source>
        <translation>en marche</translation>
    </message>
    <message>
        <source>way of the lift</source>
        <translation>course du levage</translation>
    </message>
    <message>
        <source>weight on both legs</source>
        <translation>poids sur les deux jambes</translation>
    </message>
    <message>
        <source>woman</source>
        <translation>femme</translation>
    </message>
    <message>
        <source>wrist</source>
        <translation>poignet</translation>
    </message>
    <message>
        <source>wrist deviated</source>
        <translation>poignet dévié</translation>
    </message>
    <message>
        <source>wrist twisted to its end</source>
        <translation>torsion du poignet en fin de course</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
</context>
</TS>
