<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- SPDX-License-Identifier: Apache-2.0 -->
<TS version="2.1" language="fr_FR">
<context>
    <name>HaptiCell</name>
    <message>
        <source>  (custom)</source>
        <translation>  (perso.)</translation>
    </message>
    <message>
        <source>  (in use)</source>
        <translation>  (utilisée)</translation>
    </message>
    <message>
        <source>  ·  Simplified while moving</source>
        <translation>  ·  Simplifié pendant le mouvement</translation>
    </message>
    <message numerus="yes">
        <source>  ·  preparing %n parts</source>
        <translation><numerusform>·  préparation de %n pièce</numerusform><numerusform>·  préparation de %n pièces</numerusform></translation>
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
        <source>&quot;%1&quot; uses this key and would lose it.</source>
        <translation>« %1 » utilise cette touche et la perdrait.</translation>
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
        <source>%1 % of the path</source>
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
        <source>%1 Hz, lateness (99th percentile) %2 ms%3</source>
        <translation>%1 Hz, retard (99e centile) %2 ms%3</translation>
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
        <source>%1 N were commanded. If you felt nothing, check that the device is powered, its emergency stop released and calibrated.</source>
        <translation>%1 N ont été commandés. Si vous n'avez rien senti, vérifiez que le périphérique est sous tension, son arrêt d'urgence relâché, et étalonné.</translation>
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
        <source>%1 and %2 in total</source>
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
        <source>%1 cannot be made from this geometry</source>
        <translation>%1 : impossible avec cette géométrie</translation>
    </message>
    <message>
        <source>%1 cannot be part of a mechanism</source>
        <translation>%1 ne peut pas faire partie d'un mécanisme</translation>
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
        <source>%1 edges between faces of opposite orientation</source>
        <translation>%1 arêtes entre faces d'orientations opposées</translation>
    </message>
    <message>
        <source>%1 edges with more than two faces</source>
        <translation>%1 arêtes à plus de deux faces</translation>
    </message>
    <message>
        <source>%1 faces were flipped outwards.</source>
        <translation>%1 faces ont été retournées vers l'extérieur.</translation>
    </message>
    <message>
        <source>%1 farther</source>
        <translation>%1 plus loin</translation>
    </message>
    <message>
        <source>%1 files are outside the workcell's folder. Pack them too?</source>
        <translation>%1 fichiers sont hors du dossier de la cellule. Les archiver aussi ?</translation>
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
        <source>%1 has too many frames to reorder here. Simplify it first.</source>
        <translation>%1 a trop d'images pour les réordonner ici. Simplifiez-le d'abord.</translation>
    </message>
    <message>
        <source>%1 has unsaved changes.</source>
        <translation>%1 a des changements non enregistrés.</translation>
    </message>
    <message>
        <source>%1 has unsaved work from before a crash</source>
        <translation>%1 a du travail non enregistré d’avant un plantage</translation>
    </message>
    <message>
        <source>%1 higher</source>
        <translation>%1 plus haut</translation>
    </message>
    <message numerus="yes">
        <source>%1 in %n frames</source>
        <translation><numerusform>%1 sur %n image</numerusform><numerusform>%1 sur %n images</numerusform></translation>
    </message>
    <message>
        <source>%1 in total</source>
        <translation>%1 au total</translation>
    </message>
    <message>
        <source>%1 is %2 beyond its limit</source>
        <translation>%1 est %2 au-delà de sa butée</translation>
    </message>
    <message>
        <source>%1 is %2 from %3</source>
        <translation>%1 est à %2 de %3</translation>
    </message>
    <message>
        <source>%1 is %2 from %3: a near miss.</source>
        <translation>%1 est à %2 de %3 : quasi-collision.</translation>
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
        <source>%1 is added to the cell</source>
        <translation>%1 est ajouté à la cellule</translation>
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
        <source>%1 is not a readable picture. Choose a PNG, JPEG or SVG file. The report is unchanged.</source>
        <translation>%1 n'est pas une image lisible. Choisissez un fichier PNG, JPEG ou SVG. Le rapport est inchangé.</translation>
    </message>
    <message>
        <source>%1 is not in this cell.</source>
        <translation>%1 n'est pas dans cette cellule.</translation>
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
        <source>%1 is unchanged</source>
        <translation>%1 est inchangé</translation>
    </message>
    <message>
        <source>%1 is used, but only until you quit.</source>
        <translation>%1 est utilisé, mais seulement jusqu'à la fermeture.</translation>
    </message>
    <message>
        <source>%1 kg</source>
        <translation>%1 kg</translation>
    </message>
    <message>
        <source>%1 late and %2 rejected since the server started</source>
        <translation>%1 en retard, %2 refusés depuis le démarrage du serveur</translation>
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
        <source>%1 lower</source>
        <translation>%1 plus bas</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1 may contain the work of others.</source>
        <translation>%1 contient peut-être le travail d’autrui.</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 mm in front of the flange. To change it, use the Robot panel or undo the insertion.</source>
        <translation>À %1 mm devant la bride. Pour le changer, utilisez le panneau Robot ou annulez l'insertion.</translation>
    </message>
    <message>
        <source>%1 mm&lt;br&gt;%2°</source>
        <translation>%1 mm&lt;br&gt;%2°</translation>
    </message>
    <message>
        <source>%1 moved, %2 added, %3 removed. Placements: X Y Z in mm, A B C in degrees about z, y, x.</source>
        <translation>%1 déplacés, %2 ajoutés, %3 retirés. Places : X Y Z en mm, A B C en degrés autour de z, y, x.</translation>
    </message>
    <message>
        <source>%1 moves as fast as it can</source>
        <translation>%1 va aussi vite qu'il le peut</translation>
    </message>
    <message>
        <source>%1 moves too</source>
        <translation>%1 suit</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 nearer</source>
        <translation>%1 plus près</translation>
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
        <source>%1 of %2 solutions within limits</source>
        <translation>%1 solutions sur %2 dans les butées</translation>
    </message>
    <message>
        <source>%1 of %2 triangles left, at most %3 from the surface.</source>
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
        <source>%1 over limit by %2</source>
        <translation>%1 dépasse de %2</translation>
    </message>
    <message>
        <source>%1 pairs touch at rest: %2. Exclude them from the check?</source>
        <translation>%1 paires se touchent au repos : %2. Les exclure de la vérification ?</translation>
    </message>
    <message>
        <source>%1 peak</source>
        <translation>%1 crête</translation>
    </message>
    <message>
        <source>%1 points. To pass: %2 points and the whole path</source>
        <translation>%1 points. Pour réussir : %2 points et tout le chemin</translation>
    </message>
    <message>
        <source>%1 responds at %2.</source>
        <translation>%1 répond à %2.</translation>
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
        <translation>%1 s, RULA %2 · phase critique de %3 s à %4 s, RULA %5</translation>
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
        <source>%1 starts inside %2, %3 deep: it comes free along %4 (an open mesh: judged by its winding number)</source>
        <translation>%1 commence à l'intérieur de %2, à %3 de profondeur : il se dégage selon %4 (maillage ouvert : d'après son indice d'enroulement)</translation>
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
        <source>%1 to %2: measuring…</source>
        <translation>%1 à %2 : mesure…</translation>
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
        <source>%1 triangles, at most %2 from the mesh</source>
        <translation>%1 triangles, à %2 au plus du maillage</translation>
    </message>
    <message>
        <source>%1 was changed in the meantime, so nothing was done</source>
        <translation>%1 a été modifié entre-temps : rien n'a été fait</translation>
    </message>
    <message>
        <source>%1 was not added</source>
        <translation>%1 n'a pas été ajouté</translation>
    </message>
    <message>
        <source>%1 was not found or cannot be run.</source>
        <translation>%1 est introuvable ou ne peut pas être lancé.</translation>
    </message>
    <message>
        <source>%1 was not opened</source>
        <translation>%1 n'a pas été ouvert</translation>
    </message>
    <message>
        <source>%1 was not reloaded</source>
        <translation>%1 n'a pas été rechargé</translation>
    </message>
    <message>
        <source>%1 was not saved</source>
        <translation>%1 n'a pas été enregistré</translation>
    </message>
    <message>
        <source>%1 was read with warnings</source>
        <translation>%1 a été lu avec des avertissements</translation>
    </message>
    <message>
        <source>%1 was saved with warnings</source>
        <translation>%1 a été enregistré avec des avertissements</translation>
    </message>
    <message>
        <source>%1 works while the pointer is over the scene</source>
        <translation>%1 agit tant que le pointeur est sur la scène</translation>
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
        <source>%1 would exceed its speed limit by %2/s</source>
        <translation>%1 dépasserait sa vitesse limite de %2/s</translation>
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
        <source>%1 · runs: %3 · next guidance %2 %</source>
        <translation>%1 · essais : %3 · prochaine assistance %2 %</translation>
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
        <source>%1 × %2 × %3, unit unknown</source>
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
        <source>%1, %2, %3: </source>
        <translation>%1, %2, %3 : </translation>
    </message>
    <message>
        <source>%1, from the file</source>
        <translation>%1, d'après le fichier</translation>
    </message>
    <message>
        <source>%1, heaviest class</source>
        <translation>%1, classe la plus lourde</translation>
    </message>
    <message>
        <source>%1, left</source>
        <translation>%1, gauche</translation>
    </message>
    <message>
        <source>%1, minimum distance</source>
        <translation>%1, distance minimale</translation>
    </message>
    <message>
        <source>%1, not calibrated for you</source>
        <translation>%1, pas étalonné pour vous</translation>
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
        <source>%1, target missed</source>
        <translation>%1, cible manquée</translation>
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
        <translation>%1 : changé, prend effet au prochain démarrage.</translation>
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
        <source>%1: one part has no shape to measure.</source>
        <translation>%1 : l'une des pièces n'a pas de forme à mesurer.</translation>
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
        <source>%1: the closest %2 gets is %3 away.</source>
        <translation>%1 : %2 s'en approche au plus à %3.</translation>
    </message>
    <message>
        <source>%1: they touch or overlap</source>
        <translation>%1 : elles se touchent ou se chevauchent</translation>
    </message>
    <message>
        <source>%1: triangles face inward; they count as facing outward</source>
        <translation>%1 : des triangles sont tournés vers l'intérieur ; ils comptent comme tournés vers l'extérieur</translation>
    </message>
    <message>
        <source>%1: why %2, and how to lower it</source>
        <translation>%1 : pourquoi %2, et comment l'abaisser</translation>
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
        <source>%n limits reached.</source>
        <translation><numerusform>%n butée atteinte.</numerusform><numerusform>%n butées atteintes.</numerusform></translation>
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
        <source>, clock offset %1</source>
        <translation>, décalage d'horloge %1</translation>
    </message>
    <message>
        <source>, dwell %1 s</source>
        <translation>, temporisation %1 s</translation>
    </message>
    <message>
        <source>, firmware %1</source>
        <translation>, micrologiciel %1</translation>
    </message>
    <message>
        <source>, from the file</source>
        <translation>, d'après le fichier</translation>
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
        <source>, not seen: %1</source>
        <translation>, non vus : %1</translation>
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
        <source>. Closer to the recording from %1 to %2 s, to avoid collisions</source>
        <translation>. Plus près de l'enregistrement de %1 à %2 s, pour éviter des collisions</translation>
    </message>
    <message>
        <source>. Hand tremor (%1) is larger than the tolerance, so much of it remains</source>
        <translation>. Le tremblement de la main (%1) dépasse la tolérance : il en reste beaucoup</translation>
    </message>
    <message>
        <source>. Make the window smaller</source>
        <translation>. Réduisez la fenêtre</translation>
    </message>
    <message>
        <source>. The robot cannot reach all of it: up to %1 away</source>
        <translation>. Le robot ne peut pas tout atteindre : jusqu'à %1 d'écart</translation>
    </message>
    <message>
        <source>. Their parts have no shape until you choose the folder that contains the files.</source>
        <translation>. Leurs pièces restent sans forme tant que vous n'avez pas choisi le dossier des fichiers.</translation>
    </message>
    <message>
        <source>. To fix it, give it real-time priority: add your account to the group realtime</source>
        <translation>. Pour y remédier (priorité temps réel) : ajoutez votre compte au groupe realtime</translation>
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
        <source>1 pair touches at rest: %1. Exclude it from the check?</source>
        <translation>1 paire se touche au repos : %1. L'exclure de la vérification ?</translation>
    </message>
    <message>
        <source>3D mouse</source>
        <translation>Souris 3D</translation>
    </message>
    <message>
        <source>; of the limits: speed %1 %, acceleration %2 %</source>
        <translation>; des limites : vitesse %1 %, accélération %2 %</translation>
    </message>
    <message>
        <source>; the file states none</source>
        <translation> ; il n'en nomme aucune</translation>
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
        <source>A car door on its hinge</source>
        <translation>Une portière sur sa charnière</translation>
    </message>
    <message>
        <source>A file of this cell is missing</source>
        <translation>Un fichier de cette cellule manque</translation>
    </message>
    <message>
        <source>A free hand with the fingers of the glove; the stylus moves it</source>
        <translation>Une main seule, aux doigts du gant ; le stylet la déplace</translation>
    </message>
    <message>
        <source>A guide keeps what you move on a line, a plane, a hinge and so on. Select an entity, choose a type, then pick an edge or a face.</source>
        <translation>Un guide maintient ce que vous déplacez sur une ligne, un plan, une charnière, etc. Choisissez une entité, un type, puis désignez une arête ou une face.</translation>
    </message>
    <message>
        <source>A joint lets one part move on another. Start with New joint, or use a sample below.</source>
        <translation>Une articulation laisse une pièce bouger sur une autre. Commencez par Nouvelle articulation, ou prenez un exemple ci-dessous.</translation>
    </message>
    <message>
        <source>A joint limit prevents this pose</source>
        <translation>Une butée empêche cette pose</translation>
    </message>
    <message>
        <source>A left click still selects; Ctrl and a left drag draw a selection box.</source>
        <translation>Un clic gauche choisit toujours ; Ctrl et un glissement gauche tracent un cadre.</translation>
    </message>
    <message>
        <source>A library robot was not loaded</source>
        <translation>Un robot de la bibliothèque n'a pas été chargé</translation>
    </message>
    <message>
        <source>A measure of the person replaces the most likely value of the survey (ANSUR II)</source>
        <translation>Une mesure de la personne remplace la valeur la plus probable de l'enquête (ANSUR II)</translation>
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
        <source>A picture at the top of every report; none is chosen</source>
        <translation>Une image en tête de chaque rapport ; aucune n'est choisie</translation>
    </message>
    <message>
        <source>A trajectory is not saved</source>
        <translation>Une trajectoire n'est pas enregistrée</translation>
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
        <source>A workcell from someone else can name any file on this computer. Check that all of these belong to it.</source>
        <translation>Une cellule reçue d'autrui peut nommer n'importe quel fichier de cet ordinateur. Vérifiez que tous ceux-ci lui appartiennent.</translation>
    </message>
    <message>
        <source>ABB RAPID (.mod)</source>
        <translation>ABB RAPID (.mod)</translation>
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
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Add a frame</source>
        <translation>Ajouter une image</translation>
    </message>
    <message>
        <source>Add a frame at the cursor, then drag it in the scene</source>
        <translation>Ajouter une image au curseur, puis la tirer dans la scène</translation>
    </message>
    <message>
        <source>Add a frame to this solid on picked geometry</source>
        <translation>Ajouter à ce solide un repère sur la géométrie désignée</translation>
    </message>
    <message>
        <source>Add a free hand</source>
        <translation>Ajouter une main libre</translation>
    </message>
    <message>
        <source>Add a mannequin of any size with Ctrl+Shift+M. It stands on the floor, and its hands follow the stylus or the mouse.</source>
        <translation>Ajoutez un mannequin de toute taille par Ctrl+Maj+M. Il se tient sur le sol, et ses mains suivent le stylet ou la souris.</translation>
    </message>
    <message>
        <source>Add a robot</source>
        <translation>Ajouter un robot</translation>
    </message>
    <message>
        <source>Add a straight move from the last frame</source>
        <translation>Ajouter un trajet droit depuis la dernière image</translation>
    </message>
    <message>
        <source>Add a straight move to the first frame</source>
        <translation>Ajouter un trajet droit vers la première image</translation>
    </message>
    <message>
        <source>Add mannequin</source>
        <translation>Ajouter un mannequin</translation>
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
        <source>Add with size</source>
        <translation>Ajouter avec taille</translation>
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
        <source>Against</source>
        <translation>Contre</translation>
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
        <source>All active sets (%1)</source>
        <translation>Tous les jeux actifs (%1)</translation>
    </message>
    <message>
        <source>All edits of a motion</source>
        <translation>Toutes les modifications d'un mouvement</translation>
    </message>
    <message>
        <source>All faces already point outwards.</source>
        <translation>Toutes les faces sont déjà orientées vers l'extérieur.</translation>
    </message>
    <message>
        <source>All four</source>
        <translation>Les quatre</translation>
    </message>
    <message>
        <source>All manufacturers</source>
        <translation>Tous les constructeurs</translation>
    </message>
    <message>
        <source>All supported files (*.step *.stp *.p21 *.stpz *.iges *.igs *.stl *.obj *.ply *.off *.gltf *.glb *.dae *.3mf *.fbx *.3ds *.urdf *.xacro *.sdf *.world *.toml);;CAD (*.step *.stp *.p21 *.stpz *.iges *.igs);;Meshes (*.stl *.obj *.ply *.off *.gltf *.glb *.dae *.3mf *.fbx *.3ds);;Robots and cells (*.urdf *.xacro *.sdf *.world *.toml);;All files (*)</source>
        <translation>Tous les fichiers pris en charge (*.step *.stp *.p21 *.stpz *.iges *.igs *.stl *.obj *.ply *.off *.gltf *.glb *.dae *.3mf *.fbx *.3ds *.urdf *.xacro *.sdf *.world *.toml);;CAO (*.step *.stp *.p21 *.stpz *.iges *.igs);;Maillages (*.stl *.obj *.ply *.off *.gltf *.glb *.dae *.3mf *.fbx *.3ds);;Robots et cellules (*.urdf *.xacro *.sdf *.world *.toml);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Allow motion along %1 (%1: only this axis)</source>
        <translation>Autoriser le mouvement le long de %1 (%1 : cet axe seul)</translation>
    </message>
    <message>
        <source>Allow rotation about %1 (%1 twice: only this axis)</source>
        <translation>Autoriser la rotation autour de %1 (%1 deux fois : cet axe seul)</translation>
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
        <source>An exercise with this name exists. Choose another name.</source>
        <translation>Un exercice porte déjà ce nom : choisissez-en un autre.</translation>
    </message>
    <message>
        <source>An expert's recording guides the stylus along its path and waits for the trainee.</source>
        <translation>L'enregistrement d'un expert guide le stylet sur son chemin et attend l'apprenant.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Angle step</source>
        <translation>Pas d'angle</translation>
    </message>
    <message>
        <source>Angle unit</source>
        <translation>Unité d'angle</translation>
    </message>
    <message>
        <source>Animate view changes</source>
        <translation>Animer les changements de vue</translation>
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
        <source>Another program changed this file after it was opened here. If you save, those changes are lost.</source>
        <translation>Un autre programme a modifié ce fichier depuis son ouverture ici. Si vous enregistrez, ces modifications sont perdues.</translation>
    </message>
    <message>
        <source>Another program has changed the file since; the copy does not have those changes.</source>
        <translation>Un autre programme a depuis modifié le fichier ; la copie n’a pas ces changements.</translation>
    </message>
    <message>
        <source>Another program has it open.</source>
        <translation>Un autre programme l’a ouvert.</translation>
    </message>
    <message>
        <source>Another program started the server at %1. Choose the device there.</source>
        <translation>Un autre programme a lancé le serveur à %1. Choisissez-y le périphérique.</translation>
    </message>
    <message>
        <source>Another window controls the stylus; this one observes</source>
        <translation>Une autre fenêtre commande le stylet ; celle-ci observe</translation>
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
        <source>Apply</source>
        <translation>Appliquer</translation>
    </message>
    <message>
        <source>Apply this posture</source>
        <translation>Appliquer cette posture</translation>
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
        <source>As for the entity</source>
        <translation>Comme l'entité</translation>
    </message>
    <message>
        <source>As ghosts at the same task; click a column to show only that mannequin</source>
        <translation>En fantômes à la même tâche ; cliquez une colonne pour ne montrer que ce mannequin</translation>
    </message>
    <message>
        <source>As in the set</source>
        <translation>Comme le jeu</translation>
    </message>
    <message>
        <source>As recorded</source>
        <translation>Comme enregistré</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>Attribuer</translation>
    </message>
    <message>
        <source>Assumptions for %1</source>
        <translation>Hypothèses pour %1</translation>
    </message>
    <message>
        <source>Asymmetry</source>
        <translation>Asymétrie</translation>
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
        <source>At full reach. Move it %1 closer, or unlock the feet.</source>
        <translation>À bout de bras. Approchez de %1, ou débloquez les pieds.</translation>
    </message>
    <message>
        <source>At its current placement</source>
        <translation>À sa place actuelle</translation>
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
        <source>Avoid collisions</source>
        <translation>Éviter les collisions</translation>
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
        <source>Balance: %1 inside the soles</source>
        <translation>Équilibre : %1 à l'intérieur des semelles</translation>
    </message>
    <message>
        <source>Bars: points of each run, hatched if not passed; runs without guidance apart. Line: guidance.</source>
        <translation>Barres : points de chaque essai, hachurées si non réussi ; sans assistance, à part. Ligne : assistance.</translation>
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
        <source>Base placement</source>
        <translation>Placement de la base</translation>
    </message>
    <message>
        <source>Base, TCP fixed</source>
        <translation>Base, TCP fixe</translation>
    </message>
    <message>
        <source>Belly depth, sitting</source>
        <translation>Profondeur du ventre, assis</translation>
    </message>
    <message>
        <source>Below this distance: shown and heard, not felt</source>
        <translation>Sous cette distance : montré et entendu, pas senti</translation>
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
        <source>Beyond the range of motion, not clamped. Longest: %1.</source>
        <translation>Au-delà de l'amplitude articulaire, non ramené. Le plus long : %1.</translation>
    </message>
    <message>
        <source>Bl&amp;ue:</source>
        <translation>Ble&amp;u :</translation>
    </message>
    <message>
        <source>Blend over</source>
        <translation>Lisser sur</translation>
    </message>
    <message>
        <source>Blend radius between moves</source>
        <translation>Rayon d'arrondi entre les déplacements</translation>
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
        <source>Both styluses are in use. To move entities with the 3D mouse, choose it as the second stylus.</source>
        <translation>Les deux stylets sont utilisés. Pour déplacer des entités avec la souris 3D, choisissez-la comme second stylet.</translation>
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
        <source>Brackets in the time bar: the range that Trim keeps and Delete removes</source>
        <translation>Crochets dans la barre de temps : la plage que Rogner garde et que Supprimer retire</translation>
    </message>
    <message>
        <source>Breadth of the pelvis</source>
        <translation>Largeur du bassin</translation>
    </message>
    <message>
        <source>Bringing the work %1 nearer</source>
        <translation>En approchant le travail de %1</translation>
    </message>
    <message>
        <source>Built-in parts</source>
        <translation>Pièces paramétriques</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>Boutons</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>À la main</translation>
    </message>
    <message>
        <source>By values</source>
        <translation>Par valeurs</translation>
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
        <source>Cancel: the change is not felt until the next change</source>
        <translation>Annuler : le changement n'est pas senti avant le prochain</translation>
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
        <source>Carried: moves with the link and is checked with it</source>
        <translation>Portée : suit le segment et est vérifiée avec lui</translation>
    </message>
    <message>
        <source>Cartesian</source>
        <translation>Cartésien</translation>
    </message>
    <message>
        <source>Cause: %1</source>
        <translation>Cause : %1</translation>
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
        <translation>Modifier</translation>
    </message>
    <message>
        <source>Change the mechanism</source>
        <translation>Modifier le mécanisme</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Modifié</translation>
    </message>
    <message>
        <source>Changes are felt immediately.</source>
        <translation>Les modifications se sentent aussitôt.</translation>
    </message>
    <message>
        <source>Changes of %1</source>
        <translation>Changements de %1</translation>
    </message>
    <message>
        <source>Changes on this page take effect at the next start.</source>
        <translation>Les changements de cette page prennent effet au prochain démarrage.</translation>
    </message>
    <message>
        <source>Changes up to %1 were kept. The open cell does not include them.</source>
        <translation>Les modifications jusqu’au %1 ont été gardées. La cellule ouverte ne les contient pas.</translation>
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
        <source>Check results</source>
        <translation>Résultats de la vérification</translation>
    </message>
    <message>
        <source>Check robots for self-collision</source>
        <translation>Vérifier les collisions internes des robots</translation>
    </message>
    <message>
        <source>Check the motion</source>
        <translation>Vérifier le mouvement</translation>
    </message>
    <message>
        <source>Check the whole path</source>
        <translation>Vérifier tout le chemin</translation>
    </message>
    <message>
        <source>Checked for collision</source>
        <translation>Vérifié pour les collisions</translation>
    </message>
    <message>
        <source>Checking the mesh</source>
        <translation>Examen du maillage</translation>
    </message>
    <message>
        <source>Checking the path…</source>
        <translation>Vérification du chemin…</translation>
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
        <source>Choose a motion first.</source>
        <translation>Choisissez d'abord un mouvement.</translation>
    </message>
    <message>
        <source>Choose a motion to see its curves.</source>
        <translation>Choisissez un mouvement pour voir ses courbes.</translation>
    </message>
    <message>
        <source>Choose a picture…</source>
        <translation>Choisir une image…</translation>
    </message>
    <message>
        <source>Choose a type below, then pick its geometry in the scene</source>
        <translation>Choisissez un type ci-dessous, puis désignez sa géométrie dans la scène</translation>
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
        <source>Choose folder…</source>
        <translation>Choisir le dossier…</translation>
    </message>
    <message>
        <source>Choose it in the panel Virtual Desktop.</source>
        <translation>Choisissez-le dans le panneau Virtual Desktop.</translation>
    </message>
    <message>
        <source>Choose the report logo</source>
        <translation>Choisir le logo des rapports</translation>
    </message>
    <message>
        <source>Choose the size first</source>
        <translation>Choisissez d'abord la taille</translation>
    </message>
    <message>
        <source>Choose what can be moved, then search.</source>
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
        <source>Clear the list</source>
        <translation>Effacer la liste</translation>
    </message>
    <message>
        <source>Clearance, nearest pair</source>
        <translation>Distance minimale</translation>
    </message>
    <message>
        <source>Click Pick to measure again.</source>
        <translation>Cliquez Désigner pour mesurer de nouveau.</translation>
    </message>
    <message>
        <source>Click a bore, a shaft, an edge or a face: its axis becomes the joint's</source>
        <translation>Cliquez un alésage, un arbre, une arête ou une face : son axe devient celui de l'articulation</translation>
    </message>
    <message>
        <source>Click a corner, an edge, a face or the floor to place the frame; Esc: cancel</source>
        <translation>Cliquez un coin, une arête, une face ou le sol pour poser le repère ; Échap : annuler</translation>
    </message>
    <message>
        <source>Click a dot in the time bar to select a frame, then drag it in the scene.</source>
        <translation>Cliquez un point de la barre de temps pour choisir une image, puis tirez-la dans la scène.</translation>
    </message>
    <message>
        <source>Click a dot in the time bar, or set a range.</source>
        <translation>Cliquez un point de la barre de temps, ou réglez une plage.</translation>
    </message>
    <message>
        <source>Click a face, an edge or a corner for the tool centre point</source>
        <translation>Cliquez une face, une arête ou un coin pour le centre outil</translation>
    </message>
    <message>
        <source>Click a part first.</source>
        <translation>Cliquez d'abord une pièce.</translation>
    </message>
    <message>
        <source>Click a part, not the mannequin.</source>
        <translation>Cliquez une pièce, pas le mannequin.</translation>
    </message>
    <message>
        <source>Click a part, or draw a box around several.</source>
        <translation>Cliquez une pièce, ou tracez un cadre autour de plusieurs.</translation>
    </message>
    <message>
        <source>Click a robot or a mechanism in the scene or in the tree, or add one with Ctrl+Shift+I.</source>
        <translation>Cliquez un robot ou un mécanisme dans la scène ou dans l'arbre, ou ajoutez-en un par Ctrl+Maj+I.</translation>
    </message>
    <message>
        <source>Click entities in the scene; Esc: end</source>
        <translation>Cliquez des entités dans la scène ; Échap : terminer</translation>
    </message>
    <message>
        <source>Click one in the scene or in the tree.</source>
        <translation>Cliquez-en un dans la scène ou dans l'arbre.</translation>
    </message>
    <message>
        <source>Click the part for both hands to hold</source>
        <translation>Cliquez la pièce que les deux mains doivent tenir</translation>
    </message>
    <message>
        <source>Click the part for the robot to carry</source>
        <translation>Cliquez la pièce que le robot doit porter</translation>
    </message>
    <message>
        <source>Click the part in the scene</source>
        <translation>Cliquez la pièce dans la scène</translation>
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
        <source>Click to place it; Esc: cancel</source>
        <translation>Cliquez pour le poser ; Échap : annuler</translation>
    </message>
    <message>
        <source>Click to play it</source>
        <translation>Cliquez pour le lire</translation>
    </message>
    <message>
        <source>Click to set it for this pair</source>
        <translation>Cliquez pour choisir pour cette paire</translation>
    </message>
    <message>
        <source>Click where the centre of its underside goes</source>
        <translation>Cliquez où poser le centre de sa face inférieure</translation>
    </message>
    <message>
        <source>Click where to place the base</source>
        <translation>Cliquez où poser la base</translation>
    </message>
    <message>
        <source>Click where to put the hand</source>
        <translation>Cliquez où placer la main</translation>
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
        <source>Collision shape</source>
        <translation>Forme de collision</translation>
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
        <source>Command</source>
        <translation>Commande</translation>
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
        <source>Compared with %1</source>
        <translation>Comparé à %1</translation>
    </message>
    <message>
        <source>Compared with another workcell…</source>
        <translation>Par rapport à une autre cellule…</translation>
    </message>
    <message>
        <source>Compared with the imported files…</source>
        <translation>Par rapport aux fichiers importés…</translation>
    </message>
    <message>
        <source>Compared with the saved cell…</source>
        <translation>Par rapport à la cellule enregistrée…</translation>
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
        <translation>Configurations et déplacement manuel</translation>
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
        <source>Connected as stylus 2; holds the other hand, trunk fixed</source>
        <translation>Connecté, stylet 2 ; tient l'autre main, tronc fixe</translation>
    </message>
    <message>
        <source>Connected as stylus 2; holds the part that its tip touches</source>
        <translation>Connecté, stylet 2 ; tient la pièce que touche sa pointe</translation>
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
        <source>Connects with the first stylus</source>
        <translation>Se connecte avec le premier</translation>
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
        <source>Contact colour</source>
        <translation>Couleur de contact</translation>
    </message>
    <message>
        <source>Contact is felt at this distance</source>
        <translation>Le contact se sent à cette distance</translation>
    </message>
    <message>
        <source>Contact log</source>
        <translation>Journal des contacts</translation>
    </message>
    <message>
        <source>Contact mode is Pass: contacts are shown, not felt</source>
        <translation>Mode de contact Traverser : contacts montrés, pas sentis</translation>
    </message>
    <message>
        <source>Contact mode of %1 – %2</source>
        <translation>Mode de contact de %1 – %2</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Contacts</translation>
    </message>
    <message>
        <source>Contacts are displayed late</source>
        <translation>Les contacts s'affichent en retard</translation>
    </message>
    <message>
        <source>Contacts are displayed on time</source>
        <translation>Les contacts s'affichent à temps</translation>
    </message>
    <message>
        <source>Contacts are sometimes late</source>
        <translation>Les contacts sont parfois en retard</translation>
    </message>
    <message>
        <source>Contacts arrive on time</source>
        <translation>Les contacts arrivent à temps</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Sommaire</translation>
    </message>
    <message>
        <source>Controllers load such a long program slowly or not at all, and run short moves unevenly. Simplify keeps only the moves needed within %1 and %2. The motion itself is unchanged.</source>
        <translation>Les contrôleurs chargent un programme aussi long lentement ou pas du tout, et exécutent irrégulièrement les déplacements courts. Simplifier ne garde que les déplacements nécessaires à %1 et %2 près. Le mouvement lui-même est inchangé.</translation>
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
        <source>Copies the selected tool, or adds one at the flange</source>
        <translation>Copie l'outil choisi, ou en ajoute un à la bride</translation>
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
        <source>Copy the command that fixes it</source>
        <translation>Copier la commande qui y remédie</translation>
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
        <source>Create the mechanism</source>
        <translation>Créer le mécanisme</translation>
    </message>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
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
        <source>Ctrl: snap to corners, edges, faces and frames · Esc: cancel</source>
        <translation>Ctrl : aimanter aux coins, arêtes, faces et repères · Échap : annuler</translation>
    </message>
    <message>
        <source>Curl fingers</source>
        <translation>Plier les doigts</translation>
    </message>
    <message>
        <source>Current motion</source>
        <translation>Mouvement actuel</translation>
    </message>
    <message>
        <source>Current size…</source>
        <translation>Taille actuelle…</translation>
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
        <source>Custom</source>
        <translation>Personnalisé</translation>
    </message>
    <message>
        <source>Custom hand force limits</source>
        <translation>Limites propres de force des mains</translation>
    </message>
    <message>
        <source>Custom hand force limits…</source>
        <translation>Limites propres des mains…</translation>
    </message>
    <message>
        <source>Custom limit, left</source>
        <translation>Limite propre, gauche</translation>
    </message>
    <message>
        <source>Custom limit, right</source>
        <translation>Limite propre, droite</translation>
    </message>
    <message>
        <source>Custom limits</source>
        <translation>Limites propres</translation>
    </message>
    <message>
        <source>Custom limits: %1</source>
        <translation>Limites propres : %1</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Cylindre</translation>
    </message>
    <message>
        <source>Damping (0: as the device)</source>
        <translation>Amortissement (0 : celui du périphérique)</translation>
    </message>
    <message>
        <source>Damping (2 is a loose grip)</source>
        <translation>Amortissement (2 : prise lâche)</translation>
    </message>
    <message>
        <source>Damping of the held part (Dynamics)</source>
        <translation>Amortissement de la pièce tenue (Dynamique)</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>Decimals</source>
        <translation>Décimales</translation>
    </message>
    <message>
        <source>Decrease %1 by one step</source>
        <translation>Diminuer %1 d'un pas</translation>
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
        <source>Delete the frame, or all frames between the brackets</source>
        <translation>Supprimer l'image, ou toutes entre les crochets</translation>
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
        <source>Describe the task for the trainee.</source>
        <translation>Décrivez la tâche de l'apprenant.</translation>
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
        <source>Details</source>
        <translation>Détails</translation>
    </message>
    <message>
        <source>Detents</source>
        <translation>Crans</translation>
    </message>
    <message>
        <source>Dev. mm</source>
        <translation>Écart mm</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Écart</translation>
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
        <source>Devices and problems</source>
        <translation>Périphériques et problèmes</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diamètre</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Différence</translation>
    </message>
    <message>
        <source>Disassemble</source>
        <translation>Démonter</translation>
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
        <source>Distance of the shoulder joints</source>
        <translation>Écart des épaules</translation>
    </message>
    <message>
        <source>Do not check %1 for collision</source>
        <translation>Ne pas vérifier les collisions de %1</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fait</translation>
    </message>
    <message>
        <source>Done: %1</source>
        <translation>Fait : %1</translation>
    </message>
    <message>
        <source>Drag the %1 of %2</source>
        <translation>Tirer %1 de %2</translation>
    </message>
    <message>
        <source>Drag the TCP of %1</source>
        <translation>Tirer le TCP de %1</translation>
    </message>
    <message>
        <source>Drag the arrows at the hand, or hold it with the stylus.</source>
        <translation>Tirez les flèches à la main, ou tenez-la avec le stylet.</translation>
    </message>
    <message>
        <source>Drag the stylus to move it · B: %1 · H: follow the mouse</source>
        <translation>Tirez le stylet pour le déplacer · B : %1 · H : suivre la souris</translation>
    </message>
    <message>
        <source>Drag to move</source>
        <translation>Tirez pour déplacer</translation>
    </message>
    <message>
        <source>Drag to move it; the body follows</source>
        <translation>Tirez pour la déplacer ; le corps suit</translation>
    </message>
    <message>
        <source>Drag to move parallel to the screen</source>
        <translation>Tirez pour déplacer parallèlement à l'écran</translation>
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
        <source>Drag to rotate</source>
        <translation>Tirez pour tourner</translation>
    </message>
    <message>
        <source>Drag to rotate it; the body follows</source>
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
        <source>Drag: move · wheel: depth · Ctrl: rotate · right button or B: %1</source>
        <translation>Tirer : déplacer · molette : profondeur · Ctrl : tourner · bouton droit ou B : %1</translation>
    </message>
    <message>
        <source>Drift at the edge of the workspace (0: none)</source>
        <translation>Dérive au bord de l'espace de travail (0 : aucune)</translation>
    </message>
    <message>
        <source>Driven by %1. </source>
        <translation>Déterminé par %1. </translation>
    </message>
    <message>
        <source>Driver</source>
        <translation>Facteur</translation>
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
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Dwell here</source>
        <translation>Temporiser</translation>
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
        <source>Edit name, task and guidance; a shipped exercise is copied</source>
        <translation>Modifier nom, tâche, assistance ; un exercice fourni est copié</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>Modifier…</translation>
    </message>
    <message>
        <source>Elsewhere, letters and digits are text: type to search lists and panels.</source>
        <translation>Ailleurs lettres et chiffres sont du texte : taper cherche dans les listes et les panneaux.</translation>
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
        <source>Enter a name.</source>
        <translation>Saisissez un nom.</translation>
    </message>
    <message>
        <source>Enter the address of the other station: its network name, or four numbers such as 192.168.1.20.</source>
        <translation>Saisissez l'adresse de l'autre poste : son nom sur le réseau, ou quatre nombres comme 192.168.1.20.</translation>
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
        <source>Esc, Space and B are reserved: forces off, clutch, stylus button.</source>
        <translation>Échap, Espace et B sont réservées : couper les efforts, débrayer, bouton du stylet.</translation>
    </message>
    <message>
        <source>Esc: cancel the drag</source>
        <translation>Échap : annuler le glissement</translation>
    </message>
    <message>
        <source>Esc: close · F1: help · ?: shortcuts</source>
        <translation>Échap : fermer · F1 : aide · ? : raccourcis</translation>
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
        <source>Everything. To narrow it down, drag entities here from the tree.</source>
        <translation>Tout. Pour restreindre, tirez ici des entités de l'arbre.</translation>
    </message>
    <message>
        <source>Exclude</source>
        <translation>Exclure</translation>
    </message>
    <message>
        <source>Exclude %1 pairs that touch at rest</source>
        <translation>Exclure %1 paires qui se touchent au repos</translation>
    </message>
    <message>
        <source>Exclude %1 – %2</source>
        <translation>Exclure %1 – %2</translation>
    </message>
    <message>
        <source>Exclude a pair that touches at rest</source>
        <translation>Exclure une paire qui se touche au repos</translation>
    </message>
    <message>
        <source>Exclude this pair</source>
        <translation>Exclure cette paire</translation>
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
        <translation>Les axes externes suivent l'outil avec les axes du robot</translation>
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
        <source>Fastest within limits</source>
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
        <source>Feet can step</source>
        <translation>Pieds libres</translation>
    </message>
    <message>
        <source>Feet locked</source>
        <translation>Pieds bloqués</translation>
    </message>
    <message>
        <source>Felt with force class Dynamics; adds to the load of the robot that carries it</source>
        <translation>Sentie avec le type Dynamique ; s'ajoute à la charge du robot qui la porte</translation>
    </message>
    <message>
        <source>Fence</source>
        <translation>Grillage</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Champ de vision</translation>
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
        <source>Filter by command or key</source>
        <translation>Filtrer par commande ou par touche</translation>
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
        <source>First column</source>
        <translation>Première colonne</translation>
    </message>
    <message>
        <source>First pick a face, edge or corner of the moving part, then the target</source>
        <translation>Désignez d'abord une face, une arête ou un coin de la pièce à déplacer, puis la cible</translation>
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
        <source>Flip</source>
        <translation>Inverser</translation>
    </message>
    <message>
        <source>Flip side</source>
        <translation>Autre côté</translation>
    </message>
    <message>
        <source>Flip the axis or normal</source>
        <translation>Inverser l'axe ou la normale</translation>
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
        <source>Folder of the missing files</source>
        <translation>Dossier des fichiers manquants</translation>
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
        <source>For the mannequin's other hand, or the part that its tip touches</source>
        <translation>Pour l'autre main du mannequin, ou la pièce que touche sa pointe</translation>
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
        <source>Force above the expert's that loses all points for it</source>
        <translation>Effort au-dessus de celui de l'expert qui fait perdre tous ses points</translation>
    </message>
    <message>
        <source>Force and clearance over the last seconds</source>
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
        <source>Force ramp-up time</source>
        <translation>Durée de montée d'effort</translation>
    </message>
    <message>
        <source>Force test</source>
        <translation>Essai d'effort</translation>
    </message>
    <message>
        <source>Force, unless set for the part</source>
        <translation>Effort, sauf réglage de la pièce</translation>
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
        <source>Forces are off. Connect again to restart it.</source>
        <translation>Efforts coupés. Connectez de nouveau pour le redémarrer.</translation>
    </message>
    <message>
        <source>Forces are off. The server is restarting. Then press Ctrl+Space to turn them on.</source>
        <translation>Efforts coupés. Le serveur redémarre. Ctrl+Espace les remet ensuite en marche.</translation>
    </message>
    <message>
        <source>Forces are off. Without them you do not feel the guide.</source>
        <translation>Les efforts sont coupés. Sans eux, le guide ne se sent pas.</translation>
    </message>
    <message>
        <source>Forces are off. You do not feel the guide.</source>
        <translation>Les efforts sont coupés. Le guide ne se sent pas.</translation>
    </message>
    <message>
        <source>Forces are off: a second stylus was connected</source>
        <translation>Efforts coupés : un second stylet s'est connecté</translation>
    </message>
    <message>
        <source>Forces are off: another window took control of the stylus</source>
        <translation>Efforts coupés : une autre fenêtre commande le stylet</translation>
    </message>
    <message>
        <source>Forces are off: the haptic server stopped responding</source>
        <translation>Efforts coupés : le serveur haptique ne répond plus</translation>
    </message>
    <message>
        <source>Forces are on.</source>
        <translation>Les efforts sont en marche.</translation>
    </message>
    <message>
        <source>Forces are on: %1.</source>
        <translation>Les efforts sont en marche : %1.</translation>
    </message>
    <message>
        <source>Forces did not switch on. The device is not ready.</source>
        <translation>Les efforts n'ont pas pu être mis en marche. Le périphérique n'est pas prêt.</translation>
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
        <source>Forces off; otherwise end picking or the tool</source>
        <translation>Coupe les efforts ; sinon termine la désignation ou l'outil</translation>
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
        <translation>Activer les efforts et commencer</translation>
    </message>
    <message>
        <source>Forces pending</source>
        <translation>Efforts en attente</translation>
    </message>
    <message>
        <source>Forces switched off</source>
        <translation>Efforts coupés</translation>
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
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Four mannequins at the same task</source>
        <translation>Quatre mannequins à la même tâche</translation>
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
        <source>Frames within this time follow when you move a frame</source>
        <translation>Les images proches de moins que ce temps suivent quand on en déplace une</translation>
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
        <source>From the material (hapticell.toml). The server limits it to what the device supports</source>
        <translation>Celle du matériau (hapticell.toml). Le serveur la limite à ce que le périphérique supporte</translation>
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
        <source>Full screen</source>
        <translation>Plein écran</translation>
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
        <source>Go back 10 seconds of motion</source>
        <translation>Revenir de 10 secondes de mouvement</translation>
    </message>
    <message>
        <source>Go home</source>
        <translation>Aller en position de repos</translation>
    </message>
    <message>
        <source>Go to end</source>
        <translation>Aller à la fin</translation>
    </message>
    <message>
        <source>Go to start</source>
        <translation>Aller au début</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Bonne</translation>
    </message>
    <message>
        <source>Grasp</source>
        <translation>Prise en main</translation>
    </message>
    <message>
        <source>Grasp of %1</source>
        <translation>Prise de %1</translation>
    </message>
    <message>
        <source>Gravity compensation of the held part</source>
        <translation>Compensation du poids de la pièce tenue</translation>
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
        <translation>Prise</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>Pince</translation>
    </message>
    <message>
        <source>Guidance</source>
        <translation>Assistance</translation>
    </message>
    <message>
        <source>Guidance and score</source>
        <translation>Assistance et points</translation>
    </message>
    <message>
        <source>Guidance drops by a fifth with each success, down to 0 %. After two failures it rises again.</source>
        <translation>L'assistance baisse d'un cinquième à chaque réussite, jusqu'à 0 %. Après deux échecs elle remonte.</translation>
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
        <source>Hand on the simulated stylus</source>
        <translation>Main sur le stylet simulé</translation>
    </message>
    <message>
        <source>Handle at</source>
        <translation>Poignée à</translation>
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
        <source>HaptiCell crashed; no changes were lost</source>
        <translation>HaptiCell a planté ; rien n’est perdu</translation>
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
        <source>HaptiCell: middle button rotates</source>
        <translation>HaptiCell : le bouton du milieu tourne</translation>
    </message>
    <message>
        <source>Haptic</source>
        <translation>Haptique</translation>
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
        <source>Height of the crotch</source>
        <translation>Hauteur de l'entrejambe</translation>
    </message>
    <message>
        <source>Height of the hip joint</source>
        <translation>Hauteur de la hanche</translation>
    </message>
    <message>
        <source>Height of the iliac crest</source>
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
        <source>Height of the sternum</source>
        <translation>Hauteur du sternum</translation>
    </message>
    <message>
        <source>Height of the tenth rib</source>
        <translation>Hauteur de la dixième côte</translation>
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
        <source>Held entity</source>
        <translation>Entité tenue</translation>
    </message>
    <message>
        <source>Held over 1 min</source>
        <translation>Tenue plus d'1 min</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Help on this panel</source>
        <translation>Aide sur ce panneau</translation>
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
        <source>Hold</source>
        <translation>Tenir</translation>
    </message>
    <message>
        <source>Hold an entity with the stylus, move it and feel what it touches</source>
        <translation>Tenir une entité avec le stylet, la déplacer et sentir ce qu'elle touche</translation>
    </message>
    <message>
        <source>Hold one part</source>
        <translation>Tenir une pièce</translation>
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
        <source>Hold the part with the stylus</source>
        <translation>Tenir la pièce avec le stylet</translation>
    </message>
    <message>
        <source>Hold: move the hand without the entity (clutch)</source>
        <translation>Maintenue : la main bouge sans l'entité (débrayage)</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Repos</translation>
    </message>
    <message>
        <source>Horizontal distance</source>
        <translation>Distance horiz.</translation>
    </message>
    <message>
        <source>How far ahead of the trainee the guidance pulls</source>
        <translation>Distance devant l'apprenant à laquelle l'assistance tire</translation>
    </message>
    <message>
        <source>How much of the last selected part the mannequin sees</source>
        <translation>Ce que le mannequin voit de la dernière pièce choisie</translation>
    </message>
    <message>
        <source>Hu&amp;e:</source>
        <translation>T&amp;einte :</translation>
    </message>
    <message>
        <source>I am holding it: next</source>
        <translation>Je le tiens : suite</translation>
    </message>
    <message>
        <source>I am holding it: start</source>
        <translation>Je le tiens : démarrer</translation>
    </message>
    <message>
        <source>If you discard the copy, the unsaved changes of %1 are lost for good.</source>
        <translation>Si vous supprimez la copie, les modifications non enregistrées de %1 sont perdues pour de bon.</translation>
    </message>
    <message>
        <source>If you do not save them, they are lost.</source>
        <translation>Si vous ne les enregistrez pas, ils sont perdus.</translation>
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
        <source>Import as</source>
        <translation>Importer comme</translation>
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
        <source>Improve the posture of %1</source>
        <translation>Améliorer la posture de %1</translation>
    </message>
    <message>
        <source>In contact from the start: %1 and %2</source>
        <translation>En contact dès le début : %1 et %2</translation>
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
        <source>Include %1 – %2</source>
        <translation>Inclure %1 – %2</translation>
    </message>
    <message>
        <source>Include this pair</source>
        <translation>Inclure cette paire</translation>
    </message>
    <message>
        <source>Increase %1 by one step</source>
        <translation>Augmenter %1 d'un pas</translation>
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
        <source>Invert the wheel</source>
        <translation>Inverser la molette</translation>
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
        <source>It has no frame yet. Add one in the Solid panel.</source>
        <translation>Pas encore de repère. Ajoutez-en un dans le panneau Solide.</translation>
    </message>
    <message>
        <source>It has no parent</source>
        <translation>Il n'a pas de parent</translation>
    </message>
    <message>
        <source>It is locked in place. Unlock it in the tree first.</source>
        <translation>Verrouillé sur place. Déverrouillez-le d'abord dans l'arbre.</translation>
    </message>
    <message>
        <source>It is read-only here. Save it under another name, or close it there first.</source>
        <translation>Il est ici en lecture seule. Enregistrez-le sous un autre nom, ou fermez-le d'abord là-bas.</translation>
    </message>
    <message>
        <source>It moves with the hand and is checked with it</source>
        <translation>Elle suit la main et est vérifiée avec elle</translation>
    </message>
    <message>
        <source>It stays in the cell until you quit. Export it to keep it.</source>
        <translation>Elle reste dans la cellule jusqu'à la fermeture. Exportez-la pour la garder.</translation>
    </message>
    <message>
        <source>It stays where it is</source>
        <translation>Il reste où il est</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>À-coup</translation>
    </message>
    <message>
        <source>Jog %1 of %2</source>
        <translation>Déplacement manuel %1 de %2</translation>
    </message>
    <message>
        <source>Jog %1 of the TCP of %2</source>
        <translation>Déplacement manuel %1 du TCP de %2</translation>
    </message>
    <message>
        <source>Join parts into a mechanism…</source>
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
        <source>Joint limits, from the current position</source>
        <translation>Butées, depuis la position actuelle</translation>
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
        <source>Keep checking</source>
        <translation>Garder</translation>
    </message>
    <message>
        <source>Keep joint 4</source>
        <translation>Garder l'axe 4</translation>
    </message>
    <message>
        <source>Keep only the frames needed</source>
        <translation>Garder seulement les images nécessaires</translation>
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
        <source>Keep position, %1 fixed</source>
        <translation>Garder la position, %1 fixe</translation>
    </message>
    <message>
        <source>Keep position, wrist joint fixed</source>
        <translation>Garder la position, axe du poignet fixe</translation>
    </message>
    <message>
        <source>Keep the range between the brackets</source>
        <translation>Garder la plage entre les crochets</translation>
    </message>
    <message>
        <source>Keep the range between the brackets as a new motion</source>
        <translation>Garder la plage entre les crochets comme nouveau mouvement</translation>
    </message>
    <message>
        <source>Keep the stylus button pressed to move</source>
        <translation>Garder le bouton du stylet pressé pour déplacer</translation>
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
        <source>Kneeling</source>
        <translation>À genoux</translation>
    </message>
    <message>
        <source>Kneeling on one knee</source>
        <translation>Sur un genou</translation>
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
        <source>Largest mass with felt inertia</source>
        <translation>Plus grande masse à inertie sentie</translation>
    </message>
    <message>
        <source>Last run: %1 points. %2 s (expert %3 s), %4 off the path, at most %5 N, contacts: %7, smoothness %6 % of the expert's.</source>
        <translation>Dernier essai : %1 points. %2 s (expert %3 s), %4 hors du chemin, au plus %5 N, contacts : %7, régularité %6 % de celle de l'expert.</translation>
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
        <translation>Longueur de l'approche ou du dégagement, le long de l'axe de l'outil</translation>
    </message>
    <message>
        <source>Length step</source>
        <translation>Pas de longueur</translation>
    </message>
    <message>
        <source>Length unit</source>
        <translation>Longueurs</translation>
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
        <source>Limits and feel</source>
        <translation>Butées et toucher</translation>
    </message>
    <message>
        <source>Limits, singularities, configurations and collisions, also between frames</source>
        <translation>Limites, singularités, configurations et collisions, aussi entre les images</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Line: rate. Bars: lateness (99th percentile), full height %1 ms</source>
        <translation>Ligne : fréquence. Barres : retard (99 %), au plus %1 ms</translation>
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
        <source>Load %1, payload unknown</source>
        <translation>Charge %1, charge admissible inconnue</translation>
    </message>
    <message>
        <source>Load your own table of hand force limits; none is included</source>
        <translation>Charger votre propre table de limites d'effort des mains ; aucune n'est fournie</translation>
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
        <translation>Charge : aucune, charge admissible %1</translation>
    </message>
    <message>
        <source>Load: none, payload unknown</source>
        <translation>Charge : aucune, charge admissible inconnue</translation>
    </message>
    <message>
        <source>Local</source>
        <translation>Local</translation>
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
        <source>Logo</source>
        <translation>Logo</translation>
    </message>
    <message>
        <source>Look at part</source>
        <translation>Regarder la pièce</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>En boucle</translation>
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
        <source>Make an exercise from this cell and an expert's motion</source>
        <translation>Créer un exercice avec cette cellule et le mouvement d'un expert</translation>
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
        <source>Manipulation loop, dashed</source>
        <translation>Boucle de manipulation, en tirets</translation>
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
        <source>Manufacturer</source>
        <translation>Constructeur</translation>
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
        <source>Mass not entered, 1 kg assumed: %1</source>
        <translation>Masse non saisie, 1 kg supposé : %1</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>Materials: how a part feels in contact</source>
        <translation>Matériaux : le toucher d'une pièce</translation>
    </message>
    <message>
        <source>Max mm</source>
        <translation>Max mm</translation>
    </message>
    <message>
        <source>Mean deviation that loses all points for it</source>
        <translation>Écart moyen qui fait perdre tous ses points</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mesurer</translation>
    </message>
    <message>
        <source>Measured value</source>
        <translation>Valeur mesurée</translation>
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
        <source>Mirror plane</source>
        <translation>Plan de symétrie</translation>
    </message>
    <message>
        <source>Mirror the motion, as a partner on the other side would do it</source>
        <translation>Symétrie du mouvement, comme le ferait un partenaire en face</translation>
    </message>
    <message>
        <source>Missed: %1 is %2, requested %3 (%4). %5</source>
        <translation>Manqué : %1 vaut %2, demandé %3 (%4). %5</translation>
    </message>
    <message>
        <source>Most important first: %1.</source>
        <translation>Les plus importants d'abord : %1.</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Motion scale, %1</source>
        <translation>Échelle de mouvement, %1</translation>
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
    <message>
        <source>Move %1 below %2</source>
        <translation>Mettre %1 sous %2</translation>
    </message>
    <message>
        <source>Move %1 to %2</source>
        <translation>Mener %1 à %2</translation>
    </message>
    <message>
        <source>Move %1 to configuration %2</source>
        <translation>Mener %1 à la configuration %2</translation>
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
        <source>Move by values…</source>
        <translation>Déplacer par valeurs…</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Descendre</translation>
    </message>
    <message>
        <source>Move external axes too</source>
        <translation>Bouger aussi les axes externes</translation>
    </message>
    <message>
        <source>Move it there</source>
        <translation>Le mettre là</translation>
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
        <source>Move the mannequin or the part nearer, or unlock the feet so that it can step.</source>
        <translation>Rapprochez le mannequin ou la pièce, ou débloquez les pieds pour qu'il puisse faire un pas.</translation>
    </message>
    <message>
        <source>Move the stylus in all directions and press each button once.</source>
        <translation>Menez le stylet dans toutes les directions et pressez chaque bouton une fois.</translation>
    </message>
    <message>
        <source>Move the stylus into free space</source>
        <translation>Menez le stylet en espace libre</translation>
    </message>
    <message>
        <source>Move the workplace</source>
        <translation>Déplacer le poste de travail</translation>
    </message>
    <message>
        <source>Move to a new folder</source>
        <translation>Mettre dans un nouveau dossier</translation>
    </message>
    <message>
        <source>Move to entity</source>
        <translation>Mener à l'entité</translation>
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
        <source>Moves the guide to the handle of the entity; its direction stays</source>
        <translation>Mène le guide à la poignée de l'entité ; sa direction reste</translation>
    </message>
    <message>
        <source>Moving the work %1 farther away</source>
        <translation>En éloignant le travail de %1</translation>
    </message>
    <message>
        <source>Moving the work %1 to the side</source>
        <translation>En décalant le travail de %1 de côté</translation>
    </message>
    <message>
        <source>Moving the work by up to %1 does not lower the action level for this mannequin.</source>
        <translation>Déplacer le travail de %1 au plus n'abaisse pas le niveau d'action de ce mannequin.</translation>
    </message>
    <message>
        <source>Multiple of the expert's time that loses all points for it</source>
        <translation>Multiple du temps de l'expert qui fait perdre tous ses points</translation>
    </message>
    <message>
        <source>Mute</source>
        <translation>Couper le son</translation>
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
        <source>NIOSH does not apply: nothing is lifted. Enter a lift and its load in Task data.</source>
        <translation>NIOSH ne s'applique pas : rien n'est levé. Saisissez un levage et sa charge dans Données de la tâche.</translation>
    </message>
    <message>
        <source>NIOSH does not apply: the load is held. If it is lifted, tick that in Task data.</source>
        <translation>NIOSH ne s'applique pas : la charge est tenue. Si elle est levée, cochez-le dans Données de la tâche.</translation>
    </message>
    <message>
        <source>NIOSH: lifting index %1, %2 (%3 kg of a limit of %4 kg)</source>
        <translation>NIOSH : indice de levage %1, %2 (%3 kg pour une limite de %4 kg)</translation>
    </message>
    <message>
        <source>NIOSH: limit 0 kg, no load is acceptable at this place</source>
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
        <source>Name, manufacturer, type or payload</source>
        <translation>Nom, constructeur, type ou charge</translation>
    </message>
    <message>
        <source>Name, or 192.168.1.20</source>
        <translation>Nom, ou 192.168.1.20</translation>
    </message>
    <message>
        <source>Named poses</source>
        <translation>Poses nommées</translation>
    </message>
    <message>
        <source>Named poses: go to one, or save this one</source>
        <translation>Poses nommées : aller à l'une, ou enregistrer celle-ci</translation>
    </message>
    <message>
        <source>Names only</source>
        <translation>Noms seuls</translation>
    </message>
    <message>
        <source>Near a singularity: one direction is nearly lost</source>
        <translation>Près d'une singularité : une direction est presque perdue</translation>
    </message>
    <message>
        <source>Near miss</source>
        <translation>Quasi-collision</translation>
    </message>
    <message>
        <source>Near miss %1</source>
        <translation>Quasi-collision %1</translation>
    </message>
    <message>
        <source>Near miss 00</source>
        <translation>Quasi-collision 00</translation>
    </message>
    <message>
        <source>Near miss below %1</source>
        <translation>Quasi-collision sous %1</translation>
    </message>
    <message>
        <source>Near-miss colour</source>
        <translation>Coul. quasi-collision</translation>
    </message>
    <message>
        <source>Near-miss distance: shown and heard below</source>
        <translation>Quasi-collision : montrée et entendue sous</translation>
    </message>
    <message>
        <source>Near/far ±</source>
        <translation>Près/loin ±</translation>
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
        <source>Needs six or more revolute joints, of which the last three form a wrist</source>
        <translation>Il faut au moins six axes rotatifs dont les trois derniers forment un poignet</translation>
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
        <translation>Nouveau jeu de paires</translation>
    </message>
    <message>
        <source>New timing along the same path</source>
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
        <source>Next contact mode</source>
        <translation>Mode de contact suivant</translation>
    </message>
    <message>
        <source>Next folder</source>
        <translation>Dossier suivant</translation>
    </message>
    <message>
        <source>Next frame (Right, in the time bar)</source>
        <translation>Image suivante (Droite, dans la barre de temps)</translation>
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
        <source>No action needed.</source>
        <translation>Rien à faire.</translation>
    </message>
    <message>
        <source>No application was found in the program folder</source>
        <translation>Aucune application n'a été trouvée dans le dossier du programme</translation>
    </message>
    <message>
        <source>No change is needed.</source>
        <translation>Aucun changement n'est nécessaire.</translation>
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
        <source>No data yet</source>
        <translation>Pas encore de données</translation>
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
        <source>No forces</source>
        <translation>Pas d'efforts</translation>
    </message>
    <message>
        <source>No forces felt</source>
        <translation>Aucun effort senti</translation>
    </message>
    <message>
        <source>No frame in this cell yet. Add one with Insert &gt; Frame.</source>
        <translation>Pas encore de repère dans cette cellule. Ajoutez-en un : Insérer &gt; Repère.</translation>
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
        <source>No haptic server answers at %1.</source>
        <translation>Aucun serveur haptique ne répond à %1.</translation>
    </message>
    <message>
        <source>No haptic server is responding at %1</source>
        <translation>Aucun serveur haptique ne répond à %1</translation>
    </message>
    <message>
        <source>No haptic server is responding at %1:%2.</source>
        <translation>Aucun serveur haptique ne répond à %1:%2.</translation>
    </message>
    <message>
        <source>No haptic server is responding.</source>
        <translation>Aucun serveur haptique ne répond.</translation>
    </message>
    <message>
        <source>No inverse kinematics. Jog the joints instead.</source>
        <translation>Pas de modèle inverse. Bougez plutôt les axes.</translation>
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
        <source>No mannequin in the cell to score.</source>
        <translation>Aucun mannequin à évaluer dans la cellule.</translation>
    </message>
    <message>
        <source>No mannequin of that size</source>
        <translation>Aucun mannequin de cette taille</translation>
    </message>
    <message>
        <source>No mannequin to report on. Add one first.</source>
        <translation>Aucun mannequin pour le rapport. Ajoutez-en un d'abord.</translation>
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
        <source>No matching robot</source>
        <translation>Aucun robot ne correspond</translation>
    </message>
    <message>
        <source>No measurements yet. Connect a stylus and hold an entity.</source>
        <translation>Pas encore de mesures. Connectez un stylet et tenez une entité.</translation>
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
        <source>No placement suits all four mannequins.</source>
        <translation>Aucune place ne convient aux quatre mannequins.</translation>
    </message>
    <message>
        <source>No program on this computer opened %1. Open it in a text editor.</source>
        <translation>Aucun programme n'a ouvert %1. Ouvrez-le dans un éditeur de texte.</translation>
    </message>
    <message>
        <source>No recent contacts</source>
        <translation>Aucun contact récent</translation>
    </message>
    <message>
        <source>No recent files</source>
        <translation>Aucun fichier récent</translation>
    </message>
    <message>
        <source>No recent files. You can also drop files here.</source>
        <translation>Aucun fichier récent. On peut aussi déposer des fichiers ici.</translation>
    </message>
    <message>
        <source>No robot is selected</source>
        <translation>Aucun robot n'est choisi</translation>
    </message>
    <message>
        <source>No rotation about %1</source>
        <translation>Pas de rotation autour de %1</translation>
    </message>
    <message>
        <source>No run without guidance yet.</source>
        <translation>Pas encore d'essai sans assistance.</translation>
    </message>
    <message>
        <source>No run yet</source>
        <translation>Pas encore d'essai</translation>
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
        <source>No strength table is included; you can load your own.</source>
        <translation>Aucune table de force n'est fournie ; vous pouvez charger la vôtre.</translation>
    </message>
    <message>
        <source>No stylus is connected</source>
        <translation>Aucun stylet n'est connecté</translation>
    </message>
    <message>
        <source>No stylus is connected. You see the guide but do not feel it.</source>
        <translation>Aucun stylet n'est connecté. Le guide se voit, sans se sentir.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>None yet. Save this view adds one.</source>
        <translation>Aucune. Enregistrer cette vue en ajoute une.</translation>
    </message>
    <message>
        <source>Not calibrated. Forces stay off until it is.</source>
        <translation>Non étalonné. Les efforts restent coupés d'ici là.</translation>
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
        <source>Not enough memory</source>
        <translation>Mémoire insuffisante</translation>
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
        <source>Not responding: its force is zero</source>
        <translation>Ne répond pas : son effort est nul</translation>
    </message>
    <message>
        <source>Not tested yet. The server must respond first</source>
        <translation>Pas encore testé. Le serveur doit d'abord répondre</translation>
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
        <source>Nothing (free-standing)</source>
        <translation>Rien (libre)</translation>
    </message>
    <message>
        <source>Nothing has been practised yet. Practise first.</source>
        <translation>Rien n'a encore été pratiqué. Entraînez-vous d'abord.</translation>
    </message>
    <message>
        <source>Nothing is held.</source>
        <translation>Rien n'est tenu.</translation>
    </message>
    <message>
        <source>Nothing is held. Press the stylus button to hold it</source>
        <translation>Rien n'est tenu. Pressez le bouton du stylet</translation>
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
        <source>Nothing moved, so nothing was recorded.</source>
        <translation>Rien n'a bougé : rien n'a été enregistré.</translation>
    </message>
    <message>
        <source>Nothing moves until you confirm.</source>
        <translation>Rien ne bouge avant votre accord.</translation>
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
        <source>Observing: another window controls the stylus</source>
        <translation>Observe : une autre fenêtre commande le stylet</translation>
    </message>
    <message>
        <source>Of the pull at full guidance</source>
        <translation>De la traction à pleine assistance</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Arrêt</translation>
    </message>
    <message>
        <source>Off: the mannequin can step so that the hand reaches</source>
        <translation>Arrêt : le mannequin peut avancer pour que la main atteigne</translation>
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
        <source>On contact, unless set for the part</source>
        <translation>Au contact, sauf réglage de la pièce</translation>
    </message>
    <message>
        <source>On link</source>
        <translation>Sur le segment</translation>
    </message>
    <message>
        <source>On the other station, run hapticell-haptic-server --pair once to see the code, then hapticell-haptic-server --listen with its address.</source>
        <translation>Sur l'autre poste, lancez une fois hapticell-haptic-server --pair pour voir le code, puis hapticell-haptic-server --listen avec son adresse.</translation>
    </message>
    <message>
        <source>One is attached to the other, so they move together</source>
        <translation>L'une est attachée à l'autre : elles bougent ensemble</translation>
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
        <source>Only the simulated stylus. No problems found.</source>
        <translation>Seulement le stylet simulé. Aucun problème trouvé.</translation>
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
        <translation>Ouvrez un enregistrement (BVH, AMC, C3D) pour évaluer chacune de ses images.</translation>
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
        <source>Open it by the handle: feel the guide, its stops and a detent.</source>
        <translation>Ouvrez-la par la poignée : sentez le guide, ses butées et un cran.</translation>
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
        <source>Opening</source>
        <translation>Ouverture</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Ouvrir…</translation>
    </message>
    <message>
        <source>Orient faces outwards</source>
        <translation>Orienter les faces vers l'extérieur</translation>
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
        <source>Own frame %1</source>
        <translation>Repère propre %1</translation>
    </message>
    <message>
        <source>Own mesh</source>
        <translation>Maillage</translation>
    </message>
    <message>
        <source>Own origin</source>
        <translation>Origine propre</translation>
    </message>
    <message>
        <source>Own origin, from the file</source>
        <translation>Origine propre, celle du fichier</translation>
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
        <translation>Archiver la cellule avec ses fichiers</translation>
    </message>
    <message>
        <source>Pack them too</source>
        <translation>Les archiver aussi</translation>
    </message>
    <message>
        <source>Pack with all files…</source>
        <translation>Archiver avec tous les fichiers…</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Page %1 sur %2</translation>
    </message>
    <message>
        <source>Page size</source>
        <translation>Taille de la page</translation>
    </message>
    <message>
        <source>Page size. You can also use Ctrl and the wheel.</source>
        <translation>Taille de la page. Ctrl et la molette la changent aussi.</translation>
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
        <translation>Jeux de paires</translation>
    </message>
    <message>
        <source>Pair them again: hapticell-haptic-server --pair there, hapticell-cli pair here.</source>
        <translation>Appairez-les de nouveau : hapticell-haptic-server --pair là-bas, hapticell-cli pair ici.</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Paires</translation>
    </message>
    <message>
        <source>Pairs and sets</source>
        <translation>Paires et jeux</translation>
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
        <source>Pan</source>
        <translation>Décaler</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Panneau</translation>
    </message>
    <message>
        <source>Parent</source>
        <translation>Parent</translation>
    </message>
    <message>
        <source>Parent folder</source>
        <translation>Dossier parent</translation>
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
        <source>Partial scores: %1 not entered. Complete them in Task data…</source>
        <translation>Scores incomplets ; à saisir dans Données de la tâche… : %1.</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Pièces</translation>
    </message>
    <message>
        <source>Parts of a mechanism are solids of the cell.</source>
        <translation>Les pièces d'un mécanisme sont des solides de la cellule.</translation>
    </message>
    <message>
        <source>Parts that can move</source>
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
        <source>Pass mark</source>
        <translation>Seuil</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Réussi</translation>
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
        <translation>Charge admissible</translation>
    </message>
    <message>
        <source>Pelvis</source>
        <translation>Bassin</translation>
    </message>
    <message>
        <source>Per shift</source>
        <translation>Par poste</translation>
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
        <source>Perpendicular to %1</source>
        <translation>Perpendiculaire à %1</translation>
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
        <source>Pick a face, an edge or a corner for the tool's origin and direction</source>
        <translation>Désignez une face, une arête ou un coin : origine et direction de l'outil</translation>
    </message>
    <message>
        <source>Pick a face, edge or corner of the moving part · Esc: end</source>
        <translation>Désignez une face, une arête ou un coin de la pièce à déplacer · Échap : terminer</translation>
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
        <source>Pick in the scene</source>
        <translation>Désigner dans la scène</translation>
    </message>
    <message>
        <source>Pick start and target</source>
        <translation>Désigner départ et cible</translation>
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
        <source>Pick the place for the frame · Esc: end</source>
        <translation>Désignez la place du repère · Échap : terminer</translation>
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
        <source>Pick the target · Esc: end</source>
        <translation>Désignez la cible · Échap : terminer</translation>
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
        <source>Pivot</source>
        <translation>Pivot</translation>
    </message>
    <message>
        <source>Place %1 on %2</source>
        <translation>Poser %1 sur %2</translation>
    </message>
    <message>
        <source>Place in</source>
        <translation>Place dans</translation>
    </message>
    <message>
        <source>Place on</source>
        <translation>Poser sur</translation>
    </message>
    <message>
        <source>Placement</source>
        <translation>Placement</translation>
    </message>
    <message>
        <source>Placement in frame</source>
        <translation>Placement dans le repère</translation>
    </message>
    <message>
        <source>Placement in world</source>
        <translation>Placement dans le monde</translation>
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
        <translation>Lire</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Lire ou suspendre</translation>
    </message>
    <message>
        <source>Play the motion backwards</source>
        <translation>Mouvement à rebours</translation>
    </message>
    <message>
        <source>Playback speed</source>
        <translation>Vitesse de lecture</translation>
    </message>
    <message>
        <source>Played; click to exclude it</source>
        <translation>Lu ; cliquez pour l'exclure</translation>
    </message>
    <message>
        <source>Plays slower than recorded: the view is below 10 Hz</source>
        <translation>Lecture ralentie : la vue est sous 10 Hz</translation>
    </message>
    <message>
        <source>Plugged in at</source>
        <translation>Branché sur</translation>
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
        <source>Point at which the hand holds the entity</source>
        <translation>Point par lequel la main tient l'entité</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Points and guidance by run</source>
        <translation>Points et assistance par essai</translation>
    </message>
    <message>
        <source>Points needed to pass a run</source>
        <translation>Points nécessaires pour réussir un essai</translation>
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
        <source>Port of the server. Default: 4747</source>
        <translation>Port du serveur. Par défaut : 4747</translation>
    </message>
    <message>
        <source>Pose %1 of %2: %3</source>
        <translation>Pose %1 sur %2 : %3</translation>
    </message>
    <message>
        <source>Pose the mannequin and check its reach and posture.</source>
        <translation>Posez le mannequin, vérifiez son atteinte et sa posture.</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
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
        <source>Prepare contacts within</source>
        <translation>Préparer les contacts à moins de</translation>
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
        <source>Preset</source>
        <translation>Préréglage</translation>
    </message>
    <message>
        <source>Press Ctrl+Space to turn them on</source>
        <translation>Ctrl+Espace les met en marche</translation>
    </message>
    <message>
        <source>Press the buttons here, with Ctrl, Alt, Shift</source>
        <translation>Pressez les boutons ici, avec Ctrl, Alt, Maj</translation>
    </message>
    <message>
        <source>Previous folder</source>
        <translation>Dossier précédent</translation>
    </message>
    <message>
        <source>Previous frame (Left, in the time bar)</source>
        <translation>Image précédente (Gauche, dans la barre de temps)</translation>
    </message>
    <message>
        <source>Previous page</source>
        <translation>Page précédente</translation>
    </message>
    <message>
        <source>Previous panel</source>
        <translation>Panneau précédent</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problème</translation>
    </message>
    <message>
        <source>Process point: the motion pauses here for this time</source>
        <translation>Point de travail : le mouvement s'arrête ici ce temps</translation>
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
        <source>R records, Shift+R adds a frame. Recording starts with the first motion.</source>
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
        <source>RULA along the motion, four mannequins</source>
        <translation>RULA le long du mouvement, quatre mannequins</translation>
    </message>
    <message>
        <source>RULA by working height</source>
        <translation>RULA selon la hauteur de travail</translation>
    </message>
    <message>
        <source>RULA by working height, four mannequins</source>
        <translation>RULA selon la hauteur de travail, quatre mannequins</translation>
    </message>
    <message>
        <source>RULA left %1, right %2 · EAWS outline %3 points</source>
        <translation>RULA gauche %1, droite %2 · EAWS (esquisse) %3 points</translation>
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
        <source>Radius around the expert's path</source>
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
        <source>Range</source>
        <translation>Plage</translation>
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
        <source>Reach</source>
        <translation>Atteinte</translation>
    </message>
    <message>
        <source>Reach of P5, P50 and P95</source>
        <translation>Atteinte des P5, P50 et P95</translation>
    </message>
    <message>
        <source>Reach of people of the same sex in the same stance</source>
        <translation>Atteinte de personnes du même sexe, dans la même station</translation>
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
        <source>Ready. One undo step.</source>
        <translation>Prêt. Une étape d'annulation.</translation>
    </message>
    <message>
        <source>Rec %1:%2</source>
        <translation>Enr. %1:%2</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Fichiers récents</translation>
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
        <source>Record by</source>
        <translation>Capturer par</translation>
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
        <source>Relative to</source>
        <translation>Par rapport à</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Relâcher</translation>
    </message>
    <message>
        <source>Release what is held first, then start the run.</source>
        <translation>Relâchez d'abord ce qui est tenu, puis commencez l'essai.</translation>
    </message>
    <message>
        <source>Release what is held first.</source>
        <translation>Relâchez d'abord ce qui est tenu.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Recharger</translation>
    </message>
    <message>
        <source>Reload %1</source>
        <translation>Recharger %1</translation>
    </message>
    <message>
        <source>Reload %1 files</source>
        <translation>Recharger %1 fichiers</translation>
    </message>
    <message>
        <source>Reload from disk</source>
        <translation>Recharger depuis le disque</translation>
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
        <source>Remove hand tremor, keep the path</source>
        <translation>Ôter le tremblement de la main, garder le chemin</translation>
    </message>
    <message>
        <source>Remove the pair set</source>
        <translation>Retirer le jeu de paires</translation>
    </message>
    <message>
        <source>Remove the section</source>
        <translation>Retirer la coupe</translation>
    </message>
    <message>
        <source>Remove this frame</source>
        <translation>Retirer ce repère</translation>
    </message>
    <message>
        <source>Removed: %1 duplicate triangles.</source>
        <translation>Retirés : %1 triangles en double.</translation>
    </message>
    <message>
        <source>Removed: %1 zero-area triangles.</source>
        <translation>Retirés : %1 triangles de surface nulle.</translation>
    </message>
    <message>
        <source>Removes it from the cell; its file stays</source>
        <translation>Le retire de la cellule ; son fichier reste</translation>
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
        <source>Report…</source>
        <translation>Rapport…</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Réinitialiser</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Tout réinitialiser</translation>
    </message>
    <message>
        <source>Reset layout</source>
        <translation>Réinitialiser la disposition</translation>
    </message>
    <message>
        <source>Resize %1</source>
        <translation>Redimensionner %1</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Recommencer</translation>
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
        <source>Retime</source>
        <translation>Recalculer</translation>
    </message>
    <message>
        <source>Retract</source>
        <translation>Dégagement</translation>
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
        <source>Robot library</source>
        <translation>Bibliothèque de robots</translation>
    </message>
    <message>
        <source>Robot near a singularity</source>
        <translation>Robot près d'une singularité</translation>
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
        <source>Rotate %1</source>
        <translation>Tourner %1</translation>
    </message>
    <message>
        <source>Rotate %1 of %2</source>
        <translation>Tourner %1 de %2</translation>
    </message>
    <message numerus="yes">
        <source>Rotate %n entities</source>
        <translation><numerusform>Tourner %n entité</numerusform><numerusform>Tourner %n entités</numerusform></translation>
    </message>
    <message>
        <source>Rotate the view; with Shift, pan</source>
        <translation>Tourne la vue ; avec Maj, la décale</translation>
    </message>
    <message>
        <source>Rotate too: axes aligned, faces flush</source>
        <translation>Tourner aussi : axes alignés, faces à plat</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Rough</source>
        <translation>Grosse</translation>
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
        <source>Safety distance</source>
        <translation>Dist. de sécurité</translation>
    </message>
    <message>
        <source>Safety distance: contact felt at</source>
        <translation>Distance de sécurité : contact senti à</translation>
    </message>
    <message>
        <source>Same task, four mannequins</source>
        <translation>Même tâche, quatre mannequins</translation>
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
        <source>Save it as a file or a robot program</source>
        <translation>L'enregistrer comme fichier ou programme de robot</translation>
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
        <source>Save the cell first (Ctrl+S). The exercise needs its file.</source>
        <translation>Enregistrez d'abord la cellule (Ctrl+S). L'exercice a besoin de son fichier.</translation>
    </message>
    <message>
        <source>Save the change report</source>
        <translation>Enregistrer le rapport des changements</translation>
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
        <source>Save the motion as fitted to this mannequin</source>
        <translation>Enregistrer le mouvement adapté à ce mannequin</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Enregistrer le rapport</translation>
    </message>
    <message>
        <source>Save the workcell</source>
        <translation>Enregistrer la cellule</translation>
    </message>
    <message>
        <source>Save this cell first, then choose the exercise again.</source>
        <translation>Enregistrez d'abord cette cellule ; puis choisissez de nouveau l'exercice.</translation>
    </message>
    <message>
        <source>Save this pose</source>
        <translation>Enregistrer cette pose</translation>
    </message>
    <message>
        <source>Save this pose…</source>
        <translation>Enregistrer cette pose…</translation>
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
        <source>Save this view</source>
        <translation>Enregistrer cette vue</translation>
    </message>
    <message>
        <source>Saved as a copy: %1. The recording is unchanged</source>
        <translation>Enregistré en copie : %1. L'enregistrement d'origine est inchangé</translation>
    </message>
    <message>
        <source>Saved views</source>
        <translation>Vues enregistrées</translation>
    </message>
    <message>
        <source>Saved. Type another to replace it</source>
        <translation>Enregistré. Tapez-en un autre pour le remplacer</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Enregistré : %1</translation>
    </message>
    <message>
        <source>Saved: %1; frames: %2. Tool, base and safety settings are those of the controller. Check them there</source>
        <translation>Enregistré : %1 ; images : %2. Outil, base et sécurité sont ceux de la commande. Vérifiez-les là</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Scale: part motion for the same hand motion</source>
        <translation>Échelle : mouvement de la pièce pour celui de la main</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Scène</translation>
    </message>
    <message>
        <source>Scene description</source>
        <translation>Description de la scène</translation>
    </message>
    <message>
        <source>Scoring the motion…</source>
        <translation>Évaluation du mouvement…</translation>
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
        <source>Search again</source>
        <translation>Chercher de nouveau</translation>
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
        <source>Searching</source>
        <translation>Recherche</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Recherche…</translation>
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
        <source>Select</source>
        <translation>Choisir</translation>
    </message>
    <message>
        <source>Select a row to see it in the scene.</source>
        <translation>Choisissez une ligne pour la voir dans la scène.</translation>
    </message>
    <message>
        <source>Select a row, then press its new key.</source>
        <translation>Choisissez une ligne, puis pressez sa nouvelle touche.</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Tout choisir</translation>
    </message>
    <message>
        <source>Select or hold an entity to see what it is checked against.</source>
        <translation>Choisissez ou tenez une entité pour voir contre quoi elle est vérifiée.</translation>
    </message>
    <message>
        <source>Selected: %1, at X %2, Y %3, Z %4.</source>
        <translation>Choisi : %1, en X %2, Y %3, Z %4.</translation>
    </message>
    <message>
        <source>Sensor %1 hardly moved between the poses. The calibration is unchanged.</source>
        <translation>Le capteur %1 a à peine bougé entre les poses. L'étalonnage est inchangé.</translation>
    </message>
    <message>
        <source>Separate</source>
        <translation>Séparées</translation>
    </message>
    <message>
        <source>Set %1</source>
        <translation>Jeu %1</translation>
    </message>
    <message>
        <source>Set for this pair; click to change it</source>
        <translation>Choisi pour cette paire ; cliquez pour changer</translation>
    </message>
    <message>
        <source>Set the range first, with the brackets that are now in the time bar.</source>
        <translation>Réglez d'abord la plage, par les crochets affichés dans la barre de temps.</translation>
    </message>
    <message>
        <source>Set: %1</source>
        <translation>Jeu : %1</translation>
    </message>
    <message>
        <source>Sets</source>
        <translation>Jeux</translation>
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
        <source>Show keyboard shortcuts</source>
        <translation>Afficher les raccourcis clavier</translation>
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
        <source>Show parts in full colour</source>
        <translation>Pièces en pleines couleurs</translation>
    </message>
    <message>
        <source>Show the motion in the scene; off: show the cell</source>
        <translation>Montrer le mouvement dans la scène ; arrêt : la cellule</translation>
    </message>
    <message>
        <source>Show the start page at start-up</source>
        <translation>Montrer la page d'accueil au démarrage</translation>
    </message>
    <message>
        <source>Show the swept volume of the motion</source>
        <translation>Montrer le volume balayé par le mouvement</translation>
    </message>
    <message>
        <source>Show this page at start-up</source>
        <translation>Montrer cette page au démarrage</translation>
    </message>
    <message>
        <source>Show this posture</source>
        <translation>Montrer cette posture</translation>
    </message>
    <message>
        <source>Shown in the scene</source>
        <translation>Montré dans la scène</translation>
    </message>
    <message>
        <source>Shown when the mannequin stops moving</source>
        <translation>Affiché quand le mannequin ne bouge plus</translation>
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
        <source>Single keys work while the pointer is over the scene; elsewhere they type text.</source>
        <translation>Les touches seules agissent quand le pointeur est sur la scène ; ailleurs elles saisissent du texte.</translation>
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
        <source>Snap positions, separated by spaces</source>
        <translation>Positions d'enclenchement, séparées par des espaces</translation>
    </message>
    <message>
        <source>Snap to corner, edge, face, frame</source>
        <translation>Aimanter aux coins, arêtes, faces, repères</translation>
    </message>
    <message>
        <source>Snapping to corners, edges, faces and frames · Ctrl: free · Esc: cancel</source>
        <translation>Aimante aux coins, arêtes, faces et repères · Ctrl : libre · Échap : annuler</translation>
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
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Speed, friction</source>
        <translation>Vitesse, frott.</translation>
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
        <source>Split at the cursor</source>
        <translation>Couper au curseur</translation>
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
        <source>Start</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>Start from</source>
        <translation>Partir de</translation>
    </message>
    <message>
        <source>Start hapticell-haptic-server.</source>
        <translation>Démarrez hapticell-haptic-server.</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>Page d'accueil</translation>
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
        <source>Start with a sample or your own cell</source>
        <translation>Commencez par un exemple ou par votre propre cellule</translation>
    </message>
    <message>
        <source>Start with an empty cell</source>
        <translation>Commencer par une cellule vide</translation>
    </message>
    <message>
        <source>Start without forces</source>
        <translation>Commencer sans efforts</translation>
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
        <source>Stiffness</source>
        <translation>Raideur</translation>
    </message>
    <message>
        <source>Stiffness (0: as the device)</source>
        <translation>Raideur (0 : celle du périphérique)</translation>
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
        <translation>Bloquer</translation>
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
        <source>Stop recording  (R)</source>
        <translation>Arrêter l'enregistrement  (R)</translation>
    </message>
    <message>
        <source>Stop the video, %1 % done</source>
        <translation>Arrêter la vidéo, %1 % faits</translation>
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
        <source>Stylus</source>
        <translation>Stylet</translation>
    </message>
    <message>
        <source>Stylus at start</source>
        <translation>Stylet au démarrage</translation>
    </message>
    <message>
        <source>Stylus button: hold and release</source>
        <translation>Bouton du stylet : tenir et relâcher</translation>
    </message>
    <message>
        <source>Stylus follows the mouse</source>
        <translation>Le stylet suit la souris</translation>
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
        <translation>Scores partiels du côté le plus défavorable</translation>
    </message>
    <message>
        <source>Sudden loads</source>
        <translation>À-coups</translation>
    </message>
    <message>
        <source>Suggestions appear when the mannequin stops moving.</source>
        <translation>Les suggestions apparaissent quand le mannequin ne bouge plus.</translation>
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
        <source>Switch the forces off first. Panels stay in place while the stylus is in use.</source>
        <translation>Coupez d'abord les efforts. Les panneaux ne bougent pas tant que le stylet sert.</translation>
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
        <source>Take %1</source>
        <translation>Prise %1</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>Prendre le contrôle</translation>
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
        <source>Task for the trainee</source>
        <translation>Tâche de l'apprenant</translation>
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
        <source>The 3D mouse moves the view</source>
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
        <source>The base follows the hand; the joints keep the tool in place</source>
        <translation>La base suit la main ; les axes gardent l'outil en place</translation>
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
        <source>The cell is unchanged.</source>
        <translation>La cellule est inchangée.</translation>
    </message>
    <message>
        <source>The cell still shows the old version. Reloading keeps placements, names and colours.</source>
        <translation>La cellule montre encore l'ancienne version. Places, noms et couleurs restent au rechargement.</translation>
    </message>
    <message>
        <source>The cell was changed or saved, so the run was cancelled. The part is back in its place.</source>
        <translation>La cellule a été modifiée ou enregistrée : l'essai est annulé. La pièce est revenue à sa place.</translation>
    </message>
    <message>
        <source>The device is at the edge of its workspace. Hold Space and move the hand back</source>
        <translation>Le périphérique est au bord de son espace. Tenez Espace et ramenez la main</translation>
    </message>
    <message>
        <source>The device is not responding.</source>
        <translation>Le périphérique ne répond pas.</translation>
    </message>
    <message>
        <source>The device is not responding. Check its cable and power</source>
        <translation>Le périphérique ne répond pas. Vérifiez son câble et son alimentation</translation>
    </message>
    <message>
        <source>The device reports a fault. No force was applied.</source>
        <translation>Le périphérique signale une panne. Aucun effort n'a été appliqué.</translation>
    </message>
    <message>
        <source>The devices could not be listed: %1</source>
        <translation>Les périphériques n'ont pas pu être listés : %1</translation>
    </message>
    <message>
        <source>The displayed mesh.</source>
        <translation>Le maillage affiché.</translation>
    </message>
    <message>
        <source>The drivers are tested against models and recorded data formats, not on real devices.</source>
        <translation>Les pilotes sont testés sur des modèles et des formats enregistrés, pas sur de vrais périphériques.</translation>
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
        <source>The file contains one part.</source>
        <translation>Le fichier contient une pièce.</translation>
    </message>
    <message>
        <source>The file contains triangles.</source>
        <translation>Le fichier contient des triangles.</translation>
    </message>
    <message>
        <source>The file is being read</source>
        <translation>Le fichier est en lecture</translation>
    </message>
    <message>
        <source>The file of %1 has no home pose, and its zero pose is singular, so it could hardly be dragged. It starts with %2 bent. To set a home pose, use the Robot panel.</source>
        <translation>Le fichier de %1 n'indique pas de position de repos, et sa pose zéro est singulière : on pourrait à peine le tirer. Il démarre avec %2 plié. Fixez sa position de repos dans le panneau Robot.</translation>
    </message>
    <message>
        <source>The file states no unit. Is this size right?</source>
        <translation>Le fichier n'indique pas d'unité. Cette taille est-elle la bonne ?</translation>
    </message>
    <message>
        <source>The file states no unit. Which size is right?</source>
        <translation>Le fichier n'indique pas d'unité. Quelle taille est la bonne ?</translation>
    </message>
    <message>
        <source>The force loop is on time</source>
        <translation>La boucle d'effort tient son rythme</translation>
    </message>
    <message>
        <source>The force loop is sometimes late</source>
        <translation>La boucle d'effort est parfois en retard</translation>
    </message>
    <message>
        <source>The frame keeps its current placement and moves with it</source>
        <translation>Le repère garde sa place actuelle et se déplace avec</translation>
    </message>
    <message>
        <source>The glove is not responding. Nothing was recorded.</source>
        <translation>Le gant ne répond pas. Rien n'a été enregistré.</translation>
    </message>
    <message>
        <source>The hands were not moved</source>
        <translation>Les mains n'ont pas bougé</translation>
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
        <source>The haptic server could not be started: %1 was not found or cannot be run.</source>
        <translation>Le serveur haptique n'a pas pu être lancé : %1 est introuvable ou ne peut pas être lancé.</translation>
    </message>
    <message>
        <source>The haptic server has %1 connections from this machine already.</source>
        <translation>Le serveur haptique a déjà %1 connexions de cette machine.</translation>
    </message>
    <message>
        <source>The haptic server has its %1 connections already.</source>
        <translation>Le serveur haptique a déjà ses %1 connexions.</translation>
    </message>
    <message>
        <source>The haptic server has stopped. %1</source>
        <translation>Le serveur haptique s'est arrêté. %1</translation>
    </message>
    <message>
        <source>The haptic server is responding</source>
        <translation>Le serveur haptique répond</translation>
    </message>
    <message>
        <source>The haptic server stopped, so forces are off. Press Ctrl+Space to turn them on again</source>
        <translation>Le serveur haptique s’est arrêté : efforts coupés. Ctrl+Espace les remet en marche</translation>
    </message>
    <message>
        <source>The head goes no further: neck and trunk are at their limits</source>
        <translation>La tête ne va pas plus loin : la nuque et le tronc sont à leurs butées</translation>
    </message>
    <message>
        <source>The held entity is not checked for collision</source>
        <translation>L'entité tenue n'est pas vérifiée pour les collisions</translation>
    </message>
    <message>
        <source>The held entity stays in place. When a server responds again, press Ctrl+Space to turn the forces on.</source>
        <translation>L'entité tenue reste en place. Dès qu’un serveur répond, Ctrl+Espace remet les efforts en marche.</translation>
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
        <source>The left button is free: click to select, drag to draw a selection box.</source>
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
        <source>The lifting equation and the forces on the hands; colours stay those of RULA</source>
        <translation>L'équation de levage et les forces sur les mains ; les couleurs restent celles de RULA</translation>
    </message>
    <message>
        <source>The lifting equation does not cover this lift.</source>
        <translation>L'équation de levage ne s'applique pas à ce levage.</translation>
    </message>
    <message>
        <source>The limit of a method is the start of its next class. Moments include the weight of the arms.</source>
        <translation>La limite d'une méthode est le début de sa classe suivante. Les moments comprennent le poids des bras.</translation>
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
        <source>The mannequin cannot be dragged there</source>
        <translation>Le mannequin ne peut pas être tiré là</translation>
    </message>
    <message>
        <source>The mannequin in its posture</source>
        <translation>Le mannequin dans sa posture</translation>
    </message>
    <message>
        <source>The markers are shown, but no mannequin can be fitted to this marker set: %1</source>
        <translation>Les marqueurs sont affichés, mais aucun mannequin ne peut être ajusté à ce jeu : %1</translation>
    </message>
    <message>
        <source>The markers cannot be shown</source>
        <translation>Les marqueurs ne peuvent pas être montrés</translation>
    </message>
    <message>
        <source>The module %1 was not loaded. %2</source>
        <translation>Le module %1 n'a pas été chargé. %2</translation>
    </message>
    <message>
        <source>The motion cannot be shown</source>
        <translation>Le mouvement ne peut pas être montré</translation>
    </message>
    <message>
        <source>The motion is saved</source>
        <translation>Le mouvement est enregistré</translation>
    </message>
    <message>
        <source>The motion was not exported</source>
        <translation>Le mouvement n'a pas été exporté</translation>
    </message>
    <message>
        <source>The motion was not imported</source>
        <translation>Le mouvement n'a pas été importé</translation>
    </message>
    <message>
        <source>The motion was not saved</source>
        <translation>Le mouvement n'a pas été enregistré</translation>
    </message>
    <message>
        <source>The newest message also appears in the status bar for 8 seconds.</source>
        <translation>Le plus récent apparaît aussi 8 secondes dans la ligne d'état.</translation>
    </message>
    <message>
        <source>The part follows the expert's path; the cell is unchanged</source>
        <translation>La pièce suit le chemin de l'expert ; la cellule est inchangée</translation>
    </message>
    <message>
        <source>The part follows the run and a ghost follows the expert, both at once</source>
        <translation>La pièce suit l'essai et un fantôme suit l'expert, en même temps</translation>
    </message>
    <message>
        <source>The part is shown in a quieter colour than %1</source>
        <translation>La pièce est montrée dans une couleur plus sobre que %1</translation>
    </message>
    <message>
        <source>The parts become solids again, at their current placement</source>
        <translation>Les pièces redeviennent des solides, à leur place actuelle</translation>
    </message>
    <message>
        <source>The parts were moved. Undo, or search again in the cell as it is now.</source>
        <translation>Les pièces ont été déplacées. Annulez, ou relancez la recherche dans la cellule telle qu’elle est.</translation>
    </message>
    <message>
        <source>The path is free.</source>
        <translation>Le chemin est libre.</translation>
    </message>
    <message>
        <source>The path of a recorded motion, simplified</source>
        <translation>Le chemin d'un mouvement enregistré, simplifié</translation>
    </message>
    <message>
        <source>The pelvis stays on the seat, which carries the body</source>
        <translation>Le bassin reste sur le siège, qui porte le corps</translation>
    </message>
    <message>
        <source>The posture is saved</source>
        <translation>La posture est enregistrée</translation>
    </message>
    <message>
        <source>The posture was not loaded</source>
        <translation>La posture n'a pas été chargée</translation>
    </message>
    <message>
        <source>The posture was not saved</source>
        <translation>La posture n'a pas été enregistrée</translation>
    </message>
    <message>
        <source>The preview is made when the file is saved or closed here.</source>
        <translation>L'aperçu est créé quand le fichier est enregistré ou fermé ici.</translation>
    </message>
    <message>
        <source>The program was terminated, or the power failed.</source>
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
        <source>The recovery copy could not be saved</source>
        <translation>La copie de récupération n'a pas pu être enregistrée</translation>
    </message>
    <message>
        <source>The report is saved</source>
        <translation>Le rapport est enregistré</translation>
    </message>
    <message>
        <source>The report was not saved</source>
        <translation>Le rapport n'a pas été enregistré</translation>
    </message>
    <message>
        <source>The result was not saved</source>
        <translation>Le résultat n'a pas été enregistré</translation>
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
        <source>The robot cannot reach the frame: it stays up to %1 or %2 away</source>
        <translation>Le robot n’atteint pas l’image : il en reste jusqu’à %1 ou %2</translation>
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
        <source>The run has no frames. Hold the part with the stylus and move it.</source>
        <translation>L'essai n'a pas d'images. Tenez la pièce avec le stylet et déplacez-la.</translation>
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
        <source>The second stylus was disconnected. Choose it again to start it.</source>
        <translation>Le second stylet s'est déconnecté. Choisissez-le de nouveau pour le démarrer.</translation>
    </message>
    <message>
        <source>The selected row is dashed in the scene.</source>
        <translation>La ligne choisie est en tirets dans la scène.</translation>
    </message>
    <message>
        <source>The server switched them off. Move the stylus to free space, or press Esc, then Ctrl+Space</source>
        <translation>Le serveur les a coupés. Menez le stylet en espace libre, ou pressez Échap, puis Ctrl+Espace</translation>
    </message>
    <message>
        <source>The simulated stylus needs no calibration.</source>
        <translation>Le stylet simulé n'a pas besoin d'étalonnage.</translation>
    </message>
    <message>
        <source>The simulation is not responding. Forces return when it responds again</source>
        <translation>La simulation ne répond pas. Les efforts reviennent dès qu'elle répond</translation>
    </message>
    <message>
        <source>The size was not changed</source>
        <translation>La taille n'a pas été changée</translation>
    </message>
    <message>
        <source>The sizes that cover most users: P5 and P50 woman, P50 and P95 man</source>
        <translation>Les tailles qui couvrent la plupart des utilisateurs : femmes P5 et P50, hommes P50 et P95</translation>
    </message>
    <message>
        <source>The stylus follows the mouse · wheel: depth · Ctrl: rotate · left button: %1 · H: end</source>
        <translation>Le stylet suit la souris · molette : profondeur · Ctrl : tourner · bouton gauche : %1 · H : terminer</translation>
    </message>
    <message>
        <source>The stylus is in its inkwell.</source>
        <translation>Le stylet est dans son encrier.</translation>
    </message>
    <message>
        <source>The stylus was not changed</source>
        <translation>Le stylet n'a pas été changé</translation>
    </message>
    <message>
        <source>The stylus will be pulled down, slowly up to %1 N, for 4 seconds. Hold it loosely in the middle of its workspace. What you hold in the cell is released first.</source>
        <translation>Le stylet sera tiré vers le bas, lentement jusqu'à %1 N, pendant 4 secondes. Tenez-le sans serrer au milieu de son espace. Ce que vous tenez dans la cellule est d'abord relâché.</translation>
    </message>
    <message>
        <source>The task is not a lift. The forces are below.</source>
        <translation>La tâche n'est pas un levage. Les forces sont ci-dessous.</translation>
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
        <source>The workcell was not saved</source>
        <translation>La cellule n'a pas été enregistrée</translation>
    </message>
    <message>
        <source>The workplace search failed</source>
        <translation>La recherche d'implantation a échoué</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thème</translation>
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
        <source>There is no motion to go back over.</source>
        <translation>Il n'y a pas de mouvement à remonter.</translation>
    </message>
    <message>
        <source>There was not enough memory to prepare the contacts: what was changed is not felt. Remove large parts</source>
        <translation>La mémoire n'a pas suffi pour préparer les contacts : ce qui a changé n'est pas senti. Retirez de grandes pièces</translation>
    </message>
    <message>
        <source>These are the markers of %1. To put the recording on the mannequin: Mannequin &gt; Open a recorded motion.</source>
        <translation>Ce sont les marqueurs de %1. Pour les poser sur le mannequin : Mannequin &gt; Ouvrir un mouvement enregistré.</translation>
    </message>
    <message>
        <source>These parts can move, with the targets of the hands</source>
        <translation>Ces pièces peuvent bouger, avec les cibles des mains</translation>
    </message>
    <message>
        <source>These settings are stored in %1. You can add materials and driver keys there.</source>
        <translation>Ces réglages sont dans %1. Vous pouvez y ajouter des matériaux et des clés de pilotes.</translation>
    </message>
    <message>
        <source>They are %1 above it. Lower the seat or add a footrest.</source>
        <translation>Ils sont à %1 au-dessus. Abaissez le siège ou ajoutez un repose-pieds.</translation>
    </message>
    <message>
        <source>They move together. The last one selected is the pivot.</source>
        <translation>Elles bougent ensemble. La dernière choisie sert de pivot.</translation>
    </message>
    <message>
        <source>Thigh clearance</source>
        <translation>Épaisseur de la cuisse</translation>
    </message>
    <message>
        <source>This cell has never been saved. Compare it with the imported files instead.</source>
        <translation>Cette cellule n'a jamais été enregistrée. Comparez-la plutôt aux fichiers importés.</translation>
    </message>
    <message>
        <source>This device has no force feedback</source>
        <translation>Ce périphérique n'a pas de retour d'effort</translation>
    </message>
    <message>
        <source>This device has no force feedback.</source>
        <translation>Ce périphérique n'a pas de retour d'effort.</translation>
    </message>
    <message>
        <source>This entity has no frames</source>
        <translation>Cette entité n'a pas de repère</translation>
    </message>
    <message>
        <source>This entity is not checked against anything. Choose pair sets on the left.</source>
        <translation>Cette entité n'est vérifiée contre rien. Choisissez des jeux de paires à gauche.</translation>
    </message>
    <message>
        <source>This exercise was practised. Choose Retention here, or test transfer on another exercise.</source>
        <translation>Cet exercice a été pratiqué. Choisissez ici Rétention, ou testez le transfert sur un autre.</translation>
    </message>
    <message>
        <source>This is the current configuration.</source>
        <translation>C'est la configuration actuelle.</translation>
    </message>
    <message>
        <source>This keeps contacts easy to see. To change it: Settings &gt; Appearance &gt; Show parts in full colour.</source>
        <translation>Les contacts restent ainsi bien visibles. Pour changer : Réglages &gt; Apparence &gt; Pièces en pleines couleurs.</translation>
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
        <source>This motion has no path. Choose another.</source>
        <translation>Ce mouvement n'a pas de chemin : choisissez-en un autre.</translation>
    </message>
    <message>
        <source>This picture is at the top of every report</source>
        <translation>Cette image figure en tête de chaque rapport</translation>
    </message>
    <message>
        <source>This placement does not give the score that was found</source>
        <translation>Cette place ne donne pas le score trouvé</translation>
    </message>
    <message>
        <source>This pose is out of reach</source>
        <translation>Cette pose est hors d'atteinte</translation>
    </message>
    <message>
        <source>This solid has no frame yet. Add one below.</source>
        <translation>Ce solide n'a pas encore de repère. Ajoutez-en un ci-dessous.</translation>
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
        <source>Through its eyes</source>
        <translation>Par ses yeux</translation>
    </message>
    <message>
        <source>Through the mannequin's eyes</source>
        <translation>Par les yeux du mannequin</translation>
    </message>
    <message>
        <source>Tick at least one part: a bench, a shelf, a fixture.</source>
        <translation>Cochez au moins une pièce : un établi, une étagère, un posage.</translation>
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
        <source>Time in the recording</source>
        <translation>Instant de l'enregistrement</translation>
    </message>
    <message>
        <source>Time s</source>
        <translation>Temps s</translation>
    </message>
    <message>
        <source>Time to reach the greatest acceleration</source>
        <translation>Temps pour atteindre la plus grande accélération</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Temps</translation>
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
        <source>To go back to it: View &gt; Saved views.</source>
        <translation>Pour y revenir : Vue &gt; Vues enregistrées.</translation>
    </message>
    <message>
        <source>To lower it: %1.</source>
        <translation>Pour l'abaisser : %1.</translation>
    </message>
    <message>
        <source>To take it back, use Take control in the Virtual Desktop panel.</source>
        <translation>Pour le reprendre, utilisez « Prendre le contrôle » dans le panneau Virtual Desktop.</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
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
        <source>Tool, base and safety settings stay those of the controller</source>
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
        <source>Touch something with forces on to measure the delay from felt to displayed</source>
        <translation>Touchez quelque chose, efforts en marche, pour mesurer le délai entre ressenti et affichage</translation>
    </message>
    <message>
        <source>Touchpad</source>
        <translation>Pavé tactile</translation>
    </message>
    <message>
        <source>Train on a motion…</source>
        <translation>S'exercer sur un mouvement…</translation>
    </message>
    <message>
        <source>Trainee</source>
        <translation>Apprenant</translation>
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
        <source>Travel</source>
        <translation>Course</translation>
    </message>
    <message>
        <source>Travel distance</source>
        <translation>Course du levage</translation>
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
        <source>Trying every placement with four mannequins…</source>
        <translation>Essai de chaque place avec quatre mannequins…</translation>
    </message>
    <message>
        <source>Tube</source>
        <translation>Tube</translation>
    </message>
    <message>
        <source>Turns the eyes towards the last selected part, as far as they go</source>
        <translation>Tourne les yeux vers la dernière pièce choisie, autant qu'ils le peuvent</translation>
    </message>
    <message>
        <source>Turntable video</source>
        <translation>Vidéo d'un tour</translation>
    </message>
    <message>
        <source>Turntable video…</source>
        <translation>Vidéo d'un tour…</translation>
    </message>
    <message>
        <source>Two fingers rotate; with Shift they pan, with Ctrl they zoom</source>
        <translation>Deux doigts tournent ; avec Maj ils décalent, avec Ctrl ils zooment</translation>
    </message>
    <message>
        <source>Two hands</source>
        <translation>Deux mains</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
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
        <source>URDF of the robot (*.urdf)</source>
        <translation>URDF du robot (*.urdf)</translation>
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
        <source>Unknown</source>
        <translation>Inconnue</translation>
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
        <source>Unsaved changes</source>
        <translation>Changements non enregistrés</translation>
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
        <source>Up/down ±</source>
        <translation>Haut/bas ±</translation>
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
        <source>Use single keys without Ctrl</source>
        <translation>Utiliser les touches seules, sans Ctrl</translation>
    </message>
    <message>
        <source>Use the selected motion as the expert's, in the current cell</source>
        <translation>Prendre le mouvement choisi comme celui de l'expert, dans la cellule actuelle</translation>
    </message>
    <message>
        <source>Use this one</source>
        <translation>Utiliser celui-ci</translation>
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
        <source>Virtual Desktop</source>
        <translation>Virtual Desktop</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>Visible</translation>
    </message>
    <message>
        <source>Visible share</source>
        <translation>Part visible</translation>
    </message>
    <message>
        <source>Waiting for the haptic server</source>
        <translation>En attente du serveur haptique</translation>
    </message>
    <message>
        <source>Waiting for the previous file</source>
        <translation>En attente du fichier précédent</translation>
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
        <source>Weight limit</source>
        <translation>Poids limite</translation>
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
        <source>What the 3D mouse moves; its second button changes it</source>
        <translation>Ce que la souris 3D déplace ; son second bouton le change</translation>
    </message>
    <message>
        <source>What the tip touches</source>
        <translation>Ce que touche la pointe</translation>
    </message>
    <message>
        <source>What to keep where the wrist would have to turn faster than it can</source>
        <translation>Que garder là où le poignet devrait tourner plus vite qu'il ne peut</translation>
    </message>
    <message>
        <source>What to pick</source>
        <translation>Quoi désigner</translation>
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
        <source>When</source>
        <translation>Quand</translation>
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
        <source>Whole mannequin</source>
        <translation>Mannequin entier</translation>
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
        <source>Without guidance, a day and a week after practice.</source>
        <translation>Sans assistance, un jour et une semaine après l'entraînement.</translation>
    </message>
    <message>
        <source>Without guidance, a day and a week after practice. Last practice: %1 ago.</source>
        <translation>Sans assistance, un jour et une semaine après l'entraînement. Dernier : il y a %1.</translation>
    </message>
    <message>
        <source>Without guidance, on an exercise that was not practised.</source>
        <translation>Sans assistance, sur un exercice qui n'a pas été pratiqué.</translation>
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
        <translation>Recherche d'implantation</translation>
    </message>
    <message>
        <source>Workplace search…</source>
        <translation>Recherche d'implantation…</translation>
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
        <source>Worst RULA of four mannequins</source>
        <translation>Pire RULA de quatre mannequins</translation>
    </message>
    <message>
        <source>Worst phase</source>
        <translation>Phase critique</translation>
    </message>
    <message>
        <source>Write all moves</source>
        <translation>Écrire tous les déplacements</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>Écriture de %1</translation>
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
        <source>You can also type a number with its unit: 2 in, 0.5 m, 1.57 rad. Files are not affected.</source>
        <translation>Vous pouvez aussi saisir un nombre avec son unité : 2 in, 0.5 m, 1.57 rad. Les fichiers ne changent pas.</translation>
    </message>
    <message>
        <source>You can keep working in the cell.</source>
        <translation>Vous pouvez continuer à travailler.</translation>
    </message>
    <message>
        <source>Your last action was not carried out, and the workcell is unchanged. Save it, then close other programs or remove parts you do not need.</source>
        <translation>Votre dernière action n'a pas été exécutée, et la cellule est inchangée. Enregistrez-la, puis fermez d'autres programmes ou retirez les pièces inutiles.</translation>
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
        <source>a high risk</source>
        <translation>un risque élevé</translation>
    </message>
    <message>
        <source>about </source>
        <translation>environ </translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>autour de %1</translation>
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
        <source>age: median %1 ms, 99th percentile %2 ms; %3</source>
        <translation>âge : médiane %1 ms, 99e centile %2 ms ; %3</translation>
    </message>
    <message>
        <source>along %1</source>
        <translation>le long de %1</translation>
    </message>
    <message>
        <source>an increased risk for some</source>
        <translation>un risque accru pour certains</translation>
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
        <source>as in the controller</source>
        <translation>celui de la commande</translation>
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
        <source>best %1</source>
        <translation>meilleur %1</translation>
    </message>
    <message>
        <source>by %1</source>
        <translation>de %1</translation>
    </message>
    <message>
        <source>carried by the seat</source>
        <translation>porté par le siège</translation>
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
        <source>clearance</source>
        <translation>distance</translation>
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
        <source>contact mode</source>
        <translation>mode de contact</translation>
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
        <source>current</source>
        <translation>actuelle</translation>
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
        <source>delay: median %1 ms, maximum %2 ms, contacts: %3; up to %4 ms is not noticeable</source>
        <translation>délai : médiane %1 ms, maximum %2 ms, contacts : %3 ; jusqu'à %4 ms, imperceptible</translation>
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
        <source>excluded</source>
        <translation>exclu</translation>
    </message>
    <message>
        <source>far</source>
        <translation>loin</translation>
    </message>
    <message>
        <source>farther away</source>
        <translation>plus loin</translation>
    </message>
    <message>
        <source>file missing</source>
        <translation>fichier manquant</translation>
    </message>
    <message>
        <source>final %1. A value on a class boundary belongs to the lower class.</source>
        <translation>final %1. Une valeur à la limite de deux classes appartient à la classe inférieure.</translation>
    </message>
    <message>
        <source>fine</source>
        <translation>fine</translation>
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
        <source>free to move</source>
        <translation>libre</translation>
    </message>
    <message>
        <source>front</source>
        <translation>devant</translation>
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
        <source>h</source>
        <translation>h</translation>
    </message>
    <message>
        <source>held</source>
        <translation>tenu</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>caché</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>tenir</translation>
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
        <source>it needs a good, fair or poor grip.</source>
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
        <source>left %1</source>
        <translation>%1 gauche</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>butée</translation>
    </message>
    <message>
        <source>limits exceeded: %1</source>
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
        <source>loading…</source>
        <translation>chargement…</translation>
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
        <source>medium</source>
        <translation>moyenne</translation>
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
        <source>minimum clearance %1 at %2 s</source>
        <translation>distance minimale %1 à %2 s</translation>
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
        <source>mm wide</source>
        <translation>mm de large</translation>
    </message>
    <message>
        <source>mm/s</source>
        <translation>mm/s</translation>
    </message>
    <message>
        <source>mm/turn</source>
        <translation>mm/tour</translation>
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
        <translation>quasi-collision</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>no clearance</source>
        <translation>pas de distance</translation>
    </message>
    <message>
        <source>no contact</source>
        <translation>sans contact</translation>
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
        <source>none nearby</source>
        <translation>rien à proximité</translation>
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
        <source>not needed</source>
        <translation>inutile</translation>
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
        <source>only one hand carries the load; it covers lifts with both hands. Use RULA or REBA.</source>
        <translation>une seule main porte la charge ; elle vaut pour les levages à deux mains. Utilisez RULA ou REBA.</translation>
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
        <source>recording</source>
        <translation>enregistrement</translation>
    </message>
    <message>
        <source>release</source>
        <translation>relâcher</translation>
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
        <source>retimed</source>
        <translation>temps recalculés</translation>
    </message>
    <message>
        <source>reversed</source>
        <translation>inversé</translation>
    </message>
    <message>
        <source>right %1</source>
        <translation>%1 droite</translation>
    </message>
    <message>
        <source>rough</source>
        <translation>grosse</translation>
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
        <source>screen</source>
        <translation>écran</translation>
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
        <source>singularities, configuration changes: %1</source>
        <translation>singularités, changements de configuration : %1</translation>
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
        <source>stylus button</source>
        <translation>bouton du stylet</translation>
    </message>
    <message>
        <source>the arm is at the edge of its reach</source>
        <translation>le bras est au bord de son atteinte</translation>
    </message>
    <message>
        <source>the equation covers shifts of up to 8 h.</source>
        <translation>l'équation vaut pour des postes de 8 h au plus.</translation>
    </message>
    <message>
        <source>the lift and the forces</source>
        <translation>le levage et les efforts</translation>
    </message>
    <message>
        <source>the mannequin sits or kneels; it covers lifts while standing. Use RULA or REBA.</source>
        <translation>le mannequin est assis ou à genoux ; elle vaut pour les levages debout. Utilisez RULA ou REBA.</translation>
    </message>
    <message>
        <source>the placements of the imported files</source>
        <translation>les places des fichiers importés</translation>
    </message>
    <message>
        <source>the top level</source>
        <translation>le premier niveau</translation>
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
        <translation>apprenant</translation>
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
        <source>where it is held</source>
        <translation>là où elle est tenue</translation>
    </message>
    <message>
        <source>with a dwell</source>
        <translation>avec temporisation</translation>
    </message>
    <message>
        <source>with a frame</source>
        <translation>avec une image</translation>
    </message>
    <message>
        <source>with approach</source>
        <translation>avec approche</translation>
    </message>
    <message>
        <source>with retract</source>
        <translation>avec dégagement</translation>
    </message>
    <message>
        <source>without a frame</source>
        <translation>sans une image</translation>
    </message>
    <message>
        <source>without a range</source>
        <translation>sans une plage</translation>
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
