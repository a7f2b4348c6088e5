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
        <source> (shown in the scene)</source>
        <translation> (montrée dans la scène)</translation>
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
        <source>&quot;%1&quot; is missing</source>
        <translation>&quot;%1&quot; manque</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not in the text</source>
        <translation>&quot;%1&quot;, qui n'est pas dans le texte</translation>
    </message>
    <message>
        <source>&quot;%1&quot; uses this key and would lose it.</source>
        <translation>« %1 » utilise cette touche et la perdrait.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; with a unit</source>
        <translation>&quot;%1&quot; avec une unité</translation>
    </message>
    <message>
        <source>&quot;mid&quot; or &quot;end&quot;</source>
        <translation>&quot;mid&quot; ou &quot;end&quot;</translation>
    </message>
    <message>
        <source>$(find), $(arg), $(env), $(optenv), $(eval), $(dirname) or $(cwd)</source>
        <translation>$(find), $(arg), $(env), $(optenv), $(eval), $(dirname) ou $(cwd)</translation>
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
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 %2 %3</source>
        <translation>%1 %2 %3</translation>
    </message>
    <message>
        <source>%1 %2 of %3</source>
        <translation>%1 %2 sur %3</translation>
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
        <source>%1 (%2 m or more)</source>
        <translation>%1 (%2 m ou plus)</translation>
    </message>
    <message>
        <source>%1 (%2 times)</source>
        <translation>%1 (%2 fois)</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (%2 à %3)</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 (%2) is left out</source>
        <translation>%1 (%2) est ignoré</translation>
    </message>
    <message>
        <source>%1 (%2) is left out: %3</source>
        <translation>%1 (%2) est ignoré : %3</translation>
    </message>
    <message>
        <source>%1 (%2): %3</source>
        <translation>%1 (%2) : %3</translation>
    </message>
    <message>
        <source>%1 (above 0)</source>
        <translation>%1 (supérieur à 0)</translation>
    </message>
    <message>
        <source>%1 (not usable)</source>
        <translation>%1 (inutilisable)</translation>
    </message>
    <message>
        <source>%1 (process %2)</source>
        <translation>%1 (processus %2)</translation>
    </message>
    <message>
        <source>%1 (unplugged)</source>
        <translation>%1 (débranché)</translation>
    </message>
    <message>
        <source>%1 = %2</source>
        <translation>%1 = %2</translation>
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
        <source>%1 after packing, or different ones</source>
        <translation>%1 après l'archivage, ou différents</translation>
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
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>%1 and %2 in total</source>
        <translation>%1 et %2 au total</translation>
    </message>
    <message>
        <source>%1 and %2 joints</source>
        <translation>%1 et %2 articulations</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 et %2 autres</translation>
    </message>
    <message>
        <source>%1 and %2 more: triangles face inward; they count as facing outward</source>
        <translation>%1 et %2 de plus : des triangles sont tournés vers l'intérieur ; ils comptent comme tournés vers l'extérieur</translation>
    </message>
    <message>
        <source>%1 are in contact at the start</source>
        <translation>%1 sont en contact au départ</translation>
    </message>
    <message>
        <source>%1 as in the workcell</source>
        <translation>%1 comme dans la cellule</translation>
    </message>
    <message>
        <source>%1 as the key of a dictionary</source>
        <translation>%1 comme clé d'un dictionnaire</translation>
    </message>
    <message>
        <source>%1 blocks</source>
        <translation>%1 blocs</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 octets</translation>
    </message>
    <message>
        <source>%1 bytes after the last frame are not read; they are not complete frames</source>
        <translation>%1 octets après la dernière image ne sont pas lus ; ils ne forment pas d'images entières</translation>
    </message>
    <message>
        <source>%1 bytes after the last triangle were not read</source>
        <translation>%1 octets après le dernier triangle n'ont pas été lus</translation>
    </message>
    <message>
        <source>%1 bytes without the identifier</source>
        <translation>%1 octets sans l'identifiant</translation>
    </message>
    <message>
        <source>%1 can be taken out as the cell stands.</source>
        <translation>%1 peut être retiré, la cellule étant ce qu'elle est.</translation>
    </message>
    <message>
        <source>%1 can be taken out once %2 has gone.</source>
        <translation>%1 peut être sorti une fois %2 parti.</translation>
    </message>
    <message>
        <source>%1 can be taken out once %2 parts have gone.</source>
        <translation>%1 peut être retiré après %2 autres pièces.</translation>
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
        <source>%1 characters</source>
        <translation>%1 caractères</translation>
    </message>
    <message>
        <source>%1 compared with %2</source>
        <translation>%1 face à %2 dans une comparaison</translation>
    </message>
    <message>
        <source>%1 contains %2</source>
        <translation>%1 contient %2</translation>
    </message>
    <message>
        <source>%1 contains itself through '%2'; it is moved to the top of the tree</source>
        <translation>%1 se trouve sous elle-même par l'intermédiaire de '%2' ; elle est placée en haut de l'arbre</translation>
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
        <source>%1 damaged entries (the first: %2)</source>
        <translation>%1 entrées endommagées (la première : %2)</translation>
    </message>
    <message>
        <source>%1 disabled pairs instead of %2</source>
        <translation>%1 paires désactivées au lieu de %2</translation>
    </message>
    <message>
        <source>%1 does not go along with %2: %3</source>
        <translation>%1 n'accompagne pas %2 : %3</translation>
    </message>
    <message>
        <source>%1 duplicate triangles were removed</source>
        <translation>%1 triangles en double ont été supprimés</translation>
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
        <source>%1 elements %2</source>
        <translation>%1 éléments %2</translation>
    </message>
    <message>
        <source>%1 elements %2 were not used</source>
        <translation>les %1 éléments %2 n'ont pas été utilisés</translation>
    </message>
    <message>
        <source>%1 elements without data</source>
        <translation>%1 éléments sans données</translation>
    </message>
    <message>
        <source>%1 elements, more than its buffer view has</source>
        <translation>%1 éléments, plus que sa vue de tampon (buffer view) n'en contient</translation>
    </message>
    <message>
        <source>%1 entries</source>
        <translation>%1 éléments</translation>
    </message>
    <message>
        <source>%1 equal legs of %2 joints have free ends: for a parallel robot, the file does not define the closed loops; define them in a robot.toml (docs/user/formats.md)</source>
        <translation>%1 jambes identiques de %2 axes ont une extrémité libre : si c'est un robot parallèle, ses boucles sont ouvertes, car le fichier ne les indique pas ; fermez-les par un robot.toml (docs/user/formats.md)</translation>
    </message>
    <message>
        <source>%1 faces are self-intersecting or not planar; they were split into triangle fans</source>
        <translation>%1 faces se croisent elles-mêmes ou ne sont pas planes ; elles ont été découpées en éventail</translation>
    </message>
    <message>
        <source>%1 faces have a colour by index in a colour map; it was left out</source>
        <translation>%1 faces ont une couleur donnée par son numéro dans une table ; elle a été ignorée</translation>
    </message>
    <message>
        <source>%1 faces have an invalid colour (expected numbers, 0 or more); it was left out</source>
        <translation>%1 faces ont une couleur dont les valeurs ne sont pas des nombres positifs ou nuls ; elle a été ignorée</translation>
    </message>
    <message>
        <source>%1 faces were flipped outwards.</source>
        <translation>%1 faces ont été retournées vers l'extérieur.</translation>
    </message>
    <message>
        <source>%1 faces with fewer than three corners were removed</source>
        <translation>%1 faces de moins de trois coins ont été supprimées</translation>
    </message>
    <message>
        <source>%1 farther</source>
        <translation>%1 plus loin</translation>
    </message>
    <message>
        <source>%1 fields</source>
        <translation>%1 champs</translation>
    </message>
    <message>
        <source>%1 files are outside its folder</source>
        <translation>%1 fichiers sont hors de son dossier</translation>
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
        <source>%1 finite numbers</source>
        <translation>%1 nombres finis</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 images</translation>
    </message>
    <message>
        <source>%1 frames, as the file states</source>
        <translation>%1 images, comme le fichier l'indique</translation>
    </message>
    <message>
        <source>%1 gives %2.</source>
        <translation>%1 donne %2.</translation>
    </message>
    <message>
        <source>%1 goals</source>
        <translation>%1 buts</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>%1 has %2 numbers</source>
        <translation>%1 a %2 nombres</translation>
    </message>
    <message>
        <source>%1 has been plugged in</source>
        <translation>%1 vient d'être branché</translation>
    </message>
    <message>
        <source>%1 has no function '%2'</source>
        <translation>%1 n'a pas de fonction '%2'</translation>
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
    <message>
        <source>%1 holds the cause and your last actions. Nothing was sent. If you report the fault, you can attach this file.</source>
        <translation>%1 contient la cause et vos dernières actions. Rien n'a été envoyé. Si vous signalez le défaut, vous pouvez joindre ce fichier.</translation>
    </message>
    <message>
        <source>%1 in ${%2}</source>
        <translation>%1, dans ${%2}</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 dans %2</translation>
    </message>
    <message numerus="yes">
        <source>%1 in %n frames</source>
        <translation><numerusform>%1 sur %n image</numerusform><numerusform>%1 sur %n images</numerusform></translation>
    </message>
    <message>
        <source>%1 in line %2</source>
        <translation>%1 à la ligne %2</translation>
    </message>
    <message>
        <source>%1 in the pack</source>
        <translation>%1 dans l'archive</translation>
    </message>
    <message>
        <source>%1 in total</source>
        <translation>%1 au total</translation>
    </message>
    <message>
        <source>%1 instead of a list</source>
        <translation>%1 là où il faut une liste</translation>
    </message>
    <message>
        <source>%1 instead of a number</source>
        <translation>%1 là où il faut un nombre</translation>
    </message>
    <message>
        <source>%1 instead of a text</source>
        <translation>%1 là où il faut un texte</translation>
    </message>
    <message>
        <source>%1 instead of a whole number</source>
        <translation>%1 là où il faut un nombre entier</translation>
    </message>
    <message>
        <source>%1 is %2</source>
        <translation>%1 est %2</translation>
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
        <source>%1 is %2 from %3 at the goal, and clear of it until %4 s</source>
        <translation>%1 est à %2 de %3 au but, et en est dégagé jusqu'à %4 s</translation>
    </message>
    <message>
        <source>%1 is %2 from %3 at the start, and clear of it from %4 s on</source>
        <translation>%1 est à %2 de %3 au départ, et en est dégagé à partir de %4 s</translation>
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
        <source>%1 is a list</source>
        <translation>un %1 qui est une liste</translation>
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
        <source>%1 is at the goal.</source>
        <translation>%1 est au but.</translation>
    </message>
    <message>
        <source>%1 is being imported. The messages show what was noticed.</source>
        <translation>%1 est en cours d'importation. Les messages montrent ce qui a été remarqué.</translation>
    </message>
    <message>
        <source>%1 is empty</source>
        <translation>un %1 vide</translation>
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
        <source>%1 is kept without its shape: %2</source>
        <translation>%1 est conservée sans sa forme : %2</translation>
    </message>
    <message>
        <source>%1 is known</source>
        <translation>%1 est connu</translation>
    </message>
    <message>
        <source>%1 is left out: %2</source>
        <translation>%1 est ignoré : %2</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>%1 manque</translation>
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
        <source>%1 is not a list</source>
        <translation>%1 n'est pas une liste</translation>
    </message>
    <message>
        <source>%1 is not a readable picture. Choose a PNG, JPEG or SVG file. The report is unchanged.</source>
        <translation>%1 n'est pas une image lisible. Choisissez un fichier PNG, JPEG ou SVG. Le rapport est inchangé.</translation>
    </message>
    <message>
        <source>%1 is not above %2</source>
        <translation>%1 ne se trouve pas plus haut que %2</translation>
    </message>
    <message>
        <source>%1 is not finite</source>
        <translation>%1 n'est pas fini</translation>
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
        <source>%1 is used as up, as set</source>
        <translation>le haut est %1, comme demandé</translation>
    </message>
    <message>
        <source>%1 is used as up, as set; the body stands along %2</source>
        <translation>le haut est %1, comme demandé ; le corps se tient selon %2</translation>
    </message>
    <message>
        <source>%1 is used as up, as set; the file states %2</source>
        <translation>le haut est %1, comme demandé ; le fichier indique %2</translation>
    </message>
    <message>
        <source>%1 is used as up, as set; the head is above the feet along %2</source>
        <translation>le haut est %1, comme demandé ; la tête est au-dessus des pieds selon %2</translation>
    </message>
    <message>
        <source>%1 is used as up: the head is above the feet along it</source>
        <translation>le haut est %1 : la tête est au-dessus des pieds selon cet axe</translation>
    </message>
    <message>
        <source>%1 is used, but only until you quit.</source>
        <translation>%1 est utilisé, mais seulement jusqu'à la fermeture.</translation>
    </message>
    <message>
        <source>%1 joint positions</source>
        <translation>%1 positions d'axes</translation>
    </message>
    <message>
        <source>%1 joint values</source>
        <translation>%1 valeurs d'axe</translation>
    </message>
    <message>
        <source>%1 joints</source>
        <translation>%1 axes</translation>
    </message>
    <message>
        <source>%1 joints are on the path to this link</source>
        <translation>%1 axes mènent à ce segment</translation>
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
        <source>%1 lines that begin with %2 are not supported</source>
        <translation>%1 lignes qui commencent par %2 n'ont pas été comprises</translation>
    </message>
    <message>
        <source>%1 links</source>
        <translation>%1 segments</translation>
    </message>
    <message>
        <source>%1 links, %2 joints</source>
        <translation>%1 segments, %2 axes</translation>
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
        <source>%1 materials have a texture, which is not shown</source>
        <translation>%1 matériaux ont une image, qui n'est pas affichée</translation>
    </message>
    <message>
        <source>%1 materials have an invalid colour (expected three numbers, 0 or more)</source>
        <translation>%1 matériaux ont une couleur qui n'est pas faite de trois nombres positifs ou nuls</translation>
    </message>
    <message>
        <source>%1 may contain the work of others.</source>
        <translation>%1 contient peut-être le travail d’autrui.</translation>
    </message>
    <message>
        <source>%1 meshes were not found and are left out: %2</source>
        <translation>%1 maillages cités sont introuvables et ont été omis : %2</translation>
    </message>
    <message>
        <source>%1 messages in %2 chunks, as the file has</source>
        <translation>%1 messages en %2 blocs, comme dans le fichier</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
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
        <source>%1 models were not found and are left out: %2</source>
        <translation>%1 modèles cités sont introuvables et ont été omis : %2</translation>
    </message>
    <message>
        <source>%1 more lines have similar messages.</source>
        <translation>Et %1 autres lignes de ce genre.</translation>
    </message>
    <message>
        <source>%1 motions, or one without frames</source>
        <translation>%1 mouvements, ou un mouvement sans points</translation>
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
        <source>%1 moves with %2, which the other stylus holds: release it there first</source>
        <translation>%1 se déplace avec %2, que tient l'autre stylet : relâchez d'abord l'entité avec ce stylet</translation>
    </message>
    <message>
        <source>%1 moving joints instead of %2</source>
        <translation>%1 axes mobiles au lieu de %2</translation>
    </message>
    <message>
        <source>%1 moving joints move this link</source>
        <translation>%1 axes mobiles le portent</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 names '%2', which is left out. Plug-ins are loaded only from absolute paths of folders that no other user can write to.</source>
        <translation>%1 nomme '%2', qui est ignoré. Les modules ne sont chargés que depuis des chemins absolus de dossiers où aucun autre utilisateur ne peut écrire.</translation>
    </message>
    <message>
        <source>%1 nearer</source>
        <translation>%1 plus près</translation>
    </message>
    <message>
        <source>%1 numbers</source>
        <translation>%1 nombres</translation>
    </message>
    <message>
        <source>%1 numbers in %2</source>
        <translation>%1 nombres dans %2</translation>
    </message>
    <message>
        <source>%1 numbers in brackets</source>
        <translation>%1 nombres entre crochets</translation>
    </message>
    <message>
        <source>%1 numbers in frame %2</source>
        <translation>%1 nombres dans l'image %2</translation>
    </message>
    <message>
        <source>%1 numbers, one per channel</source>
        <translation>%1 nombres, un par canal</translation>
    </message>
    <message>
        <source>%1 numbers, or not a unit quaternion</source>
        <translation>%1 nombres, ou un quaternion qui n'est pas unitaire</translation>
    </message>
    <message>
        <source>%1 numbers, separated by semicolons</source>
        <translation>%1 nombres, séparés par des points-virgules</translation>
    </message>
    <message>
        <source>%1 numbers, separated by semicolons: those of the external axes first; or %2 of its own, and the axes stay</source>
        <translation>%1 nombres, séparés par des points-virgules : d'abord ceux des axes externes ; ou %2 pour le robot seul, et les axes ne bougent pas</translation>
    </message>
    <message>
        <source>%1 numbers: t,x,y,z,qw,qx,qy,qz, the joints and the channels</source>
        <translation>%1 nombres : t,x,y,z,qw,qx,qy,qz, les axes et les canaux</translation>
    </message>
    <message>
        <source>%1 objects or groups with common open edges were joined to %2 solids</source>
        <translation>%1 objets ou groupes qui se touchent par leurs bords ouverts forment %2 solides</translation>
    </message>
    <message>
        <source>%1 objects or groups with common open edges were joined to 1 solid</source>
        <translation>%1 objets ou groupes qui se touchent par leurs bords ouverts forment 1 solide</translation>
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
        <source>%1 of %2 variants or searches are in no part</source>
        <translation>%1 variantes ou recherches sur %2 ne sont dans aucune partie</translation>
    </message>
    <message>
        <source>%1 of %2 variants, %3 feasible, %4 on the Pareto front.</source>
        <translation>%1 variantes sur %2, %3 réalisables, %4 sur le front de Pareto.</translation>
    </message>
    <message>
        <source>%1 of %2, %3</source>
        <translation>%1 sur %2, %3</translation>
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
        <source>%1 of the limit</source>
        <translation>%1 de la limite</translation>
    </message>
    <message>
        <source>%1 offsets</source>
        <translation>%1 décalages</translation>
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
        <source>%1 pairs overlap: %2. Move them apart, or exclude them if the overlaps are intended.</source>
        <translation>%1 paires se chevauchent : %2. Écartez-les, ou excluez-les si les chevauchements sont voulus.</translation>
    </message>
    <message>
        <source>%1 pairs touch at rest: %2. Exclude them from the check?</source>
        <translation>%1 paires se touchent au repos : %2. Les exclure de la vérification ?</translation>
    </message>
    <message>
        <source>%1 parameters are incomplete or of an unknown type; they are left out</source>
        <translation>%1 paramètres sont tronqués ou d'un type inconnu ; ils sont ignorés</translation>
    </message>
    <message>
        <source>%1 parts have no shape (the first is '%2'): a file that they refer to is missing, or they contain only lines</source>
        <translation>%1 pièces n'ont pas de forme (la première : '%2') : un fichier auquel elles renvoient manque, ou elles ne contiennent que des lignes</translation>
    </message>
    <message>
        <source>%1 peak</source>
        <translation>%1 crête</translation>
    </message>
    <message>
        <source>%1 placements</source>
        <translation>%1 placements</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 points</translation>
    </message>
    <message>
        <source>%1 points. To pass: %2 points and the whole path</source>
        <translation>%1 points. Pour réussir : %2 points et tout le chemin</translation>
    </message>
    <message>
        <source>%1 positions</source>
        <translation>%1 positions</translation>
    </message>
    <message>
        <source>%1 processes have a log there</source>
        <translation>%1 processus y ont déjà un journal</translation>
    </message>
    <message>
        <source>%1 reaches it and stays with it on %2 % of the way; sees %3 % of the part.</source>
        <translation>%1 l'atteint et l'accompagne sur %2 % du chemin ; voit %3 % de la pièce.</translation>
    </message>
    <message>
        <source>%1 responds at %2.</source>
        <translation>%1 répond à %2.</translation>
    </message>
    <message>
        <source>%1 robots</source>
        <translation>%1 robots</translation>
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
        <source>%1 s to %2 s</source>
        <translation>%1 s à %2 s</translation>
    </message>
    <message>
        <source>%1 s · %2 to the goal · nearest %3</source>
        <translation>%1 s · %2 jusqu’au but · plus proche %3</translation>
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
        <source>%1 should go to: %2. Press Start planner.</source>
        <translation>%1 doit aller à : %2. Appuyez sur Démarrer le planificateur.</translation>
    </message>
    <message>
        <source>%1 since %2</source>
        <translation>%1 depuis %2</translation>
    </message>
    <message>
        <source>%1 sits on %2</source>
        <translation>%1 s'assied sur %2</translation>
    </message>
    <message>
        <source>%1 solids have faces of several colours; each is shown in the colour with the largest area</source>
        <translation>%1 solides ont des faces de plusieurs couleurs ; ils sont affichés dans celle de la plus grande surface</translation>
    </message>
    <message>
        <source>%1 solids with only zero-area triangles were left out</source>
        <translation>%1 solides faits de triangles sans aire ont été ignorés</translation>
    </message>
    <message>
        <source>%1 stands on %2: these feet are not checked against it</source>
        <translation>%1 se tient sur %2 : ces pieds ne sont pas vérifiés par rapport à lui</translation>
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
        <source>%1 steps</source>
        <translation>%1 étapes</translation>
    </message>
    <message>
        <source>%1 surfaces that belong to no solid were put into one part</source>
        <translation>%1 surfaces qui n'appartiennent à aucun solide ont été réunies en une pièce</translation>
    </message>
    <message>
        <source>%1 targets</source>
        <translation>%1 cibles</translation>
    </message>
    <message>
        <source>%1 tessellated shapes (triangles as in AP242) are left out; exact shapes are read</source>
        <translation>%1 formes tessellées (triangles selon AP242) sont laissées de côté ; les formes exactes sont lues</translation>
    </message>
    <message>
        <source>%1 texts, which can include part names, have no stated encoding; %2 is assumed</source>
        <translation>%1 textes, dont peut-être des noms de pièces, sont écrits dans un codage non indiqué ; %2 est supposé</translation>
    </message>
    <message>
        <source>%1 things that vary</source>
        <translation>%1 choses qui varient</translation>
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
        <source>%1 to %2 %3, the range of %4</source>
        <translation>%1 à %2 %3, ce que %4 peut contenir</translation>
    </message>
    <message>
        <source>%1 to %2 (the expected value ± 40 %)</source>
        <translation>%1 à %2 (40 % autour de la valeur attendue)</translation>
    </message>
    <message>
        <source>%1 to %2 degrees</source>
        <translation>de %1 à %2 degrés</translation>
    </message>
    <message>
        <source>%1 to %2 kg at this stature</source>
        <translation>%1 à %2 kg pour cette stature</translation>
    </message>
    <message>
        <source>%1 to %2 m, the limits of the leg</source>
        <translation>%1 à %2 m, ses limites</translation>
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
        <source>%1 touches %2 at the goal, and is clear of it until %3 s</source>
        <translation>%1 touche %2 au but, et en est dégagé jusqu'à %3 s</translation>
    </message>
    <message>
        <source>%1 touches %2 at the start, and is clear of it from %3 s on</source>
        <translation>%1 touche %2 au départ, et en est dégagé à partir de %3 s</translation>
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
        <source>%1 trajectories</source>
        <translation>%1 trajectoires</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 triangles</translation>
    </message>
    <message>
        <source>%1 triangles with an invalid corner were removed</source>
        <translation>%1 triangles dont un sommet n'est pas un point ont été écartés</translation>
    </message>
    <message>
        <source>%1 triangles, at most %2 from the mesh</source>
        <translation>%1 triangles, à %2 au plus du maillage</translation>
    </message>
    <message>
        <source>%1 used as a function</source>
        <translation>%1 à la place d'une fonction</translation>
    </message>
    <message>
        <source>%1 values</source>
        <translation>%1 valeurs</translation>
    </message>
    <message>
        <source>%1 values for %2 names</source>
        <translation>%1 valeurs pour %2 noms</translation>
    </message>
    <message>
        <source>%1 vertices and %2 faces</source>
        <translation>%1 sommets et %2 faces</translation>
    </message>
    <message>
        <source>%1 vertices have an invalid colour (expected numbers, 0 or more); it was left out</source>
        <translation>%1 sommets ont une couleur dont les valeurs ne sont pas des nombres positifs ou nuls ; elle a été ignorée</translation>
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
        <source>%1 zero-area triangles were removed</source>
        <translation>%1 triangles sans aire ont été supprimés</translation>
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
        <source>%1() of %2</source>
        <translation>%1() appliqué à %2</translation>
    </message>
    <message>
        <source>%1() of a number outside its domain</source>
        <translation>%1() appliqué à un nombre pour lequel il n'est pas défini</translation>
    </message>
    <message>
        <source>%1() with &quot;%2&quot;</source>
        <translation>%1() avec &quot;%2&quot;</translation>
    </message>
    <message>
        <source>%1() with %2</source>
        <translation>%1() avec %2</translation>
    </message>
    <message>
        <source>%1() with %2 arguments</source>
        <translation>%1() avec %2 arguments</translation>
    </message>
    <message>
        <source>%1, &quot;%2&quot;</source>
        <translation>%1, &quot;%2&quot;</translation>
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
        <source>%1, %2: %3</source>
        <translation>%1, %2 : %3</translation>
    </message>
    <message>
        <source>%1, according to the file size</source>
        <translation>%1, ce qui correspond à la longueur du fichier</translation>
    </message>
    <message>
        <source>%1, and %2 more</source>
        <translation>%1, et %2 autres</translation>
    </message>
    <message>
        <source>%1, and no straight way of up to %2 leads out of there</source>
        <translation>%1, et aucun chemin droit de %2 au plus n'en sort</translation>
    </message>
    <message>
        <source>%1, and the controller did not confirm that it stopped</source>
        <translation>%1, et le contrôleur n'a pas confirmé son arrêt</translation>
    </message>
    <message>
        <source>%1, as in the header</source>
        <translation>%1, comme dans l'en-tête</translation>
    </message>
    <message>
        <source>%1, as the others</source>
        <translation>%1, comme les autres</translation>
    </message>
    <message>
        <source>%1, byte %2</source>
        <translation>%1, octet %2</translation>
    </message>
    <message>
        <source>%1, field '%2'</source>
        <translation>%1, champ '%2'</translation>
    </message>
    <message>
        <source>%1, frame %2</source>
        <translation>%1, repère %2</translation>
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
        <source>%1, joint %2</source>
        <translation>%1, articulation %2</translation>
    </message>
    <message>
        <source>%1, key '%2'</source>
        <translation>%1, clé '%2'</translation>
    </message>
    <message>
        <source>%1, left</source>
        <translation>%1, gauche</translation>
    </message>
    <message>
        <source>%1, like its file</source>
        <translation>%1, comme son fichier</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, ligne %2</translation>
    </message>
    <message>
        <source>%1, link '%2'</source>
        <translation>%1, segment '%2'</translation>
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
        <source>%1, number %2,</source>
        <translation>%1, nombre %2,</translation>
    </message>
    <message>
        <source>%1, object %2</source>
        <translation>%1, objet %2</translation>
    </message>
    <message>
        <source>%1, of %2</source>
        <translation>%1, de %2</translation>
    </message>
    <message>
        <source>%1, one for each joint that moves the tip, base first</source>
        <translation>%1, un pour chaque axe qui déplace l'extrémité, à partir de la base</translation>
    </message>
    <message>
        <source>%1, one per joint</source>
        <translation>%1, un par axe</translation>
    </message>
    <message>
        <source>%1, one per moving joint</source>
        <translation>%1, une par axe mobile</translation>
    </message>
    <message>
        <source>%1, part %2</source>
        <translation>%1, pièce %2</translation>
    </message>
    <message>
        <source>%1, part '%2'</source>
        <translation>%1, pièce '%2'</translation>
    </message>
    <message>
        <source>%1, pose %2</source>
        <translation>%1, pose %2</translation>
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
        <source>%1, row %2</source>
        <translation>%1, ligne %2</translation>
    </message>
    <message>
        <source>%1, target missed</source>
        <translation>%1, cible manquée</translation>
    </message>
    <message>
        <source>%1, those of the external axes first, or %2 of its own</source>
        <translation>%1, d'abord celles des axes externes, ou %2 pour le robot seul</translation>
    </message>
    <message>
        <source>%1, tool %2</source>
        <translation>%1, outil %2</translation>
    </message>
    <message>
        <source>%1, undone</source>
        <translation>%1, annulé</translation>
    </message>
    <message>
        <source>%1, with an inner radius below the outer one</source>
        <translation>%1, le rayon intérieur plus petit que le rayon extérieur</translation>
    </message>
    <message>
        <source>%1, µ %2</source>
        <translation>%1, µ %2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1.dat is missing in the same folder.</source>
        <translation>Il n'y a pas de %1.dat à côté.</translation>
    </message>
    <message>
        <source>%1.dat, in which KRL stores the points, is missing in the same folder.</source>
        <translation>Placez à côté le fichier %1.dat, où KRL garde ses points.</translation>
    </message>
    <message>
        <source>%1.src in the same folder</source>
        <translation>%1.src dans le même dossier</translation>
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
        <source>%1: %2 (link '%3')</source>
        <translation>%1 : %2 (segment '%3')</translation>
    </message>
    <message>
        <source>%1: %2 is a gearbox; it is left out</source>
        <translation>%1 : %2 est un réducteur (gearbox) ; il est omis</translation>
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
        <source>%1: %2 messages of other joints are left out</source>
        <translation>%1 : %2 messages d’autres axes sont ignorés</translation>
    </message>
    <message>
        <source>%1: %2 messages whose time does not rise are left out</source>
        <translation>%1 : %2 messages dont le temps n’augmente pas sont ignorés</translation>
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
        <source>%1: %2.</source>
        <translation>%1 : %2.</translation>
    </message>
    <message>
        <source>%1: %2; sees %3 % of the part.</source>
        <translation>%1 : %2 ; voit %3 % de la pièce.</translation>
    </message>
    <message>
        <source>%1: %2; the shape is left out</source>
        <translation>%1 : %2 ; la forme est omise</translation>
    </message>
    <message>
        <source>%1: %2° to %3°, comfortable %4° to %5°</source>
        <translation>%1 : %2° à %3°, confortable %4° à %5°</translation>
    </message>
    <message>
        <source>%1: &lt;%2&gt; is left out (%3 times), because its macro is not in the file</source>
        <translation>%1 : &lt;%2&gt; est omis (%3 fois), car sa macro n'est pas dans le fichier</translation>
    </message>
    <message>
        <source>%1: &lt;%2&gt; is left out (1 time), because its macro is not in the file</source>
        <translation>%1 : &lt;%2&gt; est omis (1 fois), car sa macro n'est pas dans le fichier</translation>
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
        <source>%1: joint '%2' has its lower limit %3 above its upper limit %4; no limits are assumed, as in PyBullet</source>
        <translation>%1 : la butée inférieure %3 de l'axe '%2' dépasse la butée supérieure %4 ; l'axe est lu sans butées, comme le fait PyBullet</translation>
    </message>
    <message>
        <source>%1: joint '%2' is %3 without &lt;limit&gt;; no limits are assumed</source>
        <translation>%1 : l'axe '%2' est de type %3 sans &lt;limit&gt; ; il est lu sans butées</translation>
    </message>
    <message>
        <source>%1: joint '%2' is %3; it is read as fixed</source>
        <translation>%1 : l'axe '%2' est de type %3 ; il est lu comme fixe</translation>
    </message>
    <message>
        <source>%1: joint '%2' is attached to 'world', which is not a link of the file; 'world' is used as the root</source>
        <translation>%1 : l'axe '%2' est rattaché à 'world', qui n'est pas un segment du fichier ; ce dernier est pris comme racine</translation>
    </message>
    <message>
        <source>%1: joint '%2' is read as an independent joint, because it follows '%3', which does not exist</source>
        <translation>%1 : l'axe '%2' est lu comme indépendant : il suit '%3', qui n'existe pas</translation>
    </message>
    <message>
        <source>%1: joint '%2' is read as an independent joint, because it follows '%3', which follows another joint</source>
        <translation>%1 : l'axe '%2' est lu comme indépendant : il suit '%3', qui suit lui-même un autre axe</translation>
    </message>
    <message>
        <source>%1: link '%2': a shape is left out, because its placement is unknown: %3</source>
        <translation>%1 : segment '%2' : une forme est omise, car sa pose ne peut pas être déterminée : %3</translation>
    </message>
    <message>
        <source>%1: no finite velocity is stated for %2; if a velocity is needed, 180 deg/s or 1 m/s is assumed</source>
        <translation>%1 : aucune vitesse finie n'est indiquée pour %2 ; 180 deg/s ou 1 m/s est supposé là où il en faut une</translation>
    </message>
    <message>
        <source>%1: no joint connects the link '%2' to the root; it is fixed at its position</source>
        <translation>%1 : aucun axe ne relie le segment '%2' à la racine ; il est fixé là où il se trouve</translation>
    </message>
    <message>
        <source>%1: no joint names the link '%2' and it has no shape; it is left out</source>
        <translation>%1 : aucun axe ne cite le segment '%2', et il n'a pas de forme ; il est omis</translation>
    </message>
    <message>
        <source>%1: not shown and not checked: %2</source>
        <translation>%1 : ni affichés ni vérifiés : %2</translation>
    </message>
    <message>
        <source>%1: of %2 models, only '%3' is read, because it has moving joints</source>
        <translation>%1 : sur %2 modèles, seul '%3' est lu, car il a des axes mobiles</translation>
    </message>
    <message>
        <source>%1: one a variable of '%2'</source>
        <translation>%1 : une par variable de « %2 »</translation>
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
        <source>%1: only partly shown and checked: %2</source>
        <translation>%1 : affichés et vérifiés en partie seulement : %2</translation>
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
        <source>%1: the collision shape is shown for %2</source>
        <translation>%1 : la forme de collision est affichée à la place pour %2</translation>
    </message>
    <message>
        <source>%1: the color rgba=&quot;%2&quot; is not four numbers; the shapes are shown grey</source>
        <translation>%1 : la couleur rgba=&quot;%2&quot; ne se compose pas de quatre nombres ; ses formes sont grises</translation>
    </message>
    <message>
        <source>%1: the key &quot;%2&quot; is unknown and was left out</source>
        <translation>%1 : la clé &quot;%2&quot; est inconnue et a été ignorée</translation>
    </message>
    <message>
        <source>%1: the material '%2' has a texture and no color; textures are not shown, so its links are grey</source>
        <translation>%1 : le matériau '%2' a une image et pas de couleur ; les images ne sont pas affichées, ses segments sont gris</translation>
    </message>
    <message>
        <source>%1: the material '%2' is defined twice with different colors; the first one, on %3, is used</source>
        <translation>%1 : le matériau '%2' est défini une seconde fois avec une autre couleur ; la première définition (%3) est retenue</translation>
    </message>
    <message>
        <source>%1: the material '%2' is not defined; its links are shown grey</source>
        <translation>%1 : le matériau '%2' n'est défini nulle part ; ses segments sont affichés en gris</translation>
    </message>
    <message>
        <source>%1: the path leaves the workspace of the %2 by %3 mm; the stylus stops at its mechanical limits.</source>
        <translation>%1 : la trajectoire sort de l'espace de travail du périphérique %2 de %3 mm ; ses butées retiennent le stylet.</translation>
    </message>
    <message>
        <source>%1: the robot does not have these links or joints: %2</source>
        <translation>%1 : des segments ou axes cités n'existent pas dans le robot : %2</translation>
    </message>
    <message>
        <source>%1: the visual shape is used for collision checks of %2</source>
        <translation>%1 : la forme visuelle sert au contrôle de collision de %2</translation>
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
        <source>%1:%2</source>
        <translation>%1:%2</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1 ; %2</translation>
    </message>
    <message>
        <source>%1; 0 is assumed</source>
        <translation>%1 ; 0 est supposé</translation>
    </message>
    <message>
        <source>%1; 1 is assumed</source>
        <translation>%1 ; 1 est supposé</translation>
    </message>
    <message>
        <source>%1; expected %2</source>
        <translation>%1 ; attendu : %2</translation>
    </message>
    <message>
        <source>%1; most often %2 was in the way</source>
        <translation>%1 ; le plus souvent, %2 faisait obstacle</translation>
    </message>
    <message>
        <source>%1; no limit is assumed</source>
        <translation>%1 ; l'absence de butée est supposée</translation>
    </message>
    <message>
        <source>%1; the moves in it are read once.</source>
        <translation>%1 ; ses mouvements sont lus une fois.</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1° · %2</source>
        <translation>%1° · %2</translation>
    </message>
    <message>
        <source>%2 carries %1, which the other stylus holds: release it there first</source>
        <translation>%2 porte %1, que tient l'autre stylet : relâchez d'abord l'entité avec ce stylet</translation>
    </message>
    <message numerus="yes">
        <source>%n action(s) written as a script: %1</source>
        <translation><numerusform>%n action écrite dans un script : %1</numerusform><numerusform>%n actions écrites dans un script : %1</numerusform></translation>
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
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation><numerusform>%n valeur</numerusform><numerusform>%n valeurs</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n variant(s)</source>
        <translation><numerusform>%n variante</numerusform><numerusform>%n variantes</numerusform></translation>
    </message>
    <message>
        <source>%p %</source>
        <translation>%p %</translation>
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
        <source>'%1' after a file that is not xacro</source>
        <translation>'%1' après un fichier qui n'est pas xacro</translation>
    </message>
    <message>
        <source>'%1' after frame:</source>
        <translation>'%1' après frame:</translation>
    </message>
    <message>
        <source>'%1' after saving</source>
        <translation>'%1' après l'enregistrement</translation>
    </message>
    <message>
        <source>'%1' comes before its parent</source>
        <translation>'%1' avant son parent</translation>
    </message>
    <message>
        <source>'%1' depends on values that the file does not define; the condition is read as false.</source>
        <translation>'%1' dépend de ce que le fichier ne donne pas ; la condition est lue comme fausse.</translation>
    </message>
    <message>
        <source>'%1' does not exist</source>
        <translation>aucune ne s'appelle '%1'</translation>
    </message>
    <message>
        <source>'%1' has an invalid placement; it is placed at its parent</source>
        <translation>'%1' a un placement non valide ; il est mis au placement de son parent</translation>
    </message>
    <message>
        <source>'%1' has closed loops, which URDF cannot describe: only its tree was written</source>
        <translation>'%1' a des boucles fermées, que l'URDF ne peut pas décrire : seul son arbre a été écrit</translation>
    </message>
    <message>
        <source>'%1' has faces of several colours; it is shown in the colour with the largest area</source>
        <translation>'%1' a des faces de plusieurs couleurs ; il est affiché dans celle de sa plus grande surface</translation>
    </message>
    <message>
        <source>'%1' has moving joints; it is read as a rigid body</source>
        <translation>'%1' a des axes mobiles ; il est lu comme un corps rigide</translation>
    </message>
    <message>
        <source>'%1' has moving joints; it is read as a rigid body: %2</source>
        <translation>'%1' a des axes mobiles ; il est lu comme un corps rigide : %2</translation>
    </message>
    <message>
        <source>'%1' has no shape of its own that can be taken out</source>
        <translation>« %1 » n'a pas de forme propre qui puisse être retirée</translation>
    </message>
    <message>
        <source>'%1' has no such joint</source>
        <translation>'%1' n'a pas cet axe</translation>
    </message>
    <message>
        <source>'%1' in a format text</source>
        <translation>'%1' dans un texte de format</translation>
    </message>
    <message>
        <source>'%1' in a time</source>
        <translation>'%1' dans un temps</translation>
    </message>
    <message>
        <source>'%1' in pulses, which only the controller can convert</source>
        <translation>'%1' en impulsions, que seul le contrôleur peut lire</translation>
    </message>
    <message>
        <source>'%1' in the archive</source>
        <translation>'%1' dans l'archive</translation>
    </message>
    <message>
        <source>'%1' in the expression</source>
        <translation>'%1' dans l'expression</translation>
    </message>
    <message>
        <source>'%1' instead of a frame number</source>
        <translation>'%1' au lieu d'un numéro d'image</translation>
    </message>
    <message>
        <source>'%1' instead of a number in OFFSET</source>
        <translation>'%1' au lieu d'un nombre dans OFFSET</translation>
    </message>
    <message>
        <source>'%1' is left out.</source>
        <translation>'%1' est omis.</translation>
    </message>
    <message>
        <source>'%1' is left out: %2</source>
        <translation>'%1' est laissé de côté : %2</translation>
    </message>
    <message>
        <source>'%1' is left out: threads are not read.</source>
        <translation>'%1' est omis : les tâches parallèles ne sont pas lues.</translation>
    </message>
    <message>
        <source>'%1' is locked</source>
        <translation>« %1 » est verrouillé</translation>
    </message>
    <message>
        <source>'%1' is locked in place</source>
        <translation>'%1' est verrouillé en place</translation>
    </message>
    <message>
        <source>'%1' is not a built-in part</source>
        <translation>« %1 » n'est pas une pièce intégrée</translation>
    </message>
    <message>
        <source>'%1' is not a solid of the cell</source>
        <translation>'%1' n'est pas un solide de la cellule</translation>
    </message>
    <message>
        <source>'%1' is not below '%2'</source>
        <translation>« %1 » n'est pas sous « %2 »</translation>
    </message>
    <message>
        <source>'%1' is not in the file or not supported; if it moves the robot, these moves are missing.</source>
        <translation>'%1' n'est pas dans le fichier ou n'est pas compris ; si cela déplace le robot, ce mouvement manque.</translation>
    </message>
    <message>
        <source>'%1' is not in the file; if it moves the robot, these moves are missing.</source>
        <translation>'%1' n'est pas dans le fichier ; si cela déplace le robot, ce mouvement manque.</translation>
    </message>
    <message>
        <source>'%1' is not supported and is left out.</source>
        <translation>'%1' n'est pas compris et est omis.</translation>
    </message>
    <message>
        <source>'%1' is real hardware</source>
        <translation>'%1' est un vrai matériel</translation>
    </message>
    <message>
        <source>'%1' is this entity or is attached to it</source>
        <translation>'%1' est cette entité ou y est attaché</translation>
    </message>
    <message>
        <source>'%1' meets '%2' %3 ms after the start</source>
        <translation>'%1' rencontre '%2' %3 ms après le début</translation>
    </message>
    <message>
        <source>'%1' twice</source>
        <translation>'%1' deux fois</translation>
    </message>
    <message>
        <source>'%1' without its end</source>
        <translation>'%1', qui n'est pas fermé</translation>
    </message>
    <message>
        <source>'%1', a jump out of the job</source>
        <translation>'%1', un saut hors du programme</translation>
    </message>
    <message>
        <source>'%1', attached</source>
        <translation>'%1', attache</translation>
    </message>
    <message>
        <source>'%1', frame '%2'</source>
        <translation>'%1', repère '%2'</translation>
    </message>
    <message>
        <source>'%1', tool '%2'</source>
        <translation>'%1', outil '%2'</translation>
    </message>
    <message>
        <source>'%1', which has no value</source>
        <translation>'%1', qui n'a pas de valeur</translation>
    </message>
    <message>
        <source>'%1', which is no robot</source>
        <translation>« %1 », qui n'est pas un robot</translation>
    </message>
    <message>
        <source>'%1', which is not a robot</source>
        <translation>'%1', qui n'est pas un robot</translation>
    </message>
    <message>
        <source>'%1', which is not supported</source>
        <translation>'%1', qui n'est pas compris</translation>
    </message>
    <message>
        <source>'%1', which moves by a variable on the controller</source>
        <translation>'%1', qui se déplace selon une variable du contrôleur</translation>
    </message>
    <message>
        <source>'%1', which shifts all targets that follow</source>
        <translation>'%1', qui déplace toutes les cibles suivantes</translation>
    </message>
    <message>
        <source>'%1', which shifts the targets that follow</source>
        <translation>'%1', qui déplace les cibles suivantes</translation>
    </message>
    <message>
        <source>'%1', which the file does not define</source>
        <translation>'%1', que le fichier ne donne pas</translation>
    </message>
    <message>
        <source>'%1', whose motion depends on the controller's clock</source>
        <translation>'%1', dont le mouvement dépend de l'horloge du contrôleur</translation>
    </message>
    <message>
        <source>'%1': %2 of %3 faces could not be cut into triangles and are missing</source>
        <translation>'%1' : %2 des %3 faces n'ont pas pu être découpées en triangles et manquent</translation>
    </message>
    <message>
        <source>'%1': %2 polygons with holes could not be cut into triangles and are missing</source>
        <translation>'%1' : %2 polygones à trous n'ont pas pu être découpés en triangles et manquent</translation>
    </message>
    <message>
        <source>'%1': invalid pose; it is placed at its parent</source>
        <translation>'%1' : sa pose n'est pas valable ; il est placé sur le corps parent</translation>
    </message>
    <message>
        <source>'%1': its mesh %2 is left out: %3</source>
        <translation>'%1' : son maillage %2 est omis : %3</translation>
    </message>
    <message>
        <source>'%1': the frame of its pose does not exist; the pose is read in the frame of its parent</source>
        <translation>'%1' : le repère de sa pose n'existe pas ; elle est prise dans le corps parent</translation>
    </message>
    <message>
        <source>'%1.%2'</source>
        <translation>'%1.%2'</translation>
    </message>
    <message>
        <source>'%2' instead of a number in frame %1</source>
        <translation>'%2' au lieu d'un nombre dans l'image %1</translation>
    </message>
    <message>
        <source>'OFF'</source>
        <translation>'OFF'</translation>
    </message>
    <message>
        <source>'OFF', 'COFF' or 'NOFF' in three dimensions</source>
        <translation>'OFF', 'COFF' ou 'NOFF' en trois dimensions</translation>
    </message>
    <message>
        <source>'begin' is missing</source>
        <translation>pas de begin</translation>
    </message>
    <message>
        <source>'element', 'property', 'comment' or 'end_header'</source>
        <translation>'element', 'property', 'comment' ou 'end_header'</translation>
    </message>
    <message>
        <source>'end_header'</source>
        <translation>'end_header'</translation>
    </message>
    <message>
        <source>'facet' or 'endsolid'</source>
        <translation>'facet' ou 'endsolid'</translation>
    </message>
    <message>
        <source>'format' ascii, binary_little_endian or binary_big_endian</source>
        <translation>'format' ascii, binary_little_endian ou binary_big_endian</translation>
    </message>
    <message>
        <source>'not' of a value that is not true or false</source>
        <translation>'not' de ce qui n'est pas une valeur logique</translation>
    </message>
    <message>
        <source>'ply'</source>
        <translation>'ply'</translation>
    </message>
    <message>
        <source>'ply' is missing</source>
        <translation>pas de 'ply'</translation>
    </message>
    <message>
        <source>'solid'</source>
        <translation>'solid'</translation>
    </message>
    <message>
        <source>'vertex' (three per facet)</source>
        <translation>'vertex' (trois par facette)</translation>
    </message>
    <message>
        <source>'{' is missing after '%1'</source>
        <translation>pas de { après '%1'</translation>
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
        <source>--add %1</source>
        <translation>--add %1</translation>
    </message>
    <message>
        <source>--cell, or one of --percentile and --stature</source>
        <translation>--cell, ou l'une des options --percentile et --stature</translation>
    </message>
    <message>
        <source>--check %1</source>
        <translation>--check %1</translation>
    </message>
    <message>
        <source>--chunk</source>
        <translation>--chunk</translation>
    </message>
    <message>
        <source>--contacts</source>
        <translation>--contacts</translation>
    </message>
    <message>
        <source>--device</source>
        <translation>--device</translation>
    </message>
    <message>
        <source>--direction</source>
        <translation>--direction</translation>
    </message>
    <message>
        <source>--entity</source>
        <translation>--entity</translation>
    </message>
    <message>
        <source>--hands</source>
        <translation>--hands</translation>
    </message>
    <message>
        <source>--input, --motion</source>
        <translation>--input, --motion</translation>
    </message>
    <message>
        <source>--kind</source>
        <translation>--kind</translation>
    </message>
    <message>
        <source>--lock</source>
        <translation>--lock</translation>
    </message>
    <message>
        <source>--mannequin</source>
        <translation>--mannequin</translation>
    </message>
    <message>
        <source>--mode</source>
        <translation>--mode</translation>
    </message>
    <message>
        <source>--motion is missing</source>
        <translation>--motion manque</translation>
    </message>
    <message>
        <source>--motion with a recorded motion</source>
        <translation>un mouvement enregistré à lire avec ces options</translation>
    </message>
    <message>
        <source>--only</source>
        <translation>--only</translation>
    </message>
    <message>
        <source>--output</source>
        <translation>--output</translation>
    </message>
    <message>
        <source>--output, --trajectory, --description, --entity or --objects</source>
        <translation>--output, --trajectory, --description, --entity ou --objects</translation>
    </message>
    <message>
        <source>--part</source>
        <translation>--part</translation>
    </message>
    <message>
        <source>--plane</source>
        <translation>--plane</translation>
    </message>
    <message>
        <source>--pose</source>
        <translation>--pose</translation>
    </message>
    <message>
        <source>--record is missing</source>
        <translation>--record manque</translation>
    </message>
    <message>
        <source>--record or --mcap together with this option</source>
        <translation>--record ou --mcap avec cette option</translation>
    </message>
    <message>
        <source>--record-interval, --record-distance</source>
        <translation>--record-interval, --record-distance</translation>
    </message>
    <message>
        <source>--robot</source>
        <translation>--robot</translation>
    </message>
    <message>
        <source>--robot or --velocity</source>
        <translation>--robot ou --velocity</translation>
    </message>
    <message>
        <source>--safety-zone</source>
        <translation>--safety-zone</translation>
    </message>
    <message>
        <source>--sample</source>
        <translation>--sample</translation>
    </message>
    <message>
        <source>--set</source>
        <translation>--set</translation>
    </message>
    <message>
        <source>--set forces</source>
        <translation>--set forces</translation>
    </message>
    <message>
        <source>--set plan_goal</source>
        <translation>--set plan_goal</translation>
    </message>
    <message>
        <source>--set plan_goal=... with it</source>
        <translation>--set plan_goal=... avec elle</translation>
    </message>
    <message>
        <source>--set plan_hints</source>
        <translation>--set plan_hints</translation>
    </message>
    <message>
        <source>--set safety_distance</source>
        <translation>--set safety_distance</translation>
    </message>
    <message>
        <source>--sex</source>
        <translation>--sex</translation>
    </message>
    <message>
        <source>--slurm</source>
        <translation>--slurm</translation>
    </message>
    <message>
        <source>--start</source>
        <translation>--start</translation>
    </message>
    <message>
        <source>--start: joint '%1' at %2 is beyond its limits of %3 to %4</source>
        <translation>--start : l'axe '%1' à %2 est au-delà de ses butées, de %3 à %4</translation>
    </message>
    <message>
        <source>--station</source>
        <translation>--station</translation>
    </message>
    <message>
        <source>--tip</source>
        <translation>--tip</translation>
    </message>
    <message>
        <source>--to</source>
        <translation>--to</translation>
    </message>
    <message>
        <source>--to, --to-frame, --to-joints, --out</source>
        <translation>--to, --to-frame, --to-joints, --out</translation>
    </message>
    <message>
        <source>--together</source>
        <translation>--together</translation>
    </message>
    <message>
        <source>--tolerance, --angle-tolerance</source>
        <translation>--tolerance, --angle-tolerance</translation>
    </message>
    <message>
        <source>--trajectory</source>
        <translation>--trajectory</translation>
    </message>
    <message>
        <source>--unit</source>
        <translation>--unit</translation>
    </message>
    <message>
        <source>--up, --markers</source>
        <translation>--up, --markers</translation>
    </message>
    <message>
        <source>--variant</source>
        <translation>--variant</translation>
    </message>
    <message>
        <source>--velocity</source>
        <translation>--velocity</translation>
    </message>
    <message>
        <source>--view</source>
        <translation>--view</translation>
    </message>
    <message>
        <source>--within</source>
        <translation>--within</translation>
    </message>
    <message>
        <source>--workcell</source>
        <translation>--workcell</translation>
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
        <source>.bvh, .c3d, or .amc with its .asf in the same folder</source>
        <translation>.bvh, .amc à côté de son .asf, ou .c3d</translation>
    </message>
    <message>
        <source>.htraj or .csv</source>
        <translation>.htraj ou .csv</translation>
    </message>
    <message>
        <source>.htraj, .csv or .mcap for a motion</source>
        <translation>.htraj, .csv ou .mcap pour un mouvement</translation>
    </message>
    <message>
        <source>.htraj, .csv, .json, .yaml, or a robot's program: .src, .mod, .ls, .script, .jbi</source>
        <translation>.htraj, .csv, .json, .yaml, ou un programme de robot : .src, .mod, .ls, .script, .jbi</translation>
    </message>
    <message>
        <source>.htraj, .json or .csv</source>
        <translation>.htraj, .json ou .csv</translation>
    </message>
    <message>
        <source>.json (the posture), .obj (the body), .x3d (H-Anim) or .bvh (the motion)</source>
        <translation>.json (la posture), .obj (le corps), .x3d (H-Anim) ou .bvh (le mouvement)</translation>
    </message>
    <message>
        <source>.src, .mod, .ls or .script</source>
        <translation>.src, .mod, .ls ou .script</translation>
    </message>
    <message>
        <source>/dev/</source>
        <translation>/dev/</translation>
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
        <source>0 (not pressed), 1 (first button), 2 (second button) or 3 (both)</source>
        <translation>0 (relâché), 1 (premier bouton), 2 (second bouton) ou 3 (les deux)</translation>
    </message>
    <message>
        <source>0 N</source>
        <translation>0 N</translation>
    </message>
    <message>
        <source>0 or 1</source>
        <translation>0 ou 1</translation>
    </message>
    <message>
        <source>0 or more</source>
        <translation>0 ou plus</translation>
    </message>
    <message>
        <source>0 or more metres</source>
        <translation>0 mètre ou plus</translation>
    </message>
    <message>
        <source>0 or more, within the bounds of docs/library/protocol.md</source>
        <translation>0 ou plus, dans les limites de docs/library/protocol.md</translation>
    </message>
    <message>
        <source>0 to 1</source>
        <translation>de 0 à 1</translation>
    </message>
    <message>
        <source>0 to 1 m</source>
        <translation>de 0 à 1 m</translation>
    </message>
    <message>
        <source>0 to 10 metres</source>
        <translation>de 0 à 10 mètres</translation>
    </message>
    <message>
        <source>0 to 232</source>
        <translation>0 à 232</translation>
    </message>
    <message>
        <source>0 to 6</source>
        <translation>0 à 6</translation>
    </message>
    <message>
        <source>0 to 62</source>
        <translation>de 0 à 62</translation>
    </message>
    <message>
        <source>0.001 to 3.2 rad</source>
        <translation>de 0,001 à 3,2 rad</translation>
    </message>
    <message>
        <source>0.1 to 99.9</source>
        <translation>0.1 à 99.9</translation>
    </message>
    <message>
        <source>0.1, 0.2, … in metres</source>
        <translation>0.1, 0.2, … en mètres</translation>
    </message>
    <message>
        <source>0: the hand takes the part itself</source>
        <translation>0 : la main prend la pièce elle-même</translation>
    </message>
    <message>
        <source>0; -90; 90; 0; 0; 0 (degrees, mm)</source>
        <translation>0; -90; 90; 0; 0; 0 (degrés, mm)</translation>
    </message>
    <message>
        <source>1 damaged entry (%1)</source>
        <translation>1 entrée endommagée (%1)</translation>
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
        <source>1 or 2</source>
        <translation>1 ou 2</translation>
    </message>
    <message>
        <source>1 pair touches at rest: %1. Exclude it from the check?</source>
        <translation>1 paire se touche au repos : %1. L'exclure de la vérification ?</translation>
    </message>
    <message>
        <source>1 solid has faces of several colours; it is shown in the colour with the largest area</source>
        <translation>1 solide a des faces de plusieurs couleurs ; il est affiché dans celle de la plus grande surface</translation>
    </message>
    <message>
        <source>1 to %1</source>
        <translation>1 à %1</translation>
    </message>
    <message>
        <source>1 to 1000 Hz</source>
        <translation>1 à 1000 Hz</translation>
    </message>
    <message>
        <source>1 to 1000 motions with frames</source>
        <translation>1 à 1000 mouvements avec des points</translation>
    </message>
    <message>
        <source>1 to 10000 per second</source>
        <translation>1 à 10000 par seconde</translation>
    </message>
    <message>
        <source>1 to 10000 placements</source>
        <translation>1 à 10000 placements</translation>
    </message>
    <message>
        <source>1 to 60 letters, digits, '_' and '-'</source>
        <translation>1 à 60 lettres, chiffres, « _ » et « - »</translation>
    </message>
    <message>
        <source>1, 2, …</source>
        <translation>1, 2, …</translation>
    </message>
    <message>
        <source>1, the newest version that this program can read</source>
        <translation>1, la plus récente que ce programme connaît</translation>
    </message>
    <message>
        <source>1.2 to 2.3 m</source>
        <translation>1.2 à 2.3 m</translation>
    </message>
    <message>
        <source>12 numbers</source>
        <translation>12 nombres</translation>
    </message>
    <message>
        <source>127.0.0.1, 0.0.0.0 or an address of this machine</source>
        <translation>127.0.0.1, 0.0.0.0 ou une adresse de cette machine</translation>
    </message>
    <message>
        <source>1e-9 to 1000 m</source>
        <translation>de 1e-9 à 1000 m</translation>
    </message>
    <message>
        <source>28 letters and digits in groups of four, as hapticell-haptic-server --pair shows them</source>
        <translation>28 lettres et chiffres par groupes de quatre, comme hapticell-haptic-server --pair les affiche</translation>
    </message>
    <message>
        <source>3 (force) or 6 (force and torque)</source>
        <translation>3 (force) ou 6 (force et couple)</translation>
    </message>
    <message>
        <source>3 joints, or 4 if the tool turns</source>
        <translation>3, ou 4 avec la rotation de l'outil</translation>
    </message>
    <message>
        <source>3, 5, ... points for arcs</source>
        <translation>trois, cinq, ... points d'arcs</translation>
    </message>
    <message>
        <source>3D mouse</source>
        <translation>Souris 3D</translation>
    </message>
    <message>
        <source>6 legs</source>
        <translation>6 jambes</translation>
    </message>
    <message>
        <source>6 on the base and 6 on the platform</source>
        <translation>6 sur la base et 6 sur la plateforme</translation>
    </message>
    <message>
        <source>6, in degrees</source>
        <translation>6, en degrés</translation>
    </message>
    <message>
        <source>70-hapticell.rules is installed</source>
        <translation>70-hapticell.rules est installé</translation>
    </message>
    <message>
        <source>70-hapticell.rules is not installed</source>
        <translation>70-hapticell.rules n'est pas installé</translation>
    </message>
    <message>
        <source>84 (Intel), 85 (DEC) or 86 (MIPS)</source>
        <translation>84 (Intel), 85 (DEC) ou 86 (MIPS)</translation>
    </message>
    <message>
        <source>: </source>
        <translation> : </translation>
    </message>
    <message>
        <source>:RADIANS and :DEGREES</source>
        <translation>:RADIANS et :DEGREES</translation>
    </message>
    <message>
        <source>:hierarchy is missing</source>
        <translation>pas de :hierarchy</translation>
    </message>
    <message>
        <source>:root is missing</source>
        <translation>pas de :root</translation>
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
        <source>&lt;%1&gt; has %2=&quot;%3&quot;</source>
        <translation>&lt;%1&gt; a %2=&quot;%3&quot;</translation>
    </message>
    <message>
        <source>&lt;%1&gt; has the unknown attribute '%2'</source>
        <translation>&lt;%1&gt; a '%2', que xacro ne connaît pas</translation>
    </message>
    <message>
        <source>&lt;%1&gt; inside the call of macro '%2'</source>
        <translation>&lt;%1&gt; dans l'appel de la macro '%2'</translation>
    </message>
    <message>
        <source>&lt;%1&gt; is '%2' instead of %3 numbers</source>
        <translation>&lt;%1&gt; vaut '%2' au lieu de %3 nombres</translation>
    </message>
    <message>
        <source>&lt;%1&gt; is '%2' instead of 1 number</source>
        <translation>&lt;%1&gt; vaut '%2' au lieu d'un nombre</translation>
    </message>
    <message>
        <source>&lt;%1&gt; is left out, because it does not affect motion: %2</source>
        <translation>&lt;%1&gt; est laissé de côté, il ne déplace rien : %2</translation>
    </message>
    <message>
        <source>&lt;%1&gt; without %2</source>
        <translation>&lt;%1&gt; sans %2</translation>
    </message>
    <message>
        <source>&lt;%1&gt;, which is not supported</source>
        <translation>&lt;%1&gt;, qui est inconnu</translation>
    </message>
    <message>
        <source>&lt;&lt; with %1</source>
        <translation>&lt;&lt; avec %1</translation>
    </message>
    <message>
        <source>&lt;axis&gt; with &lt;xyz&gt;</source>
        <translation>&lt;axis&gt; avec &lt;xyz&gt;</translation>
    </message>
    <message>
        <source>&lt;build&gt; has no &lt;item&gt;</source>
        <translation>pas de &lt;item&gt; dans son &lt;build&gt;</translation>
    </message>
    <message>
        <source>&lt;mimic&gt; without joint</source>
        <translation>&lt;mimic&gt; sans axe</translation>
    </message>
    <message>
        <source>&lt;model name=&quot;…&quot;&gt;</source>
        <translation>&lt;model name=&quot;…&quot;&gt;</translation>
    </message>
    <message>
        <source>&lt;parent link=&quot;…&quot;/&gt; and &lt;child link=&quot;…&quot;/&gt;</source>
        <translation>&lt;parent link=&quot;…&quot;/&gt; et &lt;child link=&quot;…&quot;/&gt;</translation>
    </message>
    <message>
        <source>&lt;robot name=&quot;…&quot;&gt; (URDF)</source>
        <translation>&lt;robot name=&quot;…&quot;&gt; (URDF)</translation>
    </message>
    <message>
        <source>&lt;robot&gt;</source>
        <translation>&lt;robot&gt;</translation>
    </message>
    <message>
        <source>&lt;robot&gt; has no links</source>
        <translation>&lt;robot&gt; n'a pas de segments</translation>
    </message>
    <message>
        <source>&lt;robot&gt; is missing</source>
        <translation>&lt;robot&gt; manque</translation>
    </message>
    <message>
        <source>&lt;sdf&gt; is missing</source>
        <translation>&lt;sdf&gt; manque</translation>
    </message>
    <message>
        <source>&lt;xacro:%1&gt;: there is no macro of this name</source>
        <translation>&lt;xacro:%1&gt; : il n'y a pas de macro de ce nom</translation>
    </message>
    <message>
        <source>&lt;xacro:attribute&gt; with an empty name</source>
        <translation>&lt;xacro:attribute&gt; avec un nom vide</translation>
    </message>
    <message>
        <source>&lt;xacro:element&gt; with an empty name</source>
        <translation>&lt;xacro:element&gt; avec un nom vide</translation>
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
        <source>A file may have been changed since the workcell was opened: save the workcell, open it again and pack it.</source>
        <translation>Un fichier a peut-être été modifié depuis l'ouverture de la cellule : enregistrez la cellule, rouvrez-la et archivez-la.</translation>
    </message>
    <message>
        <source>A file of this cell is missing</source>
        <translation>Un fichier de cette cellule manque</translation>
    </message>
    <message>
        <source>A frame has no dimensions. Set its name and pose (name=N, pose=x,y,z,qw,qx,qy,qz).</source>
        <translation>Donnez au repère, qui n'a pas de dimensions, un nom et une pose (name=N, pose=x,y,z,qw,qx,qy,qz).</translation>
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
        <source>A new evaluation differs from the results file. Undo, and run the study again: the row was changed, or made by another kind of processor.</source>
        <translation>Une nouvelle évaluation diffère du fichier de résultats. Annulez et relancez l'étude : la ligne a été modifiée, ou faite par un autre type de processeur.</translation>
    </message>
    <message>
        <source>A new workcell</source>
        <translation>Une nouvelle cellule</translation>
    </message>
    <message>
        <source>A pair overlaps: %1. Move it apart, or exclude it if the overlap is intended.</source>
        <translation>Une paire se chevauche : %1. Écartez-la, ou excluez-la si le chevauchement est voulu.</translation>
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
        <source>A posture is that of a mannequin. Select one, or add one first.</source>
        <translation>Une posture est celle d'un mannequin. Sélectionnez-en un, ou ajoutez-en un d'abord.</translation>
    </message>
    <message>
        <source>A program has no times. Linear moves use their programmed speed; joint moves use their share of 1 m/s and 180 deg/s.</source>
        <translation>Un programme n'a pas de temps : la durée des lignes est leur longueur divisée par leur vitesse ; les mouvements articulaires sont pris à 1 m/s et 180 deg/s fois leur pourcentage.</translation>
    </message>
    <message>
        <source>A recording began meanwhile, so the path was not added. Stop it, then plan again.</source>
        <translation>Un enregistrement a commencé entre-temps : le chemin n’a pas été ajouté. Arrêtez-le, puis planifiez de nouveau.</translation>
    </message>
    <message>
        <source>A recording runs. Stop it first, then plan.</source>
        <translation>Un enregistrement est en cours. Arrêtez-le d’abord, puis planifiez.</translation>
    </message>
    <message>
        <source>A report of the crash was saved on this computer</source>
        <translation>Un rapport du plantage a été enregistré sur cet ordinateur</translation>
    </message>
    <message>
        <source>A shorter order may exist: this one was not proven to be the shortest.</source>
        <translation>Un ordre plus court existe peut-être : il n'est pas prouvé que celui-ci soit le plus court.</translation>
    </message>
    <message>
        <source>A study names the file of its workcell, and this one has none yet.</source>
        <translation>Une étude nomme le fichier de sa cellule, et celle-ci n'en a pas encore.</translation>
    </message>
    <message>
        <source>A study names the file of its workcell, which must be as it is here.</source>
        <translation>Une étude nomme le fichier de sa cellule, qui doit être telle qu'ici.</translation>
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
        <source>A+B:C+D: names of entities, one colon between the two sides</source>
        <translation>A+B:C+D, des noms d'entités de part et d'autre d'un deux-points</translation>
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
        <source>Absolute</source>
        <translation>Absolue</translation>
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
        <source>Access</source>
        <translation>Accès</translation>
    </message>
    <message>
        <source>Access for maintenance</source>
        <translation>Accès pour la maintenance</translation>
    </message>
    <message>
        <source>Access to %1</source>
        <translation>Accès à %1</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Action</translation>
    </message>
    <message>
        <source>Action FollowJointTrajectory of the robot's controller, as 'ros2 action list' shows it</source>
        <translation>Action FollowJointTrajectory du contrôleur du robot, telle que 'ros2 action list' l'affiche</translation>
    </message>
    <message>
        <source>Action: %1</source>
        <translation>Action : %1</translation>
    </message>
    <message>
        <source>Acts now</source>
        <translation>Agit</translation>
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
        <source>Add a joint.</source>
        <translation>Ajoutez-en une.</translation>
    </message>
    <message>
        <source>Add a mannequin of any size with Ctrl+Shift+M. It stands on the floor, and its hands follow the stylus or the mouse.</source>
        <translation>Ajoutez un mannequin de toute taille par Ctrl+Maj+M. Il se tient sur le sol, et ses mains suivent le stylet ou la souris.</translation>
    </message>
    <message>
        <source>Add a mannequin to the cell first.</source>
        <translation>Ajoutez d'abord un mannequin à la cellule.</translation>
    </message>
    <message>
        <source>Add a robot</source>
        <translation>Ajouter un robot</translation>
    </message>
    <message>
        <source>Add a robot to the cell first.</source>
        <translation>Ajoutez d'abord un robot à la cellule.</translation>
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
        <source>Add the link or correct the name.</source>
        <translation>Ajoutez le segment ou corrigez le nom.</translation>
    </message>
    <message>
        <source>Add the missing chunks, or merge with --partial and let study run complete the result.</source>
        <translation>Ajoutez les morceaux manquants, ou fusionnez avec --partial et laissez study run compléter le résultat.</translation>
    </message>
    <message>
        <source>Add the selected frames</source>
        <translation>Ajouter les repères sélectionnés</translation>
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
        <source>Address for viewers</source>
        <translation>Adresse pour les spectateurs</translation>
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
        <source>Adopt the place</source>
        <translation>Adopter la position</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Après</translation>
    </message>
    <message>
        <source>Against</source>
        <translation>Contre</translation>
    </message>
    <message>
        <source>Agents</source>
        <translation>Agents</translation>
    </message>
    <message>
        <source>Agents moved %1</source>
        <translation>%1 déplacé par les agents</translation>
    </message>
    <message>
        <source>Agents: switch, weight, wish</source>
        <translation>Agents : interrupteur, poids, souhait</translation>
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
        <source>All of the library</source>
        <translation>Toute la bibliothèque</translation>
    </message>
    <message>
        <source>All pairs</source>
        <translation>Toutes les paires</translation>
    </message>
    <message>
        <source>All supported files (*.step *.stp *.p21 *.stpz *.iges *.igs *.stl *.obj *.ply *.off *.gltf *.glb *.dae *.3mf *.fbx *.3ds *.urdf *.xacro *.sdf *.world *.toml);;CAD (*.step *.stp *.p21 *.stpz *.iges *.igs);;Meshes (*.stl *.obj *.ply *.off *.gltf *.glb *.dae *.3mf *.fbx *.3ds);;Robots and cells (*.urdf *.xacro *.sdf *.world *.toml);;All files (*)</source>
        <translation>Tous les fichiers pris en charge (*.step *.stp *.p21 *.stpz *.iges *.igs *.stl *.obj *.ply *.off *.gltf *.glb *.dae *.3mf *.fbx *.3ds *.urdf *.xacro *.sdf *.world *.toml);;CAO (*.step *.stp *.p21 *.stpz *.iges *.igs);;Maillages (*.stl *.obj *.ply *.off *.gltf *.glb *.dae *.3mf *.fbx *.3ds);;Robots et cellules (*.urdf *.xacro *.sdf *.world *.toml);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>All variants: varied values and results</source>
        <translation>Toutes les variantes : valeurs variées et résultats</translation>
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
        <source>Along the way</source>
        <translation>Le long du trajet</translation>
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
        <source>Another haptic server may be running. Stop it, or set another --port (0: any free port).</source>
        <translation>Un autre serveur haptique tourne peut-être. Arrêtez-le, ou indiquez un autre --port (0 : n'importe quel port libre).</translation>
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
        <source>Answer</source>
        <translation>Réponse</translation>
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
        <source>Arcs become frames within 0.1 mm of the arc; the orientation changes evenly from start to end.</source>
        <translation>Les arcs sont remplacés par des images à moins de 0.1 mm d'eux, avec une rotation régulière du début à la fin.</translation>
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
        <source>As ROS_DOMAIN_ID of the other programs. Default: 0</source>
        <translation>Comme ROS_DOMAIN_ID des autres programmes. Par défaut : 0</translation>
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
        <source>Ask again with another depth that counts as touching, or show the way by hand.</source>
        <translation>Recommencez avec une autre profondeur qui compte comme contact, ou montrez le trajet à la main.</translation>
    </message>
    <message>
        <source>Ask for a larger clearance, or for another seed.</source>
        <translation>Demandez une distance de passage plus grande, ou une autre graine.</translation>
    </message>
    <message>
        <source>Ask for a stature instead.</source>
        <translation>Indiquez plutôt une stature.</translation>
    </message>
    <message>
        <source>Ask with another --tolerance, or write the way only for what it is.</source>
        <translation>Demandez avec une autre --tolerance, ou n'écrivez le chemin que pour ce qu'il est.</translation>
    </message>
    <message>
        <source>Ask without --output for what blocks it.</source>
        <translation>Demandez sans --output ce qui le bloque.</translation>
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
        <source>At least</source>
        <translation>Au moins</translation>
    </message>
    <message>
        <source>At least %1. You typed %2.</source>
        <translation>Au moins %1. Vous avez saisi %2.</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Au plus</translation>
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
        <source>Authority</source>
        <translation>Autorité</translation>
    </message>
    <message>
        <source>Authority of a planner beside the hand</source>
        <translation>Autorité d'un planificateur à côté de la main</translation>
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
        <source>Balance</source>
        <translation>Équilibre</translation>
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
        <source>Best configuration</source>
        <translation>Meilleure configuration</translation>
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
        <source>Bodies</source>
        <translation>Corps</translation>
    </message>
    <message>
        <source>Body size</source>
        <translation>Taille du corps</translation>
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
        <source>By</source>
        <translation>Par</translation>
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
        <source>C with only one position</source>
        <translation>C avec une seule position</translation>
    </message>
    <message>
        <source>CHANNELS is missing</source>
        <translation>pas de CHANNELS</translation>
    </message>
    <message>
        <source>CIRC auxiliary point, end point</source>
        <translation>CIRC point auxiliaire, point final</translation>
    </message>
    <message>
        <source>COORD: poses are relative to the part on the other motion group; the motion of that group is not read.</source>
        <translation>COORD : les poses sont relatives à ce que porte l'autre groupe de mouvement ; son mouvement n'est pas lu.</translation>
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
        <source>Calibrate the glove again.</source>
        <translation>Étalonnez de nouveau le gant.</translation>
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
        <source>Cancelled before everything was answered.</source>
        <translation>Annulé avant que tout ait une réponse.</translation>
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
        <source>Change the motion. 'trajectory check' lists all findings.</source>
        <translation>Modifiez le mouvement. « trajectory check » énumère tous les constats.</translation>
    </message>
    <message>
        <source>Change your own measures together, or leave some of them to the regressions.</source>
        <translation>Modifiez ensemble les mesures propres, ou laissez-en certaines aux régressions.</translation>
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
        <source>Check ROS_DOMAIN_ID on both sides, and that the network lets multicast through.</source>
        <translation>Vérifiez ROS_DOMAIN_ID des deux côtés, et que le réseau laisse passer le multicast.</translation>
    </message>
    <message>
        <source>Check and send…</source>
        <translation>Vérifier et envoyer…</translation>
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
        <source>Check for a macro that calls itself.</source>
        <translation>Cherchez une macro qui s'appelle elle-même.</translation>
    </message>
    <message>
        <source>Check for a macro, a file or a property that contains itself.</source>
        <translation>Cherchez une macro, un fichier ou une propriété qui se contient soi-même.</translation>
    </message>
    <message>
        <source>Check for models that include each other several times, or split the world into several files.</source>
        <translation>Cherchez des modèles qui s'incluent plusieurs fois l'un l'autre, ou divisez le monde en plusieurs parties.</translation>
    </message>
    <message>
        <source>Check it</source>
        <translation>Le vérifier</translation>
    </message>
    <message>
        <source>Check it with another program (gz sdf --check), or export it again.</source>
        <translation>Vérifiez-le avec un autre programme (gz sdf --check), ou exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>Check its content, then run: chmod go-w '%1'.</source>
        <translation>Examinez son contenu, puis lancez : chmod go-w '%1'.</translation>
    </message>
    <message>
        <source>Check its permissions.</source>
        <translation>Vérifiez ses droits d'accès.</translation>
    </message>
    <message>
        <source>Check motions</source>
        <translation>Vérifier les mouvements</translation>
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
        <source>Check that the folder exists and that ffmpeg supports this extension.</source>
        <translation>Vérifiez que le dossier existe et que ffmpeg connaît cette extension.</translation>
    </message>
    <message>
        <source>Check the disk or the receiving program.</source>
        <translation>Vérifiez le disque ou le programme qui reçoit les données.</translation>
    </message>
    <message>
        <source>Check the motion</source>
        <translation>Vérifier le mouvement</translation>
    </message>
    <message>
        <source>Check the motion in the cell, then ask before the robot moves</source>
        <translation>Vérifier le mouvement dans la cellule, puis demander avant que le robot bouge</translation>
    </message>
    <message>
        <source>Check the network in both directions.</source>
        <translation>Vérifiez le réseau dans les deux sens.</translation>
    </message>
    <message>
        <source>Check the network interface and CYCLONEDDS_URI.</source>
        <translation>Vérifiez l'interface réseau et CYCLONEDDS_URI.</translation>
    </message>
    <message>
        <source>Check the options for this cluster; the script stays in the folder.</source>
        <translation>Vérifiez les options pour cette grappe ; le script reste dans le dossier.</translation>
    </message>
    <message>
        <source>Check the shown way</source>
        <translation>Vérifier le trajet montré</translation>
    </message>
    <message>
        <source>Check the unit. If it is right, move the part to the origin in the CAD program.</source>
        <translation>Vérifiez l'unité. Si elle est juste, déplacez la pièce à l'origine dans le logiciel de CAO.</translation>
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
        <source>Checked: no contact, within the limits.</source>
        <translation>Vérifié : aucun contact, dans les limites.</translation>
    </message>
    <message>
        <source>Checking the mesh</source>
        <translation>Examen du maillage</translation>
    </message>
    <message>
        <source>Checking the motion…</source>
        <translation>Vérification du mouvement…</translation>
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
        <source>Choose a coarser tessellation or import it in parts.</source>
        <translation>Choisissez un maillage plus grossier ou importez-le en plusieurs parties.</translation>
    </message>
    <message>
        <source>Choose a file to see what it is.</source>
        <translation>Choisissez un fichier pour voir ce que c'est.</translation>
    </message>
    <message>
        <source>Choose a line above, or add one.</source>
        <translation>Choisissez une ligne ci-dessus, ou ajoutez-en une.</translation>
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
        <source>Choose a robot.</source>
        <translation>Choisissez un robot.</translation>
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
        <source>Choose another %1. Nothing was written.</source>
        <translation>Choisissez une autre valeur (%1). Rien n'a été écrit.</translation>
    </message>
    <message>
        <source>Choose another folder.</source>
        <translation>Écrivez-le ailleurs.</translation>
    </message>
    <message>
        <source>Choose another port, or end the program that uses it.</source>
        <translation>Choisissez un autre port, ou arrêtez le programme qui l'utilise.</translation>
    </message>
    <message>
        <source>Choose another results file.</source>
        <translation>Choisissez un autre fichier de résultats.</translation>
    </message>
    <message>
        <source>Choose another tip link.</source>
        <translation>Choisissez un autre segment terminal.</translation>
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
        <source>Choose the left or right hand of %1 in 'Moved by' first.</source>
        <translation>Choisissez d'abord la main gauche ou droite de %1 sous « Déplacé par ».</translation>
    </message>
    <message>
        <source>Choose the report logo</source>
        <translation>Choisir le logo des rapports</translation>
    </message>
    <message>
        <source>Choose the robot in the cell, then import the motion again.</source>
        <translation>Choisissez le robot dans la cellule, puis réimportez le mouvement.</translation>
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
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>Chosen step</source>
        <translation>Étape choisie</translation>
    </message>
    <message>
        <source>Chunks</source>
        <translation>Parts</translation>
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
        <source>Clearance</source>
        <translation>Distance libre</translation>
    </message>
    <message>
        <source>Clearance of its way</source>
        <translation>Dégagement de son chemin</translation>
    </message>
    <message>
        <source>Clearance, nearest pair</source>
        <translation>Distance minimale</translation>
    </message>
    <message>
        <source>Clearances on its way</source>
        <translation>Jeux sur son chemin</translation>
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
        <source>Close it there, or choose another name.</source>
        <translation>Fermez-le là-bas, ou choisissez un autre nom.</translation>
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
        <source>Cluster</source>
        <translation>Grappe</translation>
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
        <source>Colour the places of the variants in the scene</source>
        <translation>Colorer les places des variantes dans la scène</translation>
    </message>
    <message>
        <source>Colours of the map</source>
        <translation>Couleurs de la carte</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Colonnes</translation>
    </message>
    <message>
        <source>Comfort</source>
        <translation>Confort</translation>
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
        <source>Complete.</source>
        <translation>Terminée.</translation>
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
        <source>Connect it with a joint, for example a fixed joint.</source>
        <translation>Reliez-le, ne serait-ce que par une liaison fixe.</translation>
    </message>
    <message>
        <source>Connect them with a fixed joint.</source>
        <translation>Reliez-les par un axe fixe.</translation>
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
        <source>Content</source>
        <translation>Contenu</translation>
    </message>
    <message>
        <source>Content of the study</source>
        <translation>Contenu de l'étude</translation>
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
        <source>Copy the file to this folder. A .gltf needs its .bin files.</source>
        <translation>Copiez le fichier dans ce dossier. Un .gltf a besoin de ses fichiers .bin.</translation>
    </message>
    <message>
        <source>Cores each</source>
        <translation>Cœurs/part</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Coin</translation>
    </message>
    <message>
        <source>Correct &quot;attached&quot; in the document.</source>
        <translation>Corrigez &quot;attached&quot; dans le document.</translation>
    </message>
    <message>
        <source>Correct &quot;parent&quot; in the document.</source>
        <translation>Corrigez &quot;parent&quot; dans le document.</translation>
    </message>
    <message>
        <source>Correct it, or set lazy_eval=&quot;false&quot; to evaluate it where it is defined.</source>
        <translation>Corrigez-la, ou évaluez-la là où elle est écrite avec lazy_eval=&quot;false&quot;.</translation>
    </message>
    <message>
        <source>Correct the file, or move it out of the folder of the robot.</source>
        <translation>Corrigez le fichier ou retirez-le du dossier du robot.</translation>
    </message>
    <message>
        <source>Correct the name, or define the property earlier in the file.</source>
        <translation>Corrigez le nom, ou définissez la propriété avant.</translation>
    </message>
    <message>
        <source>Correct the path, or copy the file to this place.</source>
        <translation>Corrigez le chemin ou placez-y le fichier.</translation>
    </message>
    <message>
        <source>Counts as touching</source>
        <translation>Seuil de contact</translation>
    </message>
    <message>
        <source>Coupling</source>
        <translation>Prise</translation>
    </message>
    <message>
        <source>Crash reports cannot be saved</source>
        <translation>Les rapports de plantage ne peuvent pas être enregistrés</translation>
    </message>
    <message>
        <source>Create a new key (hapticell-haptic-server --pair). If nobody has read this one, run chmod 600 on it.</source>
        <translation>Créez-en une nouvelle (hapticell-haptic-server --pair), ou faites chmod 600 si personne ne l'a lue.</translation>
    </message>
    <message>
        <source>Create a study of the open workcell</source>
        <translation>Créer une étude de la cellule ouverte</translation>
    </message>
    <message>
        <source>Create a study of the open workcell, or open one.</source>
        <translation>Créez une étude de la cellule ouverte, ou ouvrez-en une.</translation>
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
        <source>Cycle time</source>
        <translation>Temps de cycle</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Cylindre</translation>
    </message>
    <message>
        <source>DDS to work</source>
        <translation>que DDS fonctionne</translation>
    </message>
    <message>
        <source>DEF is missing</source>
        <translation>pas de DEF</translation>
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
        <source>Delete it in a copy of the program.</source>
        <translation>Retirez-le d'une copie du programme.</translation>
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
        <source>Delta '%1'</source>
        <translation>Delta '%1'</translation>
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
        <source>Description</source>
        <translation>Description</translation>
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
        <source>Direction</source>
        <translation>Sens</translation>
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
        <source>Domain</source>
        <translation>Domaine</translation>
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
        <source>Down</source>
        <translation>Descendre</translation>
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
        <source>Drag the moved frame in the scene to lead.</source>
        <translation>Tirez le repère mobile dans la scène pour mener.</translation>
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
        <source>Dwell</source>
        <translation>Arrêt</translation>
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
        <source>ENDFOR without FOR</source>
        <translation>ENDFOR sans FOR</translation>
    </message>
    <message>
        <source>Each body</source>
        <translation>Chaque corps</translation>
    </message>
    <message>
        <source>Each frame is one line. The file is incomplete or was edited: export it again.</source>
        <translation>Vérifiez le fichier : une image tient sur une ligne ; il est tronqué ou a été modifié.</translation>
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
        <source>Edit the study as text.</source>
        <translation>Modifiez l'étude comme texte.</translation>
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
        <source>Ends what runs (Ctrl+C in the field); a second time, ends the interpreter</source>
        <translation>Termine ce qui s’exécute (Ctrl+C dans le champ) ; une seconde fois, termine l’interpréteur</translation>
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
        <source>Every combination</source>
        <translation>Toutes les combinaisons</translation>
    </message>
    <message>
        <source>Every user of this machine can see a code on the command line while the command runs. Leave it out to type it.</source>
        <translation>Tous les utilisateurs de cette machine peuvent voir un code sur la ligne de commande pendant que la commande s'exécute. Omettez-le pour le saisir.</translation>
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
        <source>Exclude %1 pairs that overlap</source>
        <translation>Exclure %1 paires qui se chevauchent</translation>
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
        <source>Exclude a pair that overlaps</source>
        <translation>Exclure une paire qui se chevauche</translation>
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
        <source>Export it again or in another format (STEP, glTF, STL), without the part that this message names.</source>
        <translation>Exportez-le de nouveau, ou dans un autre format (STEP, glTF, STL), et sans la pièce citée.</translation>
    </message>
    <message>
        <source>Export it again or in another format, or split it into several files.</source>
        <translation>Exportez-le de nouveau, ou dans un autre format ; si le fichier est correct, divisez-le en plusieurs.</translation>
    </message>
    <message>
        <source>Export it again, or in another format (STEP, glTF, STL).</source>
        <translation>Exportez-le à nouveau, ou dans un autre format (STEP, glTF, STL).</translation>
    </message>
    <message>
        <source>Export it again.</source>
        <translation>Exportez-le à nouveau.</translation>
    </message>
    <message>
        <source>Export it as csv, json or ros.</source>
        <translation>Exportez-le en csv, json ou ros.</translation>
    </message>
    <message>
        <source>Export it as glTF or STL, or make the mesh coarser first.</source>
        <translation>Exportez-le en glTF ou STL, ou rendez d'abord le maillage plus grossier.</translation>
    </message>
    <message>
        <source>Export it in one of these formats.</source>
        <translation>Exportez-le dans un de ces formats.</translation>
    </message>
    <message>
        <source>Export it with exact shapes (B-rep), or its triangles as STL, OBJ or 3MF.</source>
        <translation>Exportez-le avec des formes exactes (B-rep), ou ses triangles en STL, OBJ ou 3MF.</translation>
    </message>
    <message>
        <source>Export it without this extension, or remove the extension with a conversion tool.</source>
        <translation>Exportez-le sans cette extension, ou convertissez-le avec un outil qui sait la retirer.</translation>
    </message>
    <message>
        <source>Export it without this extension.</source>
        <translation>Exportez-le sans cette extension.</translation>
    </message>
    <message>
        <source>Export motion</source>
        <translation>Exporter le mouvement</translation>
    </message>
    <message>
        <source>Export one person per file.</source>
        <translation>Exportez une seule personne par fichier.</translation>
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
        <source>Export the file again.</source>
        <translation>Exportez le fichier à nouveau.</translation>
    </message>
    <message>
        <source>Export the file with decimal points; it has decimal commas.</source>
        <translation>Écrivez le fichier avec des points décimaux ; celui-ci a des virgules.</translation>
    </message>
    <message>
        <source>Export the poses as csv or json instead.</source>
        <translation>Exportez plutôt ses poses en csv ou json.</translation>
    </message>
    <message>
        <source>Export the results</source>
        <translation>Exporter les résultats</translation>
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
        <source>External axes move with the robot's own joints</source>
        <translation>Les axes externes bougent avec les articulations du robot</translation>
    </message>
    <message>
        <source>External axes of the targets (E1 ...) are not kept.</source>
        <translation>Les axes externes des cibles (E1 ...) ne sont pas conservés.</translation>
    </message>
    <message>
        <source>External axes of the targets (E1 to E6) are not kept.</source>
        <translation>Les axes externes des cibles (E1 à E6) ne sont pas conservés.</translation>
    </message>
    <message>
        <source>External axes of the targets are not kept.</source>
        <translation>Les axes externes des cibles ne sont pas conservés.</translation>
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
        <source>FANUC measures J3 from the horizontal: J2 is added to J3.</source>
        <translation>Le J3 de FANUC est compté depuis l'horizontale : J2 lui est ajouté.</translation>
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
        <source>Fast DDS or Cyclone DDS</source>
        <translation>Fast DDS ou Cyclone DDS</translation>
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
        <source>Fault ({}) at tick {}: the ticks around it are in {}; {} more faults have no file</source>
        <translation>Défaut ({}) au cycle {} : les cycles voisins sont dans {} ; {} autres défauts sont sans fichier</translation>
    </message>
    <message>
        <source>Fault ({}) at tick {}: {}</source>
        <translation>Fault ({}) at tick {}: {}</translation>
    </message>
    <message>
        <source>Feasible</source>
        <translation>Réalisable</translation>
    </message>
    <message>
        <source>Feel and files</source>
        <translation>Toucher et fichiers</translation>
    </message>
    <message>
        <source>Feel it by hand</source>
        <translation>Sentir à la main</translation>
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
        <source>Find the way out</source>
        <translation>Chercher la sortie</translation>
    </message>
    <message>
        <source>Find topics</source>
        <translation>Chercher les topics</translation>
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
        <source>First create a key: hapticell-haptic-server --pair.</source>
        <translation>Créez d'abord une clé : hapticell-haptic-server --pair.</translation>
    </message>
    <message>
        <source>First create a surface from the point cloud.</source>
        <translation>Faites d'abord une surface à partir du nuage de points.</translation>
    </message>
    <message>
        <source>First export it with poses: trajectory export --to csv --robot.</source>
        <translation>Exportez-le d'abord avec ses poses : trajectory export --to csv --robot.</translation>
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
        <source>Floor area</source>
        <translation>Zone au sol</translation>
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
        <source>Following your hand: the planner looks for a way on from there.</source>
        <translation>Suit votre main : le planificateur cherche un chemin à partir de là.</translation>
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
        <source>Frame Time: is missing</source>
        <translation>pas de Frame Time:</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Repères</translation>
    </message>
    <message>
        <source>Frames are missing or repeated: export the file again.</source>
        <translation>Écrivez de nouveau le fichier : des images manquent ou sont en double.</translation>
    </message>
    <message>
        <source>Frames recorded: %1</source>
        <translation>Images enregistrées : %1</translation>
    </message>
    <message>
        <source>Frames that are targets</source>
        <translation>Repères qui sont des cibles</translation>
    </message>
    <message>
        <source>Frames that the path passes, in this order</source>
        <translation>Repères par lesquels passe le chemin, dans cet ordre</translation>
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
        <source>Free disk space, or write to another disk.</source>
        <translation>Libérez de l'espace ou écrivez sur un autre disque.</translation>
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
        <source>GB 18030 (Chinese)</source>
        <translation>GB 18030 (chinois)</translation>
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
        <source>Goal</source>
        <translation>But</translation>
    </message>
    <message>
        <source>Goal X</source>
        <translation>But X</translation>
    </message>
    <message>
        <source>Goal: here</source>
        <translation>But : ici</translation>
    </message>
    <message>
        <source>Goal: pick a point</source>
        <translation>But : désigner un point</translation>
    </message>
    <message>
        <source>Goal: selected entity</source>
        <translation>But : entité sélectionnée</translation>
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
        <source>Greatest speed of the tool. A faster motion is slowed as a whole. Default: 250 mm/s</source>
        <translation>Vitesse maximale de l'outil. Un mouvement plus rapide est ralenti en entier. Par défaut : 250 mm/s</translation>
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
        <source>HAPTICELL_CONFIG_DIR</source>
        <translation>HAPTICELL_CONFIG_DIR</translation>
    </message>
    <message>
        <source>HIERARCHY is missing</source>
        <translation>pas de HIERARCHY</translation>
    </message>
    <message>
        <source>HOME is '%1', not an absolute path</source>
        <translation>HOME vaut '%1', qui n'est pas un chemin absolu</translation>
    </message>
    <message>
        <source>HOME is empty</source>
        <translation>HOME est vide</translation>
    </message>
    <message>
        <source>HOME is not set</source>
        <translation>HOME n'est pas définie</translation>
    </message>
    <message>
        <source>HOST:PORT with a port from 1 to 65535</source>
        <translation>HOST:PORT avec un port de 1 à 65535</translation>
    </message>
    <message>
        <source>Halton samples</source>
        <translation>Échantillons de Halton</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Main</translation>
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
        <source>Hand over to the planner</source>
        <translation>Confier au planificateur</translation>
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
        <source>Hold %1: the planner works while you hold it.</source>
        <translation>Tenez %1 : le planificateur travaille tant que vous le tenez.</translation>
    </message>
    <message>
        <source>Hold an entity with the stylus, move it and feel what it touches</source>
        <translation>Tenir une entité avec le stylet, la déplacer et sentir ce qu'elle touche</translation>
    </message>
    <message>
        <source>Hold it before the motion begins.</source>
        <translation>Tenez-le enfoncé avant le début du mouvement.</translation>
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
        <source>How strongly the way is felt. 0 %: it is only drawn</source>
        <translation>Force avec laquelle le chemin est ressenti. 0 % : il est seulement dessiné</translation>
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
        <source>I/N with 1 &lt;= I &lt;= N, for example 3/16</source>
        <translation>I/N avec 1 &lt;= I &lt;= N, par exemple 3/16</translation>
    </message>
    <message>
        <source>If a property is a text here, check it for a mistyped number.</source>
        <translation>Vérifiez les propriétés : l'une d'elles est un texte, peut-être un nombre mal saisi.</translation>
    </message>
    <message>
        <source>If targets are given by joints, set the robot (--robot).</source>
        <translation>Indiquez le robot (--robot) si des cibles sont données par leurs axes.</translation>
    </message>
    <message>
        <source>If the target is given by joints, set the robot (--robot). Otherwise, write its value into the program.</source>
        <translation>Indiquez le robot (--robot) si la cible est donnée par ses axes ; sinon, écrivez sa valeur dans le programme.</translation>
    </message>
    <message>
        <source>If this is a file of macros, open the file that includes it.</source>
        <translation>Ouvrez un fichier de macros par le fichier qui l'inclut.</translation>
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
        <source>Import a robot</source>
        <translation>Importer un robot</translation>
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
        <source>Import it again.</source>
        <translation>Importez-le à nouveau.</translation>
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
        <source>Import the file again.</source>
        <translation>Importez le fichier de nouveau.</translation>
    </message>
    <message>
        <source>Import — %1</source>
        <translation>Importer — %1</translation>
    </message>
    <message>
        <source>Imported motion</source>
        <translation>Mouvement importé</translation>
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
        <source>In a copy of the program, delete the branch that you do not need.</source>
        <translation>Retirez d'une copie du programme la branche qui n'est pas voulue.</translation>
    </message>
    <message>
        <source>In a copy of the program, delete the branches that you do not need.</source>
        <translation>Retirez d'une copie les branches qui ne sont pas voulues.</translation>
    </message>
    <message>
        <source>In a copy of the program, delete the offset, or add it to the targets.</source>
        <translation>Retirez le décalage d'une copie, ou écrivez les cibles avec lui.</translation>
    </message>
    <message>
        <source>In contact from the start: %1 and %2</source>
        <translation>En contact dès le début : %1 et %2</translation>
    </message>
    <message>
        <source>In its way: %1.</source>
        <translation>Sur son trajet : %1.</translation>
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
        <source>Include the file that defines it, or correct the name.</source>
        <translation>Incluez le fichier qui la définit, ou corrigez le nom.</translation>
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
        <source>Install HaptiCell again.</source>
        <translation>Réinstallez HaptiCell.</translation>
    </message>
    <message>
        <source>Install HaptiCell with its link to ROS 2 (Debian: cyclonedds-dev, when building).</source>
        <translation>Installez HaptiCell avec sa liaison ROS 2 (Debian : cyclonedds-dev, à la compilation).</translation>
    </message>
    <message>
        <source>Install Slurm (Debian: slurm-client), or run the chunks by GNU Parallel.</source>
        <translation>Installez Slurm (Debian : slurm-client), ou lancez les morceaux avec GNU Parallel.</translation>
    </message>
    <message>
        <source>Install ffmpeg, or save a picture (.png).</source>
        <translation>Installez ffmpeg, ou enregistrez une image (png).</translation>
    </message>
    <message>
        <source>Install the library that this message names, or remove the file.</source>
        <translation>Installez la bibliothèque qu'il nomme, ou supprimez le fichier.</translation>
    </message>
    <message>
        <source>Install the version of HaptiCell that made them.</source>
        <translation>Installez la version de HaptiCell qui les a produits.</translation>
    </message>
    <message>
        <source>Interrupt</source>
        <translation>Interrompre</translation>
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
        <source>It is at the goal. Adopt its place, or keep the motion.</source>
        <translation>Le but est atteint. Adoptez la position, ou gardez le mouvement.</translation>
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
        <source>It overlaps %1 at rest, by more than counts as touching.</source>
        <translation>Il chevauche %1 au repos, plus qu'un simple contact.</translation>
    </message>
    <message>
        <source>It slides along it for %1.</source>
        <translation>Elle glisse contre elle sur %1.</translation>
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
        <source>JOINT, End Site, OFFSET, CHANNELS or }</source>
        <translation>JOINT, End Site, OFFSET, CHANNELS ou }</translation>
    </message>
    <message>
        <source>JSON content</source>
        <translation>contenu JSON</translation>
    </message>
    <message>
        <source>JSON content, byte %1</source>
        <translation>contenu JSON, octet %1</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>À-coup</translation>
    </message>
    <message>
        <source>Job %1: %2 of %3 chunks complete. Stop only ends the following.</source>
        <translation>Tâche %1 : %2 parts sur %3 terminées. Arrêter met seulement fin au suivi.</translation>
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
        <source>Joint margin</source>
        <translation>Marge articulaire</translation>
    </message>
    <message>
        <source>Joint states</source>
        <translation>Articulations</translation>
    </message>
    <message>
        <source>Joint values are not kept, because not all targets have them. Poses are kept.</source>
        <translation>Les axes ne sont pas conservés, car toutes les cibles n'en ont pas ; leurs poses le sont.</translation>
    </message>
    <message>
        <source>JointTrajectory</source>
        <translation>JointTrajectory</translation>
    </message>
    <message>
        <source>JointTrajectory, point %1</source>
        <translation>JointTrajectory, point %1</translation>
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
        <source>KEY=VALUE</source>
        <translation>KEY=VALUE</translation>
    </message>
    <message>
        <source>KHR_draco_mesh_compression</source>
        <translation>KHR_draco_mesh_compression</translation>
    </message>
    <message>
        <source>KUKA KRL (.src, .dat)</source>
        <translation>KUKA KRL (.src, .dat)</translation>
    </message>
    <message>
        <source>Keep as a motion</source>
        <translation>Garder comme mouvement</translation>
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
        <source>Keep only one trajectory in the file.</source>
        <translation>Ne gardez qu'une trajectoire dans le fichier.</translation>
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
        <source>Keep people out of its reach and the emergency stop at hand.</source>
        <translation>Éloignez les personnes de sa portée et gardez l'arrêt d'urgence à portée de main.</translation>
    </message>
    <message>
        <source>Keep pose</source>
        <translation>Garder la pose</translation>
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
        <source>Keep the motion</source>
        <translation>Garder le mouvement</translation>
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
        <source>Keep the way of %1</source>
        <translation>Garder le trajet de %1</translation>
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
        <source>Kind of values</source>
        <translation>Type de valeurs</translation>
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
        <source>Large</source>
        <translation>Grand</translation>
    </message>
    <message>
        <source>Largest mass with felt inertia</source>
        <translation>Plus grande masse à inertie sentie</translation>
    </message>
    <message>
        <source>Last actions as a script</source>
        <translation>Dernières actions en script</translation>
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
        <source>Latin-1 (Western Europe)</source>
        <translation>Latin-1 (Europe de l'Ouest)</translation>
    </message>
    <message>
        <source>Lay earlier parts aside</source>
        <translation>Poser à côté les précédentes</translation>
    </message>
    <message>
        <source>Lay parts aside</source>
        <translation>Poser des pièces à côté</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Disposition</translation>
    </message>
    <message>
        <source>Least clearance</source>
        <translation>Jeu minimal</translation>
    </message>
    <message>
        <source>Least clearance %1 mm %2. Length %3 mm, %4 s, seed %5.</source>
        <translation>Plus petit écart %1 mm %2. Longueur %3 mm, %4 s, graine %5.</translation>
    </message>
    <message>
        <source>Least clearance %1, to %2.</source>
        <translation>Jeu minimal %1, avec %2.</translation>
    </message>
    <message>
        <source>Leave one of the two files out.</source>
        <translation>Laissez de côté l'un des deux fichiers.</translation>
    </message>
    <message>
        <source>Leave the unit out.</source>
        <translation>N'indiquez pas d'unité.</translation>
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
        <source>Limits</source>
        <translation>Limites</translation>
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
        <source>Line %1: %2</source>
        <translation>Ligne %1 : %2</translation>
    </message>
    <message>
        <source>Line: rate. Bars: lateness (99th percentile), full height %1 ms</source>
        <translation>Ligne : fréquence. Barres : retard (99 %), au plus %1 ms</translation>
    </message>
    <message>
        <source>Lines without motion are not kept (outputs, waiting for inputs, settings): %1 and %2 more.</source>
        <translation>Sans mouvement et non conservées (sorties, attentes d'entrées, réglages) : lignes %1 et %2 autres.</translation>
    </message>
    <message>
        <source>Lines without motion are not kept (outputs, waiting for inputs, settings): %1.</source>
        <translation>Sans mouvement et non conservées (sorties, attentes d'entrées, réglages) : lignes %1.</translation>
    </message>
    <message>
        <source>List</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>Lists in parallel</source>
        <translation>Listes en parallèle</translation>
    </message>
    <message>
        <source>Live view</source>
        <translation>Vue en direct</translation>
    </message>
    <message>
        <source>Live view in a browser</source>
        <translation>Vue en direct dans un navigateur</translation>
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
        <source>Longest time</source>
        <translation>Durée max.</translation>
    </message>
    <message>
        <source>Look as far as</source>
        <translation>Portée</translation>
    </message>
    <message>
        <source>Look at part</source>
        <translation>Regarder la pièce</translation>
    </message>
    <message>
        <source>Look for programs of ROS 2 in the network for three seconds</source>
        <translation>Chercher pendant trois secondes les programmes ROS 2 du réseau</translation>
    </message>
    <message>
        <source>Looking for programs of ROS 2…</source>
        <translation>Recherche de programmes ROS 2…</translation>
    </message>
    <message>
        <source>Looking for the controller and the robot…</source>
        <translation>Recherche du contrôleur et du robot…</translation>
    </message>
    <message>
        <source>Looking for ways, hands and persons. The cell stays as it is.</source>
        <translation>Recherche de trajets, de prises et de personnes. La cellule reste telle quelle.</translation>
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
        <source>M7 and M11 are measured only with --timing.</source>
        <translation>Ajoutez --timing pour mesurer M7 et M11.</translation>
    </message>
    <message>
        <source>MOTION with Frames: is missing</source>
        <translation>pas de MOTION avec Frames:</translation>
    </message>
    <message>
        <source>MOVC to %1 points</source>
        <translation>MOVC vers %1 points</translation>
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
        <source>Make room and run the same command again: it continues with the missing variants.</source>
        <translation>Libérez de la place et relancez la même commande : elle continue avec les variantes manquantes.</translation>
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
        <source>Manipulability</source>
        <translation>Manipulabilité</translation>
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
        <source>Map</source>
        <translation>Carte</translation>
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
        <source>May step</source>
        <translation>Peut avancer</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
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
        <source>Measure the way</source>
        <translation>Mesurer le trajet</translation>
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
        <source>Memory is not locked (mlockall: %1), so ticks can be late while memory is swapped in. To allow it: %2</source>
        <translation>La mémoire n'est pas verrouillée (mlockall : %1) : des cycles peuvent être en retard pendant la lecture de l'espace d'échange. Pour l'autoriser : %2</translation>
    </message>
    <message>
        <source>Men P5, P50, P95</source>
        <translation>Hommes P5, P50, P95</translation>
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
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>Méthodes</translation>
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
        <source>Mount</source>
        <translation>Monter</translation>
    </message>
    <message>
        <source>Mount %1 on %2</source>
        <translation>Monter %1 sur %2</translation>
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
        <source>Move it into the folder of the file that refers to it.</source>
        <translation>Placez-le sous le dossier du fichier qui le cite.</translation>
    </message>
    <message>
        <source>Move it there</source>
        <translation>Le mettre là</translation>
    </message>
    <message>
        <source>Move it to the goal, click here, then move it back to where the path begins.</source>
        <translation>Placez-le au but, cliquez ici, puis ramenez-le là où le chemin commence.</translation>
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
        <source>Move some away.</source>
        <translation>Déplacez-en quelques-uns.</translation>
    </message>
    <message>
        <source>Move the TCP of %1</source>
        <translation>Déplacer le TCP de %1</translation>
    </message>
    <message>
        <source>Move the joints of the legs apart, or rotate the platform relative to the base.</source>
        <translation>Écartez les articulations, ou tournez la plateforme par rapport à la base.</translation>
    </message>
    <message>
        <source>Move the mannequin or the part nearer, or unlock the feet so that it can step.</source>
        <translation>Rapprochez le mannequin ou la pièce, ou débloquez les pieds pour qu'il puisse faire un pas.</translation>
    </message>
    <message>
        <source>Move the motion nearer to the robot's base.</source>
        <translation>Rapprochez le mouvement de la base du robot.</translation>
    </message>
    <message>
        <source>Move the robot</source>
        <translation>Faire bouger le robot</translation>
    </message>
    <message>
        <source>Move the robot there, or record a motion that begins where it is.</source>
        <translation>Amenez-y le robot, ou enregistrez un mouvement qui commence là où il se trouve.</translation>
    </message>
    <message>
        <source>Move the selected entity</source>
        <translation>Déplacer l’entité sélectionnée</translation>
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
        <source>Move them apart by a millimetre, or leave the pair out by a rule of the cell.</source>
        <translation>Écartez-les d'un millimètre, ou excluez la paire par une règle de la cellule.</translation>
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
        <source>Moves the part's origin to the frame of the link, then attaches it</source>
        <translation>Amène l'origine de la pièce sur le repère du segment, puis l'attache</translation>
    </message>
    <message>
        <source>Moves the parts that go first next to the assembly, as one undo step</source>
        <translation>Déplace les pièces à retirer d'abord à côté de l'assemblage, en une étape d'annulation</translation>
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
        <source>NAME or NAME:LINK</source>
        <translation>NAME ou NAME:LINK</translation>
    </message>
    <message>
        <source>NAME or NAME:LINK of an entity that an earlier --add added</source>
        <translation>NAME ou NAME:LINK d'une entité ajoutée auparavant</translation>
    </message>
    <message>
        <source>NAME:=VALUE</source>
        <translation>NAME:=VALUE</translation>
    </message>
    <message>
        <source>NAME=NUMBER, from 0 (off) to 100</source>
        <translation>NOM=NOMBRE, de 0 (arrêté) à 100</translation>
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
        <source>Name fewer or other joints as actuated.</source>
        <translation>Nommez moins d'axes actionnés, ou d'autres.</translation>
    </message>
    <message>
        <source>Name it by --entity.</source>
        <translation>Nommez-le par --entity.</translation>
    </message>
    <message>
        <source>Name of the pose (home replaces home)</source>
        <translation>Nom de la pose (home remplace home)</translation>
    </message>
    <message>
        <source>Name the form of its services by --services.</source>
        <translation>Nommez la forme de ses services par --services.</translation>
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
        <source>Neighbour</source>
        <translation>Voisin</translation>
    </message>
    <message>
        <source>Network</source>
        <translation>Réseau</translation>
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
        <source>New study</source>
        <translation>Nouvelle étude</translation>
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
        <source>No Python</source>
        <translation>Pas de Python</translation>
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
        <source>No entity was held and moved, so the recording has no frames.</source>
        <translation>Rien n'a été tenu et déplacé, donc l'enregistrement n'a pas d'images.</translation>
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
        <source>No frame: the path goes to its goal by any way.</source>
        <translation>Aucun repère : le chemin mène au but de n'importe quelle façon.</translation>
    </message>
    <message>
        <source>No frames</source>
        <translation>Aucune image</translation>
    </message>
    <message>
        <source>No goal was taken</source>
        <translation>Aucun but n'a été pris</translation>
    </message>
    <message>
        <source>No goal yet. Choose where the entity should go.</source>
        <translation>Pas encore de but. Choisissez où l'entité doit aller.</translation>
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
        <source>No mannequin is selected</source>
        <translation>Aucun mannequin n'est sélectionné</translation>
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
        <source>No motion is switched on. Record or import one, and switch it on in the list.</source>
        <translation>Aucun mouvement n'est activé. Enregistrez-en ou importez-en un, et activez-le dans la liste.</translation>
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
        <source>No path was planned</source>
        <translation>Aucun chemin n’a été planifié</translation>
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
        <source>No progress, %1 from the goal (%2). Hand it over to the planner, or lead it by hand.</source>
        <translation>Aucun progrès, à %1 du but (%2). Confiez-le au planificateur, ou menez à la main.</translation>
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
        <source>No results yet</source>
        <translation>Pas encore de résultats</translation>
    </message>
    <message>
        <source>No results yet.</source>
        <translation>Pas encore de résultats.</translation>
    </message>
    <message>
        <source>No results yet. Run a study, or open a results file.</source>
        <translation>Aucun résultat.</translation>
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
        <source>No study is open</source>
        <translation>Aucune étude n'est ouverte</translation>
    </message>
    <message>
        <source>No study is open.</source>
        <translation>Aucune étude n'est ouverte.</translation>
    </message>
    <message>
        <source>No study is open. Press New or Open first.</source>
        <translation>Aucune étude n'est ouverte. Appuyez d'abord sur Nouveau ou Ouvrir.</translation>
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
        <source>No topics were found. Check the domain and the network.</source>
        <translation>Aucun topic n'a été trouvé. Vérifiez le domaine et le réseau.</translation>
    </message>
    <message>
        <source>No way out was found for %1.</source>
        <translation>Aucun chemin de sortie n'a été trouvé pour %1.</translation>
    </message>
    <message>
        <source>No way yet: %1.</source>
        <translation>Pas encore de chemin : %1.</translation>
    </message>
    <message>
        <source>Nobody</source>
        <translation>Personne</translation>
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
        <source>Normal</source>
        <translation>Normale</translation>
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
        <source>Not checked, because they touch at the start: %1</source>
        <translation>Non vérifié, car en contact au début : %1</translation>
    </message>
    <message>
        <source>Not chosen yet</source>
        <translation>Pas encore choisi</translation>
    </message>
    <message>
        <source>Not complete: %1</source>
        <translation>Incomplète : %1</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Pas connecté</translation>
    </message>
    <message>
        <source>Not editable here, kept unchanged: %1</source>
        <translation>Non modifiable ici, gardé tel quel : %1</translation>
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
        <source>Not sent.</source>
        <translation>Non envoyé.</translation>
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
        <source>Nothing is selected. Select the part that is to be taken out in the scene or in the tree.</source>
        <translation>Rien n'est sélectionné. Sélectionnez la pièce à retirer dans la scène ou dans l'arbre.</translation>
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
        <source>Nothing was changed in the cell, so there is no script.</source>
        <translation>Rien n’a été modifié dans la cellule, il n’y a donc pas de script.</translation>
    </message>
    <message>
        <source>Nothing was saved. Use --unchecked to save the code without a connection.</source>
        <translation>Rien n'a été enregistré. Utilisez --unchecked pour enregistrer le code sans connexion.</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>Rien n'a été écrit.</translation>
    </message>
    <message>
        <source>Nothing was written. A workcell from someone else can name any file of this machine. Check the list, then pack with --allow-outside, or move the files into the folder.</source>
        <translation>Rien n'a été écrit. Une cellule venue d'ailleurs peut nommer n'importe quel fichier de cette machine. Vérifiez la liste, puis archivez avec --allow-outside, ou déplacez les fichiers dans le dossier.</translation>
    </message>
    <message>
        <source>Nothing was written. Check the messages of the server, then run the session again.</source>
        <translation>Rien n'a été écrit. Consultez les messages du serveur, puis relancez la session.</translation>
    </message>
    <message>
        <source>Nothing was written. Move the motion nearer to the robot's base.</source>
        <translation>Rien n'a été écrit. Rapprochez le mouvement de la base du robot.</translation>
    </message>
    <message>
        <source>Nothing was written. To write the file anyway, use --allow-miss.</source>
        <translation>Rien n'a été écrit. Pour écrire quand même le fichier, utilisez --allow-miss.</translation>
    </message>
    <message>
        <source>Number of values for a grid; 0: any value between, for samples and searches</source>
        <translation>Nombre de valeurs pour une grille ; 0 : toute valeur entre les deux, pour échantillons et recherches</translation>
    </message>
    <message>
        <source>OBJ (*.obj)</source>
        <translation>OBJ (*.obj)</translation>
    </message>
    <message>
        <source>OFF as text</source>
        <translation>un fichier OFF en texte</translation>
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
        <source>Objective</source>
        <translation>Objectif</translation>
    </message>
    <message>
        <source>Objectives</source>
        <translation>Objectifs</translation>
    </message>
    <message>
        <source>Observing: another window controls the stylus</source>
        <translation>Observe : une autre fenêtre commande le stylet</translation>
    </message>
    <message>
        <source>Obstacles</source>
        <translation>Obstacles</translation>
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
        <source>Off. No robot is moved.</source>
        <translation>Désactivé. Aucun robot ne bouge.</translation>
    </message>
    <message>
        <source>Off. Nobody can watch.</source>
        <translation>Arrêtée. Personne ne peut regarder.</translation>
    </message>
    <message>
        <source>Off. Nothing is published or received.</source>
        <translation>Désactivé. Rien n'est publié ni reçu.</translation>
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
        <source>On the controller, name the file '%1', like its program.</source>
        <translation>Sur le contrôleur, le fichier doit s'appeler '%1', comme son programme.</translation>
    </message>
    <message>
        <source>On the other station, run hapticell-haptic-server --pair once to see the code, then hapticell-haptic-server --listen with its address.</source>
        <translation>Sur l'autre poste, lancez une fois hapticell-haptic-server --pair pour voir le code, puis hapticell-haptic-server --listen avec son adresse.</translation>
    </message>
    <message>
        <source>On. In Foxglove or Lichtblick, choose Open connection, Foxglove WebSocket, and enter the address below.</source>
        <translation>En marche. Dans Foxglove ou Lichtblick, choisissez Open connection, Foxglove WebSocket, et saisissez l'adresse ci-dessous.</translation>
    </message>
    <message>
        <source>On. Published joint states: %1; programs that read them: %2</source>
        <translation>Activé. États articulaires publiés : %1 ; programmes qui les lisent : %2</translation>
    </message>
    <message>
        <source>On. The robot follows %1, %2 messages a second.</source>
        <translation>Activé. Le robot suit %1, %2 messages par seconde.</translation>
    </message>
    <message>
        <source>On. Viewers watching: %1</source>
        <translation>En marche. Spectateurs : %1</translation>
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
        <source>Only files that can be read as recordings are packed. Remove it from the workcell.</source>
        <translation>Retirez-le de la cellule : seul ce qui est lisible comme enregistrement entre dans une archive.</translation>
    </message>
    <message>
        <source>Only files that can be read as what they are used for are packed. Remove it from the workcell.</source>
        <translation>Retirez-le de la cellule : seul ce qui est lisible selon le type déclaré entre dans une archive.</translation>
    </message>
    <message>
        <source>Only motion group 1 is read.</source>
        <translation>Seul le groupe de mouvement 1 est lu.</translation>
    </message>
    <message>
        <source>Only programs on this machine</source>
        <translation>Seulement les programmes de cette machine</translation>
    </message>
    <message>
        <source>Only the %1 nearest parts of %2 can go first in this answer; the others count as fixed.</source>
        <translation>Seules les %1 pièces les plus proches sur %2 peuvent partir d'abord dans cette réponse ; les autres comptent comme fixes.</translation>
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
        <source>Open a study</source>
        <translation>Ouvrir une étude</translation>
    </message>
    <message>
        <source>Open a study…</source>
        <translation>Ouvrir une étude…</translation>
    </message>
    <message>
        <source>Open a workcell or a recording</source>
        <translation>Ouvrir une cellule ou un enregistrement</translation>
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
        <source>Open it with a newer HaptiCell.</source>
        <translation>Ouvrez-le avec une version plus récente de HaptiCell.</translation>
    </message>
    <message>
        <source>Open its cell</source>
        <translation>Ouvrir sa cellule</translation>
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
        <source>Open results of a study</source>
        <translation>Ouvrir les résultats d'une étude</translation>
    </message>
    <message>
        <source>Open results of a study…</source>
        <translation>Ouvrir les résultats d'une étude…</translation>
    </message>
    <message>
        <source>Open the .src file.</source>
        <translation>Ouvrez le fichier .src.</translation>
    </message>
    <message>
        <source>Open the document with a newer HaptiCell.</source>
        <translation>Ouvrez le document avec une version plus récente de HaptiCell.</translation>
    </message>
    <message>
        <source>Open the file</source>
        <translation>Ouvrir le fichier</translation>
    </message>
    <message>
        <source>Open the folder of scripts</source>
        <translation>Ouvrir le dossier des scripts</translation>
    </message>
    <message>
        <source>Open the study's cell.</source>
        <translation>Ouvrez la cellule de l'étude.</translation>
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
        <source>Or several</source>
        <translation>Ou plusieurs</translation>
    </message>
    <message>
        <source>Order of removal</source>
        <translation>Ordre de démontage</translation>
    </message>
    <message>
        <source>Orient faces outwards</source>
        <translation>Orienter les faces vers l'extérieur</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Orientation</translation>
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
        <source>Others need the code at the end of the address. The connection is not encrypted: whoever can listen to the network can watch.</source>
        <translation>Les autres ont besoin du code à la fin de l'adresse. La connexion n'est pas chiffrée : quiconque écoute le réseau peut regarder.</translation>
    </message>
    <message>
        <source>Others too</source>
        <translation>D'autres aussi</translation>
    </message>
    <message>
        <source>Out of balance by %1</source>
        <translation>Hors d'équilibre de %1</translation>
    </message>
    <message>
        <source>Out of the cell</source>
        <translation>Hors de la cellule</translation>
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
        <source>Overlap of up to %1 counts as touching.</source>
        <translation>Un chevauchement jusqu'à %1 compte comme un contact.</translation>
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
        <source>PROC is missing</source>
        <translation>pas de PROC</translation>
    </message>
    <message>
        <source>P[%1], which has no value</source>
        <translation>P[%1], qui n'a pas de valeur</translation>
    </message>
    <message>
        <source>P[%1], which is not in /POS</source>
        <translation>P[%1], qui n'est pas dans /POS</translation>
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
        <source>Pages (*.pdf);;Web pages (*.html);;Tables (*.csv)</source>
        <translation>Pages (*.pdf);;Pages web (*.html);;Tableaux (*.csv)</translation>
    </message>
    <message>
        <source>Pages of the settings</source>
        <translation>Pages des réglages</translation>
    </message>
    <message>
        <source>Pair again: hapticell-haptic-server --pair shows a code.</source>
        <translation>Refaites l'appairage : hapticell-haptic-server --pair affiche un code.</translation>
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
        <source>Pairs that overlap in the given cell, by up to %1, are checked: %2. If the overlap is intended, exclude them in the cell.</source>
        <translation>Les paires qui se chevauchent dans la cellule donnée, jusqu'à %1, sont vérifiées : %2. Si le chevauchement est voulu, excluez-les dans la cellule.</translation>
    </message>
    <message>
        <source>Pairs that touch in the given cell are not checked: %1</source>
        <translation>Les paires qui se touchent dans la cellule donnée ne sont pas vérifiées : %1</translation>
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
        <source>Parallel</source>
        <translation>Parallèles</translation>
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
        <source>Part to take out</source>
        <translation>Pièce à retirer</translation>
    </message>
    <message>
        <source>Partial scores: %1 not entered. Complete them in Task data…</source>
        <translation>Scores incomplets ; à saisir dans Données de la tâche… : %1.</translation>
    </message>
    <message>
        <source>Partition</source>
        <translation>Partition</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Pièces</translation>
    </message>
    <message>
        <source>Parts are rigid; what holds a part only by friction or a thread holds nothing.</source>
        <translation>Les pièces sont rigides ; ce qui ne tient une pièce que par frottement ou par un filetage ne tient rien.</translation>
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
        <source>Path, seed %1</source>
        <translation>Chemin, graine %1</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Paused.</source>
        <translation>En pause.</translation>
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
        <source>Person</source>
        <translation>Personne</translation>
    </message>
    <message>
        <source>Persons</source>
        <translation>Personnes</translation>
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
        <source>Pick another part.</source>
        <translation>Choisissez-en une autre.</translation>
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
        <source>Pick the moving part and the part that carries it in the scene.</source>
        <translation>Désignez dans la scène la pièce mobile et la pièce qui la porte.</translation>
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
        <source>Pick the point to which it is to go</source>
        <translation>Désignez le point à atteindre</translation>
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
        <source>Plan</source>
        <translation>Planifier</translation>
    </message>
    <message>
        <source>Plan a path</source>
        <translation>Planifier un chemin</translation>
    </message>
    <message>
        <source>Plan a path…</source>
        <translation>Planifier un chemin…</translation>
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
        <source>Planner beside the hand</source>
        <translation>Planificateur à côté de la main</translation>
    </message>
    <message>
        <source>Planning…</source>
        <translation>Planification…</translation>
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
        <source>Please report this bug, with the file that caused it.</source>
        <translation>Signalez ce défaut avec le fichier qui l'a causé.</translation>
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
        <source>Port for viewers. Default: 8765</source>
        <translation>Port pour les spectateurs. Par défaut : 8765</translation>
    </message>
    <message>
        <source>Port of the server. Default: 4747</source>
        <translation>Port du serveur. Par défaut : 4747</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Pose</translation>
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
        <source>Poses are relative to %1, which the file does not define.</source>
        <translation>Les poses sont exprimées dans %1, dont le fichier ne donne pas la pose.</translation>
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
        <source>Postures</source>
        <translation>Postures</translation>
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
        <source>Preparing the cell of the study…</source>
        <translation>Préparation de la cellule de l'étude…</translation>
    </message>
    <message>
        <source>Preparing the cell…</source>
        <translation>Préparation de la cellule…</translation>
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
        <source>Press 'Find topics' to see what other programs publish.</source>
        <translation>Appuyez sur « Chercher les topics » pour voir ce que publient d'autres programmes.</translation>
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
        <source>Press the emergency stop of the robot cell.</source>
        <translation>Appuyez sur l'arrêt d'urgence de la cellule robotisée.</translation>
    </message>
    <message>
        <source>Preview it again and confirm what you see.</source>
        <translation>Affichez de nouveau l'aperçu et confirmez ce que vous voyez.</translation>
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
        <source>Publish</source>
        <translation>Publier</translation>
    </message>
    <message>
        <source>Publish: joints, frames, description and scene of the robot as it moves here. Mirror: the robot here follows the joint states of another program.</source>
        <translation>Publier : articulations, repères, description et scène du robot tel qu'il bouge ici. Miroir : le robot suit ici les états articulaires d'un autre programme.</translation>
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
        <source>Put the package folder next to the file or above it, or add its path to ROS_PACKAGE_PATH.</source>
        <translation>Placez le dossier du paquet à côté du fichier ou au-dessus, ou indiquez son emplacement dans ROS_PACKAGE_PATH.</translation>
    </message>
    <message>
        <source>Python %1, ready</source>
        <translation>Python %1, prêt</translation>
    </message>
    <message>
        <source>Python (*.py);;All files (*)</source>
        <translation>Python (*.py);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Python cannot be started: %1</source>
        <translation>Impossible de démarrer Python : %1</translation>
    </message>
    <message>
        <source>Python console</source>
        <translation>Console Python</translation>
    </message>
    <message>
        <source>Python is not installed. Install the packages python3 and python3-hapticell.</source>
        <translation>Python n’est pas installé. Installez les paquets python3 et python3-hapticell.</translation>
    </message>
    <message>
        <source>Python starts…</source>
        <translation>Python démarre…</translation>
    </message>
    <message>
        <source>Python to run</source>
        <translation>Python à exécuter</translation>
    </message>
    <message>
        <source>Python, with the open cell as “cell”</source>
        <translation>Python, avec la cellule ouverte sous le nom « cell »</translation>
    </message>
    <message>
        <source>Python: %1</source>
        <translation>Python : %1</translation>
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
        <source>RESULTS</source>
        <translation>RESULTS</translation>
    </message>
    <message>
        <source>RIGHT</source>
        <translation>DROITE</translation>
    </message>
    <message>
        <source>ROOT and a name</source>
        <translation>ROOT et un nom</translation>
    </message>
    <message>
        <source>ROOT is missing</source>
        <translation>pas de ROOT</translation>
    </message>
    <message>
        <source>ROS 2</source>
        <translation>ROS 2</translation>
    </message>
    <message>
        <source>ROS 2 JointTrajectory (.yaml)</source>
        <translation>ROS 2 JointTrajectory (.yaml)</translation>
    </message>
    <message>
        <source>ROS_DOMAIN_ID</source>
        <translation>ROS_DOMAIN_ID</translation>
    </message>
    <message>
        <source>RULA</source>
        <translation>RULA</translation>
    </message>
    <message>
        <source>RULA %1, REBA %2.</source>
        <translation>RULA %1, REBA %2.</translation>
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
        <source>Reaches</source>
        <translation>Atteint</translation>
    </message>
    <message>
        <source>Reaching</source>
        <translation>En atteignant</translation>
    </message>
    <message>
        <source>Read it again when no program writes to it.</source>
        <translation>Relisez-le quand aucun programme n'y écrit.</translation>
    </message>
    <message>
        <source>Read the files task-N.log in this folder, then submit again.</source>
        <translation>Lisez les fichiers task-N.log de ce dossier, puis soumettez de nouveau.</translation>
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
        <source>Reading the cell and preparing all shapes…</source>
        <translation>Lecture de la cellule et préparation de toutes les formes…</translation>
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
        <source>Rebuild it for version %1.</source>
        <translation>Recompilez-le avec la version %1.</translation>
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
        <source>Record %1 while you take it out, from where it stands until it is out of the assembly. Then press this button with that motion chosen in the dock Trajectory.</source>
        <translation>Enregistrez %1 pendant que vous la retirez, de sa place jusqu'à la sortie de l'assemblage. Choisissez ensuite ce mouvement dans le panneau Trajectoire et appuyez sur ce bouton.</translation>
    </message>
    <message>
        <source>Record actions</source>
        <translation>Enregistrer les actions</translation>
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
        <source>Remark</source>
        <translation>Remarque</translation>
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
        <source>Remove it, or make it yours with chown.</source>
        <translation>Supprimez-le, ou appropriez-le-vous avec chown.</translation>
    </message>
    <message>
        <source>Remove the joint that closes the cycle.</source>
        <translation>Retirez l'axe qui ferme le cycle.</translation>
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
        <source>Remove the write protection, or choose another name.</source>
        <translation>Autorisez l'écriture ou choisissez un autre nom.</translation>
    </message>
    <message>
        <source>Remove this agent from the task.</source>
        <translation>Retirez cet agent de la tâche.</translation>
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
        <source>Rename one of them.</source>
        <translation>Renommez l'un d'eux.</translation>
    </message>
    <message>
        <source>Rename the joint in the program that wrote the file.</source>
        <translation>Renommez l'articulation dans le logiciel qui a écrit le fichier.</translation>
    </message>
    <message>
        <source>Repetition</source>
        <translation>Répétition</translation>
    </message>
    <message>
        <source>Replace the entities by their text.</source>
        <translation>Écrivez en toutes lettres le texte qu'elles représentent.</translation>
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
        <source>Requirement</source>
        <translation>Exigence</translation>
    </message>
    <message>
        <source>Requirements</source>
        <translation>Exigences</translation>
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
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Result on the horizontal axis</source>
        <translation>Résultat en abscisse</translation>
    </message>
    <message>
        <source>Result on the vertical axis</source>
        <translation>Résultat en ordonnée</translation>
    </message>
    <message>
        <source>Result shown as colour in map and lines</source>
        <translation>Résultat qui colore carte et tracés</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Résultats</translation>
    </message>
    <message>
        <source>Results of studies (*.hresults)</source>
        <translation>Résultats d'études (*.hresults)</translation>
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
        <source>Returns</source>
        <translation>Revient</translation>
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
        <source>Robot model</source>
        <translation>Modèle de robot</translation>
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
        <source>Robots (*.urdf)</source>
        <translation>Robots (*.urdf)</translation>
    </message>
    <message>
        <source>Room for a glove</source>
        <translation>Place pour un gant</translation>
    </message>
    <message>
        <source>Room for a glove: %1 around the hand. The part weighs %2 kg.</source>
        <translation>Place pour un gant : %1 autour de la main. La pièce pèse %2 kg.</translation>
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
        <source>Run a script</source>
        <translation>Exécuter un script</translation>
    </message>
    <message>
        <source>Run a script…</source>
        <translation>Exécuter un script…</translation>
    </message>
    <message>
        <source>Run ros2 topic echo again with --full-length (-f).</source>
        <translation>Relancez ros2 topic echo avec --full-length (-f).</translation>
    </message>
    <message>
        <source>Run the same command again to continue.</source>
        <translation>Relancez la même commande pour continuer.</translation>
    </message>
    <message>
        <source>Run the study again: the row was changed, or made by another kind of processor.</source>
        <translation>Relancez l'étude : la ligne a été modifiée, ou produite par un autre type de processeur.</translation>
    </message>
    <message>
        <source>Running…</source>
        <translation>En cours…</translation>
    </message>
    <message>
        <source>Runs: %1, the last with %2 points</source>
        <translation>Essais : %1, le dernier avec %2 points</translation>
    </message>
    <message>
        <source>SDF</source>
        <translation>SDF</translation>
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
        <source>Save as study…</source>
        <translation>Enregistrer comme étude…</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Enregistrer sous…</translation>
    </message>
    <message>
        <source>Save it again as UTF-8 or ASCII.</source>
        <translation>Enregistrez-le à nouveau en UTF-8 ou en ASCII.</translation>
    </message>
    <message>
        <source>Save it as a file or a robot program</source>
        <translation>L'enregistrer comme fichier ou programme de robot</translation>
    </message>
    <message>
        <source>Save it as plain text (UTF-8).</source>
        <translation>Enregistrez-le en texte brut (UTF-8).</translation>
    </message>
    <message>
        <source>Save it as text on the controller (FANUC: .ls, not .tp).</source>
        <translation>Enregistrez-le en texte sur le contrôleur (FANUC : .ls, et non .tp).</translation>
    </message>
    <message>
        <source>Save it as text or as PLY.</source>
        <translation>Enregistrez-le en texte ou en PLY.</translation>
    </message>
    <message>
        <source>Save it to another disk.</source>
        <translation>Écrivez-le sur un autre disque.</translation>
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
        <source>Save the changes of &quot;%1&quot;?</source>
        <translation>Enregistrer les modifications de « %1 » ?</translation>
    </message>
    <message>
        <source>Save the description as a URDF file, and add the robot to the cell</source>
        <translation>Enregistrer la description dans un fichier URDF et ajouter le robot à la cellule</translation>
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
        <source>Save the robot's description</source>
        <translation>Enregistrer la description du robot</translation>
    </message>
    <message>
        <source>Save the study</source>
        <translation>Enregistrer l'étude</translation>
    </message>
    <message>
        <source>Save the wishes of the agents</source>
        <translation>Enregistrer les souhaits des agents</translation>
    </message>
    <message>
        <source>Save the wishes…</source>
        <translation>Enregistrer les souhaits…</translation>
    </message>
    <message>
        <source>Save the workcell</source>
        <translation>Enregistrer la cellule</translation>
    </message>
    <message>
        <source>Save the workcell first</source>
        <translation>Enregistrez d'abord la cellule</translation>
    </message>
    <message>
        <source>Save the workcell first: a study names its file.</source>
        <translation>Enregistrez d'abord la cellule : une étude nomme son fichier.</translation>
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
        <source>Save this workcell, then open %1.</source>
        <translation>Enregistrez cette cellule, puis ouvrez %1.</translation>
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
        <source>Scatter</source>
        <translation>Nuage</translation>
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
        <source>Script %1</source>
        <translation>Script %1</translation>
    </message>
    <message>
        <source>Script of the job</source>
        <translation>Script de la tâche</translation>
    </message>
    <message>
        <source>Scripts</source>
        <translation>Scripts</translation>
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
        <source>Search for the best</source>
        <translation>Recherche du meilleur</translation>
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
        <source>See docs/library/drivers.md, or remove the file.</source>
        <translation>Consultez docs/library/drivers.md, ou supprimez le fichier.</translation>
    </message>
    <message>
        <source>See hapticell-cli COMMAND --help.</source>
        <translation>Voyez hapticell-cli COMMAND --help.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Sees</source>
        <translation>Voit</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Choisir</translation>
    </message>
    <message>
        <source>Select a bench, a shelf or a fixture; with several mannequins in the cell, also the one that shows the work. Then add the workplace again.</source>
        <translation>Sélectionnez un établi, une étagère ou un posage ; s'il y a plusieurs mannequins dans la cellule, aussi celui qui montre le travail. Puis ajoutez de nouveau le poste.</translation>
    </message>
    <message>
        <source>Select a part in the scene, then press Use selection.</source>
        <translation>Sélectionnez une pièce dans la scène, puis appuyez sur Utiliser la sélection.</translation>
    </message>
    <message>
        <source>Select a robot, a mannequin or a solid that shall move.</source>
        <translation>Sélectionnez un robot, un mannequin ou un solide à déplacer.</translation>
    </message>
    <message>
        <source>Select a robot, a mannequin or a solid, and let it be moved.</source>
        <translation>Sélectionnez un robot, un mannequin ou un solide, et faites-le déplacer.</translation>
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
        <source>Select one of them.</source>
        <translation>Choisissez l'un d'eux.</translation>
    </message>
    <message>
        <source>Select or hold an entity to see what it is checked against.</source>
        <translation>Choisissez ou tenez une entité pour voir contre quoi elle est vérifiée.</translation>
    </message>
    <message>
        <source>Select the parts that can move</source>
        <translation>Sélectionnez les pièces qui peuvent bouger</translation>
    </message>
    <message>
        <source>Select the parts that can move, and the mannequin if there are several.</source>
        <translation>Sélectionnez les pièces qui peuvent bouger, et le mannequin s'il y en a plusieurs.</translation>
    </message>
    <message>
        <source>Select what blocks</source>
        <translation>Sélectionner ce qui bloque</translation>
    </message>
    <message>
        <source>Selected: %1, at X %2, Y %3, Z %4.</source>
        <translation>Choisi : %1, en X %2, Y %3, Z %4.</translation>
    </message>
    <message>
        <source>Selects the part and guides it softly along the way while you hold it</source>
        <translation>Sélectionne la pièce et la guide doucement le long du trajet pendant que vous la tenez</translation>
    </message>
    <message>
        <source>Send a motion to a real robot</source>
        <translation>Envoyer un mouvement à un robot réel</translation>
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
        <source>Set HAPTICELL_CONFIG_DIR to the folder that holds hapticell.toml.</source>
        <translation>Donnez à HAPTICELL_CONFIG_DIR le dossier qui contient hapticell.toml.</translation>
    </message>
    <message>
        <source>Set HOME or %1. The current folder is not searched.</source>
        <translation>Définissez HOME ou %1. Rien n'est cherché dans le dossier courant.</translation>
    </message>
    <message>
        <source>Set HOME. The current folder is not searched.</source>
        <translation>Définissez HOME. Rien n'est cherché dans le dossier courant.</translation>
    </message>
    <message>
        <source>Set for this pair; click to change it</source>
        <translation>Choisi pour cette paire ; cliquez pour changer</translation>
    </message>
    <message>
        <source>Set it before you start the program.</source>
        <translation>Définissez-la avant de démarrer le programme.</translation>
    </message>
    <message>
        <source>Set it with %1:=VALUE.</source>
        <translation>Définissez-le par %1:=VALUE.</translation>
    </message>
    <message>
        <source>Set start values nearer to an assembled pose.</source>
        <translation>Indiquez des valeurs de départ plus proches d'une pose assemblée.</translation>
    </message>
    <message>
        <source>Set the goal, then start.</source>
        <translation>Fixez le but, puis démarrez.</translation>
    </message>
    <message>
        <source>Set the range first, with the brackets that are now in the time bar.</source>
        <translation>Réglez d'abord la plage, par les crochets affichés dans la barre de temps.</translation>
    </message>
    <message>
        <source>Set the robot of the cell to the received joints, as one undo step</source>
        <translation>Placer le robot de la cellule aux articulations reçues, en une étape annulable</translation>
    </message>
    <message>
        <source>Set the robot of these joints (--robot), so that the poses can be computed.</source>
        <translation>Nommez le robot auquel appartiennent ces axes (--robot) : sa cinématique directe donne les poses.</translation>
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
        <source>Shift-JIS (Japanese)</source>
        <translation>Shift-JIS (japonais)</translation>
    </message>
    <message>
        <source>Should be</source>
        <translation>Doit être</translation>
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
        <source>Show by hand instead</source>
        <translation>Montrer plutôt à la main</translation>
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
        <source>Show the cell</source>
        <translation>Montrer la cellule</translation>
    </message>
    <message>
        <source>Show the cell as it is in the document again</source>
        <translation>Montrer de nouveau la cellule telle qu'elle est dans le document</translation>
    </message>
    <message>
        <source>Show the motion in the scene; off: show the cell</source>
        <translation>Montrer le mouvement dans la scène ; arrêt : la cellule</translation>
    </message>
    <message>
        <source>Show the script</source>
        <translation>Montrer le script</translation>
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
        <source>Sight</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Sigma</source>
        <translation>Sigma</translation>
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
        <source>Simplify or split the motion.</source>
        <translation>Simplifiez d'abord le mouvement, ou coupez-le.</translation>
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
        <source>Size of a part</source>
        <translation>Dimension d'une pièce</translation>
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
        <source>Slurm</source>
        <translation>Slurm</translation>
    </message>
    <message>
        <source>Slurm's commands in PATH</source>
        <translation>les commandes de Slurm dans PATH</translation>
    </message>
    <message>
        <source>Small</source>
        <translation>Petit</translation>
    </message>
    <message>
        <source>Small woman to tall man</source>
        <translation>Petite femme à grand homme</translation>
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
        <source>Sobol samples</source>
        <translation>Échantillons de Sobol</translation>
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
        <source>Split the model, or export it again.</source>
        <translation>Divisez le modèle, ou exportez-le à nouveau.</translation>
    </message>
    <message>
        <source>Squatting</source>
        <translation>Accroupi</translation>
    </message>
    <message>
        <source>Stance</source>
        <translation>Station</translation>
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
        <source>Start it again.</source>
        <translation>Relancez-la.</translation>
    </message>
    <message>
        <source>Start it on a desktop or with xvfb-run.</source>
        <translation>Lancez-le sur un bureau, ou sous xvfb-run s'il n'y en a pas.</translation>
    </message>
    <message>
        <source>Start it, compare the name with 'ros2 action list', or use a longer --wait.</source>
        <translation>Démarrez-le, comparez le nom avec « ros2 action list », ou donnez un --wait plus long.</translation>
    </message>
    <message>
        <source>Start its driver, or name its topic by --joint-topic.</source>
        <translation>Démarrez son pilote, ou nommez son topic par --joint-topic.</translation>
    </message>
    <message>
        <source>Start one with 'hapticell-haptic-server', or open the window.</source>
        <translation>Lancez-en un avec « hapticell-haptic-server », ou ouvrez la fenêtre.</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>Page d'accueil</translation>
    </message>
    <message>
        <source>Start planner</source>
        <translation>Démarrer le planificateur</translation>
    </message>
    <message>
        <source>Start the controller, or use a longer --wait.</source>
        <translation>Démarrez le contrôleur, ou donnez un --wait plus long.</translation>
    </message>
    <message>
        <source>Start the link</source>
        <translation>Démarrer la liaison</translation>
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
        <source>Starting…</source>
        <translation>Démarrage…</translation>
    </message>
    <message>
        <source>Starts</source>
        <translation>Départs</translation>
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
        <source>Stop now</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Stop planner</source>
        <translation>Arrêter le planificateur</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Arrêter l’enregistrement</translation>
    </message>
    <message>
        <source>Stop recording  (R)</source>
        <translation>Arrêter l'enregistrement  (R)</translation>
    </message>
    <message>
        <source>Stop the link</source>
        <translation>Arrêter la liaison</translation>
    </message>
    <message>
        <source>Stop the robot</source>
        <translation>Arrêter le robot</translation>
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
        <source>Stopped; the rows so far are kept. Run continues.</source>
        <translation>Arrêtée ; les lignes faites sont gardées. Lancer continue.</translation>
    </message>
    <message>
        <source>Stopping after the variants that are being evaluated…</source>
        <translation>Arrêt après les variantes en cours d'évaluation…</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>Butées</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Études</translation>
    </message>
    <message>
        <source>Studies (*.hstudy)</source>
        <translation>Études (*.hstudy)</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Étude</translation>
    </message>
    <message>
        <source>Study results</source>
        <translation>Résultats d'étude</translation>
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
        <source>Submit</source>
        <translation>Soumettre</translation>
    </message>
    <message>
        <source>Submit again: only the chunks that are missing then are submitted.</source>
        <translation>Soumettez de nouveau : seules les parts qui manquent alors sont soumises.</translation>
    </message>
    <message>
        <source>Submitting…</source>
        <translation>Soumission…</translation>
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
        <source>Swap the two limits.</source>
        <translation>Échangez les deux.</translation>
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
        <source>TOML</source>
        <translation>du TOML</translation>
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
        <source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation>
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
        <source>Take %1: a soft tube leads it along the way, and neighbours are felt. Lay earlier parts aside first.</source>
        <translation>Prenez %1 : un tube souple la guide le long du trajet, et les voisines se sentent. Posez d'abord à côté les pièces précédentes.</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>Prendre le contrôle</translation>
    </message>
    <message>
        <source>Take over by hand</source>
        <translation>Reprendre à la main</translation>
    </message>
    <message>
        <source>Take where it is now</source>
        <translation>Reprendre la place actuelle</translation>
    </message>
    <message>
        <source>Taking the stylus.</source>
        <translation>Prise du stylet.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Cible</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Cibles</translation>
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
        <source>The %1 of %6, %2 %3, is rounded to %4 %3, because %5 allows no more digits.</source>
        <translation>%1, %6 : %2 %3 est arrondi à %4 %3, car %5 n'a pas plus de chiffres.</translation>
    </message>
    <message>
        <source>The %1, %2 %3, is rounded to %4 %3, because %5 allows no more digits.</source>
        <translation>%1 : %2 %3 est arrondi à %4 %3, car %5 n'a pas plus de chiffres.</translation>
    </message>
    <message>
        <source>The 3D mouse moves the view</source>
        <translation>La souris 3D déplace la vue</translation>
    </message>
    <message>
        <source>The Python package of HaptiCell cannot be used: %1. Install the package python3-hapticell.</source>
        <translation>Le paquet Python de HaptiCell ne peut pas être utilisé : %1. Installez le paquet python3-hapticell.</translation>
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
        <source>The agents follow the way that the planner found.</source>
        <translation>Les agents suivent le chemin trouvé par le planificateur.</translation>
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
        <source>The body measures are of adults; outside this range, the regressions are not valid.</source>
        <translation>Restez dans cette plage : les mesures sont celles d'adultes ; au-delà, les régressions n'ont pas de sens.</translation>
    </message>
    <message>
        <source>The cell already stands in variant %1</source>
        <translation>La cellule est déjà dans la variante %1</translation>
    </message>
    <message>
        <source>The cell differs from the one that was studied</source>
        <translation>La cellule diffère de celle qui a été étudiée</translation>
    </message>
    <message>
        <source>The cell has changed since then. Ask again.</source>
        <translation>La cellule a changé depuis. Relancez la recherche.</translation>
    </message>
    <message>
        <source>The cell has changed: search again.</source>
        <translation>La cellule a changé : relancez la recherche.</translation>
    </message>
    <message>
        <source>The cell has no frames that the path could pass.</source>
        <translation>La cellule n'a aucun repère par lequel le chemin pourrait passer.</translation>
    </message>
    <message>
        <source>The cell has no kept motion. Record one, or import it.</source>
        <translation>La cellule n'a aucun mouvement conservé. Enregistrez-en un ou importez-le.</translation>
    </message>
    <message>
        <source>The cell has no robot.</source>
        <translation>La cellule n'a pas de robot.</translation>
    </message>
    <message>
        <source>The cell is as it was; names that you had set are gone. A new one starts.</source>
        <translation>La cellule est inchangée ; les noms que vous aviez définis sont perdus. Un nouvel interpréteur démarre.</translation>
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
        <source>The cell was changed in the window while Python ran, so what Python changed is not taken. Run it again.</source>
        <translation>La cellule a été modifiée dans la fenêtre pendant l’exécution de Python, ce que Python a modifié n’est donc pas repris. Exécutez-le de nouveau.</translation>
    </message>
    <message>
        <source>The cell was changed or saved, so the run was cancelled. The part is back in its place.</source>
        <translation>La cellule a été modifiée ou enregistrée : l'essai est annulé. La pièce est revenue à sa place.</translation>
    </message>
    <message>
        <source>The connection was lost before the end; what was received is written.</source>
        <translation>La connexion a été perdue avant la fin ; ce qui a été reçu est écrit.</translation>
    </message>
    <message>
        <source>The controller refused the motion.</source>
        <translation>Le contrôleur a refusé le mouvement.</translation>
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
        <source>The disk returned other data than was written. Pack again, or pack to another disk.</source>
        <translation>Archivez de nouveau, ou ailleurs : ce qui a été relu sur le disque n'est pas ce qui y a été écrit.</translation>
    </message>
    <message>
        <source>The displayed mesh.</source>
        <translation>Le maillage affiché.</translation>
    </message>
    <message>
        <source>The dock Trajectory plays it: %1.</source>
        <translation>Le panneau Trajectoire le joue : %1.</translation>
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
        <source>The eyes are to see %1.</source>
        <translation>Les yeux doivent voir %1.</translation>
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
        <source>The file has %1; parts made from it can be missing or wrong. Export the file again.</source>
        <translation>Le fichier a %1 ; des pièces qui en dépendent peuvent manquer ou être fausses. Exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>The file is being read</source>
        <translation>Le fichier est en lecture</translation>
    </message>
    <message>
        <source>The file is damaged: export it again.</source>
        <translation>Le fichier est endommagé : exportez-le à nouveau.</translation>
    </message>
    <message>
        <source>The file is incomplete: copy or export it again.</source>
        <translation>Le fichier est incomplet : copiez-le ou exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>The file is incomplete: export it again, or correct the number after Frames:.</source>
        <translation>Écrivez de nouveau le fichier, car il est tronqué, ou corrigez le nombre après Frames:.</translation>
    </message>
    <message>
        <source>The file is truncated: export it again.</source>
        <translation>Le fichier est tronqué : exportez-le à nouveau.</translation>
    </message>
    <message>
        <source>The file may have changed during packing. Pack again.</source>
        <translation>Archivez de nouveau : le fichier a peut-être été modifié pendant l'archivage.</translation>
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
        <source>The file was written by a newer HaptiCell: open it there and export it as CSV.</source>
        <translation>Ouvrez le fichier avec le HaptiCell plus récent qui l'a écrit, et exportez-le en CSV.</translation>
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
        <source>The force loop runs without real-time priority (SCHED_FIFO %1: %2), so ticks are late when the computer is busy. To allow it: %3</source>
        <translation>La boucle de force tourne sans priorité temps réel (SCHED_FIFO %1 : %2) : des cycles sont en retard quand la machine est chargée. Pour l'autoriser : %3</translation>
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
        <source>The guide is set. Start the Virtual Desktop to feel it.</source>
        <translation>Le guide est en place. Démarrez le bureau virtuel pour le sentir.</translation>
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
        <source>The held entity, or the one chosen above, should go to the goal in the list</source>
        <translation>L'entité tenue, ou celle choisie plus haut, doit aller au but de la liste</translation>
    </message>
    <message>
        <source>The inner radius must be smaller than the outer one</source>
        <translation>Le rayon intérieur doit être plus petit que le rayon extérieur</translation>
    </message>
    <message>
        <source>The interpreter crashed.</source>
        <translation>L’interpréteur s’est arrêté sur une erreur fatale.</translation>
    </message>
    <message>
        <source>The interpreter ended (exit status %1).</source>
        <translation>L’interpréteur s’est terminé (code de sortie %1).</translation>
    </message>
    <message>
        <source>The interpreter was ended, because what ran did not heed the interrupt.</source>
        <translation>L’interpréteur a été terminé, car ce qui s’exécutait n’a pas réagi à l’interruption.</translation>
    </message>
    <message>
        <source>The job has ended; its results are merged.</source>
        <translation>La tâche est terminée ; ses résultats sont réunis.</translation>
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
        <source>The link to ROS 2 could not be started: %1 was not found or cannot be run.</source>
        <translation>La liaison avec ROS 2 n'a pas pu démarrer : %1 est introuvable ou ne peut pas être exécuté.</translation>
    </message>
    <message>
        <source>The link to ROS 2 stopped unexpectedly. Start it again.</source>
        <translation>La liaison avec ROS 2 s'est arrêtée de façon inattendue. Redémarrez-la.</translation>
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
        <source>The meshes are read from the places that the description names.</source>
        <translation>Les maillages sont lus aux endroits que nomme la description.</translation>
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
        <source>The motion is slowed %1 times.</source>
        <translation>Le mouvement est ralenti %1 fois.</translation>
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
        <source>The nearest free place is %1 mm from the goal, at %2; %3; %4 mm.</source>
        <translation>La place libre la plus proche est à %1 mm du but, en %2 ; %3 ; %4 mm.</translation>
    </message>
    <message>
        <source>The newest message also appears in the status bar for 8 seconds.</source>
        <translation>Le plus récent apparaît aussi 8 secondes dans la ligne d'état.</translation>
    </message>
    <message>
        <source>The panel was not opened</source>
        <translation>Le panneau n'a pas été ouvert</translation>
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
        <source>The planner finds no way: %1. Lead it by hand, or change the weights.</source>
        <translation>Le planificateur ne trouve pas de chemin : %1. Menez à la main, ou changez les poids.</translation>
    </message>
    <message>
        <source>The planner looks for a way.</source>
        <translation>Le planificateur cherche un chemin.</translation>
    </message>
    <message>
        <source>The planner looks for a way…</source>
        <translation>Le planificateur cherche un chemin…</translation>
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
        <source>The program is named '%1', because '%2' is a reserved word of %3.</source>
        <translation>Le programme s'appelle '%1' : '%2' est un mot réservé de %3.</translation>
    </message>
    <message>
        <source>The program is named '%1', because '%2' is not a valid name in %3 (letters, digits and _, a letter first, at most %4 characters).</source>
        <translation>Le programme s'appelle '%1' : '%2' n'est pas un nom de %3 (lettres, chiffres et _, une lettre d'abord, %4 caractères au plus).</translation>
    </message>
    <message>
        <source>The program runs on without a log file.</source>
        <translation>Le programme continue sans fichier journal.</translation>
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
        <source>The real robot '%1' will move for %2 s, its tool at up to %3 mm/s, and its fastest joint at up to %4 % of its limit.</source>
        <translation>Le robot réel '%1' bougera pendant %2 s, son outil jusqu'à %3 mm/s et son articulation la plus rapide jusqu'à %4 % de sa limite.</translation>
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
        <source>The results could not be exported</source>
        <translation>Les résultats n'ont pas pu être exportés</translation>
    </message>
    <message>
        <source>The results could not be opened</source>
        <translation>Les résultats n'ont pas pu être ouverts</translation>
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
        <source>The robot finished the motion.</source>
        <translation>Le robot a terminé le mouvement.</translation>
    </message>
    <message>
        <source>The robot has no six-axis configuration. The configuration data are the format's defaults.</source>
        <translation>Le robot n'a pas de configuration à six axes ; les données de configuration sont celles par défaut du format.</translation>
    </message>
    <message>
        <source>The robot moves: %1 s</source>
        <translation>Le robot bouge : %1 s</translation>
    </message>
    <message>
        <source>The robot stopped before the end of the motion: %1</source>
        <translation>Le robot s'est arrêté avant la fin du mouvement : %1</translation>
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
        <source>The scripts are in %1.</source>
        <translation>Les scripts sont dans %1.</translation>
    </message>
    <message>
        <source>The second stylus was disconnected. Choose it again to start it.</source>
        <translation>Le second stylet s'est déconnecté. Choisissez-le de nouveau pour le démarrer.</translation>
    </message>
    <message>
        <source>The selected part or robot may stand anywhere in a rectangle; drag its handles in the scene</source>
        <translation>La pièce ou le robot sélectionné peut se trouver partout dans un rectangle ; tirez ses poignées dans la scène</translation>
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
        <source>The shipped hapticell.toml lists all keys.</source>
        <translation>Toutes les clés figurent dans le hapticell.toml livré.</translation>
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
        <source>The study could not be opened</source>
        <translation>L'étude n'a pas pu être ouverte</translation>
    </message>
    <message>
        <source>The study could not be run</source>
        <translation>L'étude n'a pas pu être exécutée</translation>
    </message>
    <message>
        <source>The study could not be saved</source>
        <translation>L'étude n'a pas pu être enregistrée</translation>
    </message>
    <message>
        <source>The study is about %1, not about the open workcell.</source>
        <translation>L'étude porte sur %1, pas sur la cellule ouverte.</translation>
    </message>
    <message>
        <source>The study is open, its workcell is not</source>
        <translation>L'étude est ouverte, mais pas sa cellule</translation>
    </message>
    <message>
        <source>The study was not changed</source>
        <translation>L'étude n'a pas été modifiée</translation>
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
        <source>The stylus leads, too</source>
        <translation>Le stylet mène aussi</translation>
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
        <source>The wishes were not saved</source>
        <translation>Les souhaits n’ont pas été enregistrés</translation>
    </message>
    <message>
        <source>The workcell has changes that are not saved, and the study reads its file. Save the workcell first.</source>
        <translation>La cellule a des modifications non enregistrées, et l'étude lit son fichier. Enregistrez d'abord la cellule.</translation>
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
        <source>There is no PROC main() with moves: '%1', the first with moves, is read.</source>
        <translation>Il n'y a pas de PROC main() avec des mouvements : '%1', la première qui en a, est lue.</translation>
    </message>
    <message>
        <source>There is no PROC main() with moves: '%1', the first with moves, is read. Procedures that it does not call are not read: %2.</source>
        <translation>Il n'y a pas de PROC main() avec des mouvements : '%1', la première qui en a, est lue ; ne sont lues que si elle les appelle : %2.</translation>
    </message>
    <message>
        <source>There is no file to read again</source>
        <translation>Il n'y a aucun fichier à relire</translation>
    </message>
    <message>
        <source>There is no frame '%1' to move along; the cell's axes are used</source>
        <translation>Il n'y a pas de repère « %1 » à suivre ; les axes de la cellule sont utilisés</translation>
    </message>
    <message>
        <source>There is no log file</source>
        <translation>Il n'y a pas de fichier journal</translation>
    </message>
    <message>
        <source>There is no mannequin in the cell. Add one, and give its hands what they reach for.</source>
        <translation>Il n'y a pas de mannequin dans la cellule. Ajoutez-en un et donnez à ses mains ce qu'elles doivent atteindre.</translation>
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
        <source>There is nothing to follow</source>
        <translation>Il n'y a rien à suivre</translation>
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
        <source>These frames are the targets</source>
        <translation>Ces repères sont les cibles</translation>
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
        <source>This is a bug of the agents. Please report it.</source>
        <translation>C'est une erreur des agents. Merci de la signaler.</translation>
    </message>
    <message>
        <source>This is a bug. Please report it.</source>
        <translation>Signalez cette erreur du programme, s'il vous plaît.</translation>
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
        <source>This machine</source>
        <translation>Cette machine</translation>
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
        <source>This variant cannot be shown</source>
        <translation>Cette variante ne peut pas être montrée</translation>
    </message>
    <message>
        <source>This variant cannot be used</source>
        <translation>Cette variante ne peut pas être utilisée</translation>
    </message>
    <message>
        <source>Through</source>
        <translation>Par</translation>
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
        <source>Time limit</source>
        <translation>Durée max.</translation>
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
        <source>Time to speed</source>
        <translation>Accélération</translation>
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
        <source>To have the file expanded, rename it to *.xacro.</source>
        <translation>Donnez au fichier l'extension .xacro pour qu'il soit développé.</translation>
    </message>
    <message>
        <source>To list all 56 joints, run hapticell-cli mannequin.</source>
        <translation>Pour afficher les 56 articulations, lancez hapticell-cli mannequin.</translation>
    </message>
    <message>
        <source>To list the connected devices, run hapticell-cli devices.</source>
        <translation>Lancez hapticell-cli devices pour voir ce qui est branché.</translation>
    </message>
    <message>
        <source>To list the library robots, run hapticell-cli library.</source>
        <translation>Affichez-en la liste par hapticell-cli library.</translation>
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
        <source>Tool diameter</source>
        <translation>Diamètre de l'outil</translation>
    </message>
    <message>
        <source>Tool length</source>
        <translation>Longueur de l'outil</translation>
    </message>
    <message>
        <source>Tool offset</source>
        <translation>Décalage de l'outil</translation>
    </message>
    <message>
        <source>Tool speed</source>
        <translation>Vitesse outil</translation>
    </message>
    <message>
        <source>Tool turns</source>
        <translation>Tours outil</translation>
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
        <source>Topic of the joint states that the robot here follows. Default: /joint_states</source>
        <translation>Topic des états articulaires que suit le robot d'ici. Par défaut : /joint_states</translation>
    </message>
    <message>
        <source>Topic on which another program publishes the robot as URDF. Default: /robot_description</source>
        <translation>Topic sur lequel un autre programme publie le robot en URDF. Par défaut : /robot_description</translation>
    </message>
    <message>
        <source>Topics of other programs</source>
        <translation>Topics des autres programmes</translation>
    </message>
    <message>
        <source>Topics of other programs (publishers → subscribers)</source>
        <translation>Topics des autres programmes (éditeurs → abonnés)</translation>
    </message>
    <message>
        <source>Topics: %1</source>
        <translation>Topics : %1</translation>
    </message>
    <message>
        <source>Touch something with forces on to measure the delay from felt to displayed</source>
        <translation>Touchez quelque chose, efforts en marche, pour mesurer le délai entre ressenti et affichage</translation>
    </message>
    <message>
        <source>Touches at rest</source>
        <translation>Contact au repos</translation>
    </message>
    <message>
        <source>Touchpad</source>
        <translation>Pavé tactile</translation>
    </message>
    <message>
        <source>Towards this goal</source>
        <translation>Vers ce but</translation>
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
        <source>Trainees watch the cell, the contacts and the force in a browser, with Foxglove or Lichtblick.</source>
        <translation>Les stagiaires voient la cellule, les contacts et la force dans un navigateur, avec Foxglove ou Lichtblick.</translation>
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
        <source>Trajectories (*.htraj *.json *.csv *.yaml *.yml);;Recordings (*.mcap);;Robot programs: KRL, RAPID, FANUC, URScript, INFORM (*.src *.mod *.modx *.prg *.ls *.script *.urscript *.jbi)</source>
        <translation>Trajectoires (*.htraj *.json *.csv *.yaml *.yml);;Enregistrements (*.mcap);;Programmes de robots : KRL, RAPID, FANUC, URScript, INFORM (*.src *.mod *.modx *.prg *.ls *.script *.urscript *.jbi)</translation>
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
        <source>True or False</source>
        <translation>True ou False</translation>
    </message>
    <message>
        <source>Trunk</source>
        <translation>Tronc</translation>
    </message>
    <message>
        <source>Try again.</source>
        <translation>Réessayez.</translation>
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
        <source>Turn forces on to feel it.</source>
        <translation>Activez les forces pour le ressentir.</translation>
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
        <source>Two results of all variants</source>
        <translation>Deux résultats de toutes les variantes</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Type the code again.</source>
        <translation>Retapez le code.</translation>
    </message>
    <message>
        <source>Type the code that hapticell-haptic-server --pair shows.</source>
        <translation>Saisissez ce que montre hapticell-haptic-server --pair.</translation>
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
        <source>URDF cannot describe closed loops: remove one of the joints, and close the loop in a robot.toml (docs/user/formats.md).</source>
        <translation>Retirez l'un des axes et fermez la boucle par un robot.toml (docs/user/formats.md) : l'URDF ne peut pas décrire de boucles fermées.</translation>
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
        <source>UTF-16 text</source>
        <translation>un texte UTF-16</translation>
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
        <source>Unlock it first.</source>
        <translation>Déverrouillez-la d'abord.</translation>
    </message>
    <message>
        <source>Unlock it in the tree or in its properties.</source>
        <translation>Déverrouillez-la dans l'arbre ou dans ses propriétés.</translation>
    </message>
    <message>
        <source>Unlock it, or ask for another part.</source>
        <translation>Déverrouillez-le, ou demandez une autre pièce.</translation>
    </message>
    <message>
        <source>Unpack it, or export it again.</source>
        <translation>Décompressez-le, ou exportez-le à nouveau.</translation>
    </message>
    <message>
        <source>Unpack it, or export it as .step.</source>
        <translation>Décompressez-le, ou exportez-le en .step.</translation>
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
        <source>Up</source>
        <translation>Monter</translation>
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
        <source>Use --markers TABLE to assign the markers (docs/user/formats.md).</source>
        <translation>Indiquez avec --markers TABLE où se trouve chaque marqueur (docs/user/formats.md).</translation>
    </message>
    <message>
        <source>Use a larger --simplify.</source>
        <translation>Prenez une valeur de --simplify plus grande.</translation>
    </message>
    <message>
        <source>Use a larger tolerance, or move the motion into the reach of the robot.</source>
        <translation>Augmentez la tolérance, ou déplacez le mouvement à la portée du robot.</translation>
    </message>
    <message>
        <source>Use a larger tolerance.</source>
        <translation>Augmentez la tolérance.</translation>
    </message>
    <message>
        <source>Use a longer step or a higher speed.</source>
        <translation>Prenez un pas plus long, ou une vitesse plus élevée.</translation>
    </message>
    <message>
        <source>Use a newer HaptiCell.</source>
        <translation>Utilisez un HaptiCell plus récent.</translation>
    </message>
    <message>
        <source>Use a shorter --sample, a larger --tolerance or other limits.</source>
        <translation>Réduisez --sample, augmentez --tolerance ou changez les limites.</translation>
    </message>
    <message>
        <source>Use a smaller or coarser model.</source>
        <translation>Utilisez un modèle plus petit ou plus grossier.</translation>
    </message>
    <message>
        <source>Use another file extension.</source>
        <translation>Donnez au fichier une autre extension.</translation>
    </message>
    <message>
        <source>Use constant-speed timing.</source>
        <translation>Utilisez le calcul à vitesse constante.</translation>
    </message>
    <message>
        <source>Use its absolute path.</source>
        <translation>Indiquez son chemin absolu.</translation>
    </message>
    <message>
        <source>Use selection</source>
        <translation>Utiliser la sélection</translation>
    </message>
    <message>
        <source>Use single keys without Ctrl</source>
        <translation>Utiliser les touches seules, sans Ctrl</translation>
    </message>
    <message>
        <source>Use the same version for all rows, or choose another results file.</source>
        <translation>Utilisez la même version pour toutes les lignes, ou choisissez un autre fichier de résultats.</translation>
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
        <source>Use this variant</source>
        <translation>Utiliser cette variante</translation>
    </message>
    <message>
        <source>Use time-optimal timing (joint limits).</source>
        <translation>Utilisez le calcul en temps optimal (limites des axes).</translation>
    </message>
    <message>
        <source>Use trajectory export for other formats.</source>
        <translation>Utilisez trajectory export pour les autres formats.</translation>
    </message>
    <message>
        <source>Use variant %1</source>
        <translation>Utiliser la variante %1</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>Variant</source>
        <translation>Variante</translation>
    </message>
    <message>
        <source>Variant %1
%2: %3
%4: %5</source>
        <translation>Variante %1
%2 : %3
%4 : %5</translation>
    </message>
    <message>
        <source>Variant %1 does not have the results of its row</source>
        <translation>La variante %1 n'a pas les résultats de sa ligne</translation>
    </message>
    <message>
        <source>Variant %1 is in use, but other things stand elsewhere than in the study, so its results may not hold. Undo, or run the study again for the cell as it is now.</source>
        <translation>La variante %1 est utilisée, mais d'autres choses sont ailleurs que dans l'étude ; ses résultats ne valent peut-être pas. Annulez, ou relancez l'étude pour la cellule actuelle.</translation>
    </message>
    <message>
        <source>Variant %1: %2</source>
        <translation>Variante %1 : %2</translation>
    </message>
    <message>
        <source>Variants</source>
        <translation>Variantes</translation>
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
        <source>View of the results</source>
        <translation>Vue des résultats</translation>
    </message>
    <message>
        <source>Viewers</source>
        <translation>Spectateurs</translation>
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
        <source>Wait until it has ended, or choose another file.</source>
        <translation>Attendez sa fin, ou choisissez un autre fichier.</translation>
    </message>
    <message>
        <source>Waiting for %1…</source>
        <translation>Attente de %1…</translation>
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
        <source>Wants %1 % of the greatest speed</source>
        <translation>Souhaite %1 % de la vitesse maximale</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avertissement</translation>
    </message>
    <message>
        <source>Way</source>
        <translation>Chemin</translation>
    </message>
    <message>
        <source>Way found, %1 clearance.</source>
        <translation>Chemin trouvé, distance de %1.</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Poids</translation>
    </message>
    <message>
        <source>Weight limit</source>
        <translation>Poids limite</translation>
    </message>
    <message>
        <source>Weight of %1</source>
        <translation>Poids de %1</translation>
    </message>
    <message>
        <source>Weight, or a force divided by 9.81</source>
        <translation>Poids, ou une force divisée par 9,81</translation>
    </message>
    <message>
        <source>What Python changed is not taken into the cell: %1</source>
        <translation>Ce que Python a modifié n’est pas repris dans la cellule : %1</translation>
    </message>
    <message>
        <source>What Python printed</source>
        <translation>Ce que Python a affiché</translation>
    </message>
    <message>
        <source>What acts now: it falls while you push out of the way, and comes back with a new way</source>
        <translation>Ce qui agit : cela baisse quand vous poussez hors du chemin, et revient avec un nouveau chemin</translation>
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
        <source>What blocks it as the cell stands</source>
        <translation>Ce qui le bloque dans la cellule telle quelle</translation>
    </message>
    <message>
        <source>What is added becomes part of a study. Press New or Open in the dock Study, then add it again.</source>
        <translation>Ce qui est ajouté fait partie d'une étude. Appuyez sur Nouveau ou Ouvrir dans le panneau Étude, puis recommencez l'ajout.</translation>
    </message>
    <message>
        <source>What is asked</source>
        <translation>Ce qui est demandé</translation>
    </message>
    <message>
        <source>What is selected was made in this program. Select a part that was imported from a file.</source>
        <translation>Ce qui est sélectionné a été créé dans ce programme. Sélectionnez une pièce importée d'un fichier.</translation>
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
        <source>What varies</source>
        <translation>Ce qui varie</translation>
    </message>
    <message>
        <source>What was assumed</source>
        <translation>Ce qui a été supposé</translation>
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
        <source>Where the entity is now becomes the goal: move it there, press, and move it back</source>
        <translation>La place actuelle de l'entité devient le but : amenez-la là, appuyez, et ramenez-la</translation>
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
        <source>With a tool, %1 long, %2 thick.</source>
        <translation>Avec un outil long de %1, épais de %2.</translation>
    </message>
    <message>
        <source>Without --robot, the configuration data are the format's defaults. Check them on the controller.</source>
        <translation>Pas de --robot : les données de configuration sont celles par défaut du format ; vérifiez-les sur le contrôleur.</translation>
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
        <source>Women P5, P50, P95</source>
        <translation>Femmes P5, P50, P95</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Travail</translation>
    </message>
    <message>
        <source>Work task</source>
        <translation>Tâche</translation>
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
        <source>Workcells (*.hcell);;Motions and recordings (*.htraj *.mcap);;All files (*)</source>
        <translation>Cellules (*.hcell);;Mouvements et enregistrements (*.htraj *.mcap);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Working zones (as EN ISO 14738)</source>
        <translation>Zones de travail (d'après EN ISO 14738)</translation>
    </message>
    <message>
        <source>Workplace for four bodies</source>
        <translation>Poste pour quatre corps</translation>
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
        <source>Write it with a decimal point.</source>
        <translation>Écrivez-le comme un nombre avec un point.</translation>
    </message>
    <message>
        <source>Write its value into the program.</source>
        <translation>Écrivez sa valeur dans le programme.</translation>
    </message>
    <message>
        <source>Write the lines in the order in which they run.</source>
        <translation>Écrivez les lignes dans l'ordre de leur exécution.</translation>
    </message>
    <message>
        <source>Write the path in metres from the centre of the device's workspace.</source>
        <translation>Écrivez le trajet en mètres depuis le centre de l'espace de travail du périphérique.</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Écrire le rapport</translation>
    </message>
    <message>
        <source>Write the report…</source>
        <translation>Écrire le rapport…</translation>
    </message>
    <message>
        <source>Write the search as a study, and open it in the study panel</source>
        <translation>Écrire la recherche comme étude et l'ouvrir dans le panneau des études</translation>
    </message>
    <message>
        <source>Write the values of the frames into the program, or split the program by frame.</source>
        <translation>Écrivez les valeurs des repères dans le programme, ou lisez ses parties une à une.</translation>
    </message>
    <message>
        <source>Write what you do to the cell from now on as a script</source>
        <translation>Écrire dans un script ce que vous faites désormais dans la cellule</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>Écriture de %1</translation>
    </message>
    <message>
        <source>Written to %1. Submit starts it.</source>
        <translation>Écrit dans %1. Soumettre le lance.</translation>
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
        <source>XML</source>
        <translation>XML</translation>
    </message>
    <message>
        <source>XML text</source>
        <translation>un texte XML</translation>
    </message>
    <message>
        <source>Xposition ... Zrotation</source>
        <translation>Xposition ... Zrotation</translation>
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
        <source>[capabilities], [mechanics] or [electronics]</source>
        <translation>[capabilities], [mechanics] ou [electronics]</translation>
    </message>
    <message>
        <source>[first frame, last frame]</source>
        <translation>[première image, dernière image]</translation>
    </message>
    <message>
        <source>[frame, &quot;name&quot;]</source>
        <translation>[image, &quot;nom&quot;]</translation>
    </message>
    <message>
        <source>[frame, seconds]</source>
        <translation>[image, secondes]</translation>
    </message>
    <message>
        <source>[in, out, &quot;first&quot;, &quot;second&quot;, force]</source>
        <translation>[début, fin, &quot;première&quot;, &quot;seconde&quot;, effort]</translation>
    </message>
    <message>
        <source>[markers] is missing</source>
        <translation>pas de [markers]</translation>
    </message>
    <message>
        <source>[markers] with landmarks and their markers</source>
        <translation>[markers] avec des repères anatomiques et leurs marqueurs</translation>
    </message>
    <message>
        <source>[t, x, y, z] in seconds and metres</source>
        <translation>[t, x, y, z] en secondes et en mètres</translation>
    </message>
    <message>
        <source>[width, depth, height], each %1</source>
        <translation>[largeur, profondeur, hauteur], chacune dans %1</translation>
    </message>
    <message>
        <source>[x, y, z] in metres</source>
        <translation>[x, y, z] en mètres</translation>
    </message>
    <message>
        <source>a %1 file</source>
        <translation>un fichier %1</translation>
    </message>
    <message>
        <source>a %1 of size zero</source>
        <translation>une forme '%1' de taille nulle</translation>
    </message>
    <message>
        <source>a %1 with a size that is not a number above 0</source>
        <translation>une forme '%1' dont la taille n'est pas un nombre positif</translation>
    </message>
    <message>
        <source>a '%' with more than two digits</source>
        <translation>un '%' avec plus de deux chiffres</translation>
    </message>
    <message>
        <source>a 3D grid of boxes from an image</source>
        <translation>des pavés tirés d'une image</translation>
    </message>
    <message>
        <source>a 3MF file</source>
        <translation>un fichier 3MF</translation>
    </message>
    <message>
        <source>a 3MF model</source>
        <translation>un modèle 3MF</translation>
    </message>
    <message>
        <source>a &lt;%1&gt; without &lt;geometry&gt;</source>
        <translation>un &lt;%1&gt; sans &lt;geometry&gt;</translation>
    </message>
    <message>
        <source>a BVH file</source>
        <translation>un fichier BVH</translation>
    </message>
    <message>
        <source>a BVH file in UTF-8</source>
        <translation>un fichier BVH en UTF-8</translation>
    </message>
    <message>
        <source>a C3D file</source>
        <translation>un fichier C3D</translation>
    </message>
    <message>
        <source>a CSV file</source>
        <translation>un fichier CSV</translation>
    </message>
    <message>
        <source>a Collada file</source>
        <translation>un fichier Collada</translation>
    </message>
    <message>
        <source>a FANUC program in LS form: /PROG, /MN, /POS</source>
        <translation>un programme FANUC au format LS : /PROG, /MN, /POS</translation>
    </message>
    <message>
        <source>a FOR with limits that are not numbers</source>
        <translation>un FOR dont les bornes ne sont pas des nombres</translation>
    </message>
    <message>
        <source>a FOR with limits that the file does not define</source>
        <translation>un FOR dont le fichier ne donne pas les bornes</translation>
    </message>
    <message>
        <source>a FlatBuffer with the identifier HCEL</source>
        <translation>un FlatBuffer avec l'identifiant HCEL</translation>
    </message>
    <message>
        <source>a HaptiCell trajectory</source>
        <translation>une trajectoire HaptiCell</translation>
    </message>
    <message>
        <source>a JSON file or JSON text</source>
        <translation>un fichier JSON, ou du JSON à cet endroit</translation>
    </message>
    <message>
        <source>a JSON object in braces</source>
        <translation>un objet entre accolades</translation>
    </message>
    <message>
        <source>a JointTrajectory (joint_names and points), or JointState messages (name and position)</source>
        <translation>un JointTrajectory (joint_names et points), ou des messages JointState (name et position)</translation>
    </message>
    <message>
        <source>a KRL program: DEF NAME( )</source>
        <translation>un programme KRL : DEF NOM( )</translation>
    </message>
    <message>
        <source>a LBL in the program</source>
        <translation>un LBL du programme</translation>
    </message>
    <message>
        <source>a NUL byte</source>
        <translation>un octet NUL</translation>
    </message>
    <message>
        <source>a PLY number type such as 'float' or 'uchar'</source>
        <translation>un type de nombre PLY comme 'float' ou 'uchar'</translation>
    </message>
    <message>
        <source>a PROC main(), or one with moves</source>
        <translation>une PROC main(), ou une avec des mouvements</translation>
    </message>
    <message>
        <source>a RAPID module with a PROC</source>
        <translation>un module RAPID avec une PROC</translation>
    </message>
    <message>
        <source>a STEP file</source>
        <translation>un fichier STEP</translation>
    </message>
    <message>
        <source>a STEP file with solids or surfaces</source>
        <translation>un fichier STEP avec des solides ou des surfaces</translation>
    </message>
    <message>
        <source>a STEP file, plain or compressed with gzip or ZIP</source>
        <translation>un fichier STEP, éventuellement compressé par gzip ou ZIP</translation>
    </message>
    <message>
        <source>a URDF robot</source>
        <translation>un robot URDF</translation>
    </message>
    <message>
        <source>a YAML file</source>
        <translation>un fichier YAML</translation>
    </message>
    <message>
        <source>a YAML file larger than 8 MB</source>
        <translation>un fichier YAML de plus de 8 Mo</translation>
    </message>
    <message>
        <source>a base from %1</source>
        <translation>une base donnée par %1</translation>
    </message>
    <message>
        <source>a binary OFF file</source>
        <translation>un fichier OFF binaire</translation>
    </message>
    <message>
        <source>a binary file</source>
        <translation>un fichier binaire</translation>
    </message>
    <message>
        <source>a bit shift by %1</source>
        <translation>un décalage de %1</translation>
    </message>
    <message>
        <source>a block</source>
        <translation>un bloc</translation>
    </message>
    <message>
        <source>a block of the macro, or a property with elements</source>
        <translation>un bloc de la macro, ou une propriété avec des éléments</translation>
    </message>
    <message>
        <source>a body with thickness</source>
        <translation>un corps avec une épaisseur</translation>
    </message>
    <message>
        <source>a bone of the skeleton</source>
        <translation>un os du squelette</translation>
    </message>
    <message>
        <source>a box with a size that is not three numbers</source>
        <translation>un pavé dont la taille ne se compose pas de trois nombres</translation>
    </message>
    <message>
        <source>a built-in part</source>
        <translation>une pièce intégrée</translation>
    </message>
    <message>
        <source>a built-in part, such as a box, a table or a bench</source>
        <translation>une pièce faite à partir de ses dimensions : un pavé, une table, un établi</translation>
    </message>
    <message>
        <source>a button that is held during the motion</source>
        <translation>un bouton tenu enfoncé pendant le mouvement</translation>
    </message>
    <message>
        <source>a cell with parts</source>
        <translation>une cellule avec des pièces</translation>
    </message>
    <message>
        <source>a chain that ends at an independent joint</source>
        <translation>un axe indépendant au bout de la chaîne</translation>
    </message>
    <message>
        <source>a change that no commands of the window make</source>
        <translation>une modification qu’aucune commande de la fenêtre ne fait</translation>
    </message>
    <message>
        <source>a channel of schema %1, which is not declared</source>
        <translation>un canal du schéma %1, qui n’est pas déclaré</translation>
    </message>
    <message>
        <source>a chunk of %1 MB</source>
        <translation>un bloc de %1 Mo</translation>
    </message>
    <message>
        <source>a clearance that is not valid</source>
        <translation>une distance de passage non valable</translation>
    </message>
    <message>
        <source>a code that viewers have to name</source>
        <translation>un code que les spectateurs doivent donner</translation>
    </message>
    <message>
        <source>a colour out of range</source>
        <translation>une couleur hors limites</translation>
    </message>
    <message>
        <source>a colour such as &quot;#ff6600&quot;</source>
        <translation>une couleur comme &quot;#ff6600&quot;</translation>
    </message>
    <message>
        <source>a complete archive</source>
        <translation>une archive complète</translation>
    </message>
    <message>
        <source>a complete file</source>
        <translation>un fichier complet</translation>
    </message>
    <message>
        <source>a condition with values that the file defines</source>
        <translation>une condition que le fichier détermine</translation>
    </message>
    <message>
        <source>a cone</source>
        <translation>un cône</translation>
    </message>
    <message>
        <source>a configuration</source>
        <translation>une configuration</translation>
    </message>
    <message>
        <source>a controller that listens on this topic</source>
        <translation>un contrôleur qui écoute ce topic</translation>
    </message>
    <message>
        <source>a controller that runs</source>
        <translation>un contrôleur en marche</translation>
    </message>
    <message>
        <source>a corner that is not a vertex number</source>
        <translation>un coin qui n'est pas un numéro de sommet</translation>
    </message>
    <message>
        <source>a count of %1 triangles</source>
        <translation>un nombre annoncé de %1 triangles</translation>
    </message>
    <message>
        <source>a count that is too large for the file or for the memory limit of an import</source>
        <translation>un nombre d'éléments supérieur à ce que le fichier contient, ou à ce qu'une importation peut utiliser</translation>
    </message>
    <message>
        <source>a coupling without finite numbers</source>
        <translation>un couplage sans valeurs numériques</translation>
    </message>
    <message>
        <source>a damaged FlatBuffer</source>
        <translation>un FlatBuffer endommagé</translation>
    </message>
    <message>
        <source>a damaged archive</source>
        <translation>une archive endommagée</translation>
    </message>
    <message>
        <source>a damaged chunk</source>
        <translation>un bloc endommagé</translation>
    </message>
    <message>
        <source>a data URI without data</source>
        <translation>un URI de données sans données</translation>
    </message>
    <message>
        <source>a default value without closing quote in params</source>
        <translation>une valeur par défaut sans guillemet fermant dans params</translation>
    </message>
    <message>
        <source>a defined name</source>
        <translation>un nom défini</translation>
    </message>
    <message>
        <source>a detent out of range</source>
        <translation>un cran hors limites</translation>
    </message>
    <message>
        <source>a deviation of %1 m and %2 rad</source>
        <translation>un écart de %1 m, %2 rad</translation>
    </message>
    <message>
        <source>a device profile</source>
        <translation>un profil de périphérique</translation>
    </message>
    <message>
        <source>a device, not a regular file</source>
        <translation>un périphérique, et non un fichier ordinaire</translation>
    </message>
    <message>
        <source>a dictionary</source>
        <translation>un dictionnaire</translation>
    </message>
    <message>
        <source>a direction</source>
        <translation>une direction</translation>
    </message>
    <message>
        <source>a direction of length zero, or parallel axes</source>
        <translation>une direction de longueur nulle, ou des axes parallèles</translation>
    </message>
    <message>
        <source>a direction, such as &quot;0 0 1&quot;</source>
        <translation>une direction, telle que &quot;0 0 1&quot;</translation>
    </message>
    <message>
        <source>a direction, such as 0 0 1</source>
        <translation>une direction, telle que 0 0 1</translation>
    </message>
    <message>
        <source>a direction, such as [0, 0, 1]</source>
        <translation>une direction, telle que [0, 0, 1]</translation>
    </message>
    <message>
        <source>a disk that stores all data</source>
        <translation>un disque qui conserve toutes les données</translation>
    </message>
    <message>
        <source>a display with OpenGL 3.3 core</source>
        <translation>un affichage avec OpenGL 3.3 core</translation>
    </message>
    <message>
        <source>a distance out of range</source>
        <translation>une distance hors limites</translation>
    </message>
    <message>
        <source>a division by 0</source>
        <translation>une division par 0</translation>
    </message>
    <message>
        <source>a division by zero</source>
        <translation>une division par zéro</translation>
    </message>
    <message>
        <source>a divisor other than 0</source>
        <translation>un autre diviseur</translation>
    </message>
    <message>
        <source>a document type that defines entities (&lt;!ENTITY ...&gt;)</source>
        <translation>un type de document avec ses propres entités (&lt;!ENTITY ...&gt;)</translation>
    </message>
    <message>
        <source>a drawn view</source>
        <translation>une vue dessinée</translation>
    </message>
    <message>
        <source>a driver of HaptiCell</source>
        <translation>un pilote de HaptiCell</translation>
    </message>
    <message>
        <source>a duration out of range</source>
        <translation>une durée hors limites</translation>
    </message>
    <message>
        <source>a face with fewer than three vertices</source>
        <translation>une face avec trop peu de coins</translation>
    </message>
    <message>
        <source>a file</source>
        <translation>un fichier</translation>
    </message>
    <message>
        <source>a file in the same folder</source>
        <translation>un fichier dans le même dossier</translation>
    </message>
    <message>
        <source>a file name</source>
        <translation>le nom d'un fichier</translation>
    </message>
    <message>
        <source>a file of points without a program</source>
        <translation>des points sans programme</translation>
    </message>
    <message>
        <source>a file or folder that only you and root can change</source>
        <translation>un fichier ou un dossier que vous seul et root pouvez modifier</translation>
    </message>
    <message>
        <source>a file or program that accepts all data</source>
        <translation>une cible qui accepte toutes les données</translation>
    </message>
    <message>
        <source>a file that can be copied to %1</source>
        <translation>un fichier qui peut être copié vers %1</translation>
    </message>
    <message>
        <source>a file that can be read</source>
        <translation>un fichier lisible</translation>
    </message>
    <message>
        <source>a file that can be read in the time for its size</source>
        <translation>un fichier lu dans le temps que sa taille autorise</translation>
    </message>
    <message>
        <source>a file that nobody else has open</source>
        <translation>un fichier que personne d'autre n'a ouvert</translation>
    </message>
    <message>
        <source>a file that study run or study merge wrote</source>
        <translation>un fichier écrit par study run ou study merge</translation>
    </message>
    <message>
        <source>a file that you can write</source>
        <translation>un fichier accessible en écriture</translation>
    </message>
    <message>
        <source>a file without entity definitions</source>
        <translation>un fichier sans ces entités</translation>
    </message>
    <message>
        <source>a file, or library:NAME, first</source>
        <translation>un fichier, ou library:NAME, en premier</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>un nombre fini</translation>
    </message>
    <message>
        <source>a finite number with '.' as decimal point</source>
        <translation>un nombre fini avec '.' comme séparateur décimal</translation>
    </message>
    <message>
        <source>a finite pose within 1e12 m</source>
        <translation>une pose finie à moins de 1e12 m</translation>
    </message>
    <message>
        <source>a finite result</source>
        <translation>un résultat fini</translation>
    </message>
    <message>
        <source>a first line that is too long</source>
        <translation>une première ligne trop longue</translation>
    </message>
    <message>
        <source>a folder</source>
        <translation>un dossier</translation>
    </message>
    <message>
        <source>a folder for temporary files</source>
        <translation>un dossier pour les fichiers temporaires</translation>
    </message>
    <message>
        <source>a folder on a local disk</source>
        <translation>un dossier sur un disque local</translation>
    </message>
    <message>
        <source>a folder that can be created</source>
        <translation>un dossier qui peut être créé</translation>
    </message>
    <message>
        <source>a folder that can be read</source>
        <translation>un dossier lisible</translation>
    </message>
    <message>
        <source>a folder that exists and is writable</source>
        <translation>un dossier qui existe et qui est accessible en écriture</translation>
    </message>
    <message>
        <source>a folder to write</source>
        <translation>un dossier où écrire</translation>
    </message>
    <message>
        <source>a format text with more % places than values</source>
        <translation>un texte à compléter avec plus d'emplacements que de valeurs</translation>
    </message>
    <message>
        <source>a frame number from 0 to less than %1</source>
        <translation>un numéro d'image de 0 à moins de %1</translation>
    </message>
    <message>
        <source>a frame number, 0 or more</source>
        <translation>le numéro d'une image, à partir de 0</translation>
    </message>
    <message>
        <source>a frame of '%1'</source>
        <translation>un repère de '%1'</translation>
    </message>
    <message>
        <source>a frame of an entity</source>
        <translation>un repère d'une entité</translation>
    </message>
    <message>
        <source>a frame of the cell or of an entity</source>
        <translation>un repère de la cellule ou d’une entité</translation>
    </message>
    <message>
        <source>a frame of the cell, an entity, or ENTITY/FRAME for a frame of an entity</source>
        <translation>un repère de la cellule, une entité, ou ENTITÉ/REPÈRE pour un repère d'une entité</translation>
    </message>
    <message>
        <source>a frame of the cell, or of a part</source>
        <translation>un repère de la cellule ou d’une pièce</translation>
    </message>
    <message>
        <source>a function</source>
        <translation>une fonction</translation>
    </message>
    <message>
        <source>a function that docs/user/formats.md lists</source>
        <translation>une des fonctions de docs/user/formats.md</translation>
    </message>
    <message>
        <source>a glTF file</source>
        <translation>un fichier glTF</translation>
    </message>
    <message>
        <source>a glove's calibration</source>
        <translation>l'étalonnage d'un gant</translation>
    </message>
    <message>
        <source>a greater number</source>
        <translation>un nombre plus grand</translation>
    </message>
    <message>
        <source>a hand, which it does not have</source>
        <translation>une main, qu'il n'a pas</translation>
    </message>
    <message>
        <source>a haptic server</source>
        <translation>un serveur haptique</translation>
    </message>
    <message>
        <source>a header line and at least one line of values</source>
        <translation>une ligne d'en-tête et au moins une ligne de données</translation>
    </message>
    <message>
        <source>a header line hand,x,y,z,qw,qx,qy,qz</source>
        <translation>une ligne d'en-tête hand,x,y,z,qw,qx,qy,qz</translation>
    </message>
    <message>
        <source>a header line with the columns %1</source>
        <translation>une ligne d'en-tête avec les colonnes %1</translation>
    </message>
    <message>
        <source>a header without rows</source>
        <translation>un en-tête sans lignes</translation>
    </message>
    <message>
        <source>a high risk</source>
        <translation>un risque élevé</translation>
    </message>
    <message>
        <source>a hint that is not valid</source>
        <translation>une indication non valable</translation>
    </message>
    <message>
        <source>a home position in which the six legs fix the platform</source>
        <translation>une position de repos où les six jambes tiennent la plateforme</translation>
    </message>
    <message>
        <source>a job that ends</source>
        <translation>un job qui se termine</translation>
    </message>
    <message>
        <source>a job: /JOB, //POS, //INST</source>
        <translation>un job : /JOB, //POS, //INST</translation>
    </message>
    <message>
        <source>a joint</source>
        <translation>un axe</translation>
    </message>
    <message>
        <source>a joint between models of a world</source>
        <translation>une articulation entre des modèles d'un monde</translation>
    </message>
    <message>
        <source>a joint of this robot</source>
        <translation>une articulation de ce robot</translation>
    </message>
    <message>
        <source>a joint position that is not a number</source>
        <translation>une position d'axe qui n'est pas un nombre</translation>
    </message>
    <message>
        <source>a joint type of Drake only</source>
        <translation>une articulation que seul Drake connaît</translation>
    </message>
    <message>
        <source>a joint value that is not finite</source>
        <translation>une valeur d'axe qui n'est pas finie</translation>
    </message>
    <message>
        <source>a joint without a name</source>
        <translation>un axe sans nom</translation>
    </message>
    <message>
        <source>a jump back; the repeated lines are read once.</source>
        <translation>un saut en arrière ; ce qu'il répète est lu une fois.</translation>
    </message>
    <message>
        <source>a jump to a label that does not exist</source>
        <translation>un saut vers une étiquette absente</translation>
    </message>
    <message>
        <source>a key like %1</source>
        <translation>une clé comme %1</translation>
    </message>
    <message>
        <source>a key of the dictionary</source>
        <translation>une de ses clés</translation>
    </message>
    <message>
        <source>a key that other users can read or change</source>
        <translation>une clé que d'autres utilisateurs peuvent lire ou modifier</translation>
    </message>
    <message>
        <source>a known target</source>
        <translation>une cible connue</translation>
    </message>
    <message>
        <source>a label in the job</source>
        <translation>une étiquette du job</translation>
    </message>
    <message>
        <source>a lambda of %1 parameters called with %2</source>
        <translation>un lambda à %1 paramètres appelé avec %2</translation>
    </message>
    <message>
        <source>a lattice of beams and balls</source>
        <translation>un treillis de poutres et de billes</translation>
    </message>
    <message>
        <source>a leg length above 0</source>
        <translation>une jambe de longueur non nulle</translation>
    </message>
    <message>
        <source>a length beyond the end of the file</source>
        <translation>une longueur qui dépasse la fin du fichier</translation>
    </message>
    <message>
        <source>a length of %1 bytes</source>
        <translation>une longueur de %1 octets</translation>
    </message>
    <message>
        <source>a length of %1 m at the home position</source>
        <translation>une longueur de %1 m au repos</translation>
    </message>
    <message>
        <source>a length of 1 within 1 %</source>
        <translation>une longueur de 1 à 1 % près</translation>
    </message>
    <message>
        <source>a length, speed or direction that is zero</source>
        <translation>une longueur, une vitesse ou une direction nulle</translation>
    </message>
    <message>
        <source>a library robot, such as hc6 or ur5e</source>
        <translation>un nom du dossier robots/ fourni, tel que hc6 ou ur5e</translation>
    </message>
    <message>
        <source>a line 'format'</source>
        <translation>une ligne 'format'</translation>
    </message>
    <message>
        <source>a line break</source>
        <translation>un saut de ligne</translation>
    </message>
    <message>
        <source>a line for each face</source>
        <translation>une ligne par face</translation>
    </message>
    <message>
        <source>a line for each vertex</source>
        <translation>une ligne par sommet</translation>
    </message>
    <message>
        <source>a line of more than 65 536 characters</source>
        <translation>une ligne de plus de 65 536 caractères</translation>
    </message>
    <message>
        <source>a line of over 200 characters</source>
        <translation>une ligne de plus de 200 caractères</translation>
    </message>
    <message>
        <source>a link of '%1'</source>
        <translation>un segment de '%1'</translation>
    </message>
    <message>
        <source>a link of robot '%1'</source>
        <translation>un segment du robot '%1'</translation>
    </message>
    <message>
        <source>a link of the model</source>
        <translation>un segment du modèle</translation>
    </message>
    <message>
        <source>a link of the robot</source>
        <translation>un segment du robot</translation>
    </message>
    <message>
        <source>a link of the robot that carries the tool</source>
        <translation>un segment du robot qui porte l'outil</translation>
    </message>
    <message>
        <source>a link that a joint moves</source>
        <translation>un segment mû par un axe</translation>
    </message>
    <message>
        <source>a link without a name</source>
        <translation>un segment sans nom</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>une liste</translation>
    </message>
    <message>
        <source>a list in brackets</source>
        <translation>une liste entre crochets</translation>
    </message>
    <message>
        <source>a list of frames</source>
        <translation>une liste d'images</translation>
    </message>
    <message>
        <source>a list of lifting tasks</source>
        <translation>une liste de tâches de levage</translation>
    </message>
    <message>
        <source>a list of more than 100 000 values</source>
        <translation>une liste de plus de 100 000 valeurs</translation>
    </message>
    <message>
        <source>a list of numbers</source>
        <translation>une liste de nombres</translation>
    </message>
    <message>
        <source>a list of points</source>
        <translation>une liste de points</translation>
    </message>
    <message>
        <source>a list of rows</source>
        <translation>une liste de lignes</translation>
    </message>
    <message>
        <source>a list of texts</source>
        <translation>une liste de textes</translation>
    </message>
    <message>
        <source>a list of texts in quotes</source>
        <translation>des textes entre guillemets</translation>
    </message>
    <message>
        <source>a list or a date</source>
        <translation>une liste ou une date</translation>
    </message>
    <message>
        <source>a list or a range</source>
        <translation>une liste ou un intervalle</translation>
    </message>
    <message>
        <source>a list or a text</source>
        <translation>une liste ou un texte</translation>
    </message>
    <message>
        <source>a list that is longer than the file</source>
        <translation>une liste plus longue que le fichier ne le permet</translation>
    </message>
    <message>
        <source>a list that is too long</source>
        <translation>une liste trop longue</translation>
    </message>
    <message>
        <source>a list with fewer nested levels</source>
        <translation>une liste moins imbriquée</translation>
    </message>
    <message>
        <source>a list, a dictionary or a text</source>
        <translation>une liste, un dictionnaire ou un texte</translation>
    </message>
    <message>
        <source>a list, a dictionary or a text after 'in'</source>
        <translation>une liste, un dictionnaire ou un texte après 'in'</translation>
    </message>
    <message>
        <source>a log file that can be written</source>
        <translation>un fichier journal accessible en écriture</translation>
    </message>
    <message>
        <source>a loop that depends on %1</source>
        <translation>une boucle qui dépend de %1</translation>
    </message>
    <message>
        <source>a lower and an upper limit</source>
        <translation>une butée inférieure et une butée supérieure</translation>
    </message>
    <message>
        <source>a lower stop above the upper stop</source>
        <translation>une butée inférieure au-dessus de la butée supérieure</translation>
    </message>
    <message>
        <source>a macro that is defined earlier, or an element of xacro</source>
        <translation>une macro définie avant, ou un élément de xacro</translation>
    </message>
    <message>
        <source>a macro with the name '%1'</source>
        <translation>une macro du nom de '%1'</translation>
    </message>
    <message>
        <source>a malformed record of kind %1</source>
        <translation>un enregistrement mal formé de type %1</translation>
    </message>
    <message>
        <source>a mannequin</source>
        <translation>un mannequin</translation>
    </message>
    <message>
        <source>a mannequin can be planned for only while its left or right hand moves it, with nothing locked and no steps allowed</source>
        <translation>un mannequin ne peut être planifié que si sa main gauche ou droite le déplace, sans rien de verrouillé et sans pas permis</translation>
    </message>
    <message>
        <source>a mannequin's whole posture (moved: whole)</source>
        <translation>la posture entière d'un mannequin (moved: whole)</translation>
    </message>
    <message>
        <source>a mannequin, but not which of its hands is to move</source>
        <translation>un mannequin, mais pas laquelle de ses mains doit bouger</translation>
    </message>
    <message>
        <source>a margin that is not valid</source>
        <translation>une marge non valable</translation>
    </message>
    <message>
        <source>a marker for each of them</source>
        <translation>un marqueur pour chacun d'eux</translation>
    </message>
    <message>
        <source>a marker's name, or a list of names</source>
        <translation>le nom d'un marqueur, ou une liste de noms</translation>
    </message>
    <message>
        <source>a mechanism</source>
        <translation>un mécanisme</translation>
    </message>
    <message>
        <source>a mesh</source>
        <translation>un maillage</translation>
    </message>
    <message>
        <source>a mesh as STL, OBJ, PLY or OFF</source>
        <translation>un maillage STL, OBJ, PLY ou OFF</translation>
    </message>
    <message>
        <source>a mesh displaced by an image</source>
        <translation>un maillage mis en relief par une image</translation>
    </message>
    <message>
        <source>a mesh of the file</source>
        <translation>un maillage du fichier</translation>
    </message>
    <message>
        <source>a mesh with at least one triangle</source>
        <translation>un maillage avec au moins un triangle</translation>
    </message>
    <message>
        <source>a mesh without &lt;uri&gt;</source>
        <translation>un maillage sans &lt;uri&gt;</translation>
    </message>
    <message>
        <source>a mesh without filename</source>
        <translation>un maillage sans nom de fichier</translation>
    </message>
    <message>
        <source>a mesh without volume</source>
        <translation>un maillage sans volume</translation>
    </message>
    <message>
        <source>a message of channel %1, which is not declared</source>
        <translation>un message du canal %1, qui n’est pas déclaré</translation>
    </message>
    <message>
        <source>a message of the topic's type</source>
        <translation>un message du type du sujet</translation>
    </message>
    <message>
        <source>a message that does not fit its type</source>
        <translation>un message qui ne correspond pas à son type</translation>
    </message>
    <message>
        <source>a message with content</source>
        <translation>un message avec un contenu</translation>
    </message>
    <message>
        <source>a missing argument</source>
        <translation>un argument omis</translation>
    </message>
    <message>
        <source>a motion</source>
        <translation>un mouvement</translation>
    </message>
    <message>
        <source>a motion in AMC</source>
        <translation>un mouvement en AMC</translation>
    </message>
    <message>
        <source>a motion of '%1'</source>
        <translation>un mouvement de « %1 »</translation>
    </message>
    <message>
        <source>a motion of a robot</source>
        <translation>un mouvement d'un robot</translation>
    </message>
    <message>
        <source>a motion of its joints alone</source>
        <translation>un mouvement de ses seules articulations</translation>
    </message>
    <message>
        <source>a motion of one hand only</source>
        <translation>le mouvement d'une main seule</translation>
    </message>
    <message>
        <source>a motion of the entity that was planned for</source>
        <translation>un mouvement de l’entité planifiée</translation>
    </message>
    <message>
        <source>a motion of the robot's joints</source>
        <translation>un mouvement des articulations du robot</translation>
    </message>
    <message>
        <source>a motion that does not name what moves</source>
        <translation>un mouvement qui ne nomme pas ce qui bouge</translation>
    </message>
    <message>
        <source>a motion that names its entity (.htraj)</source>
        <translation>un mouvement qui nomme son entité (.htraj)</translation>
    </message>
    <message>
        <source>a motion to send</source>
        <translation>un mouvement à envoyer</translation>
    </message>
    <message>
        <source>a motion without contact, within the limits of the joints</source>
        <translation>un mouvement sans contact, dans les limites des articulations</translation>
    </message>
    <message>
        <source>a move relative to a target that the file does not define</source>
        <translation>un mouvement relatif à une cible que le fichier ne donne pas</translation>
    </message>
    <message>
        <source>a move without target</source>
        <translation>un mouvement sans cible</translation>
    </message>
    <message>
        <source>a moving part or a carrying part is not set</source>
        <translation>la pièce mobile ou la pièce qui la porte n'est pas définie</translation>
    </message>
    <message>
        <source>a name</source>
        <translation>un nom</translation>
    </message>
    <message>
        <source>a name of its own</source>
        <translation>un nom qui lui est propre</translation>
    </message>
    <message>
        <source>a name or link that leads out of the archive</source>
        <translation>un nom ou un lien qui mène hors de l'archive</translation>
    </message>
    <message>
        <source>a name such as l_elbow_flexion</source>
        <translation>un nom tel que l_elbow_flexion</translation>
    </message>
    <message>
        <source>a name that exists on the controller</source>
        <translation>un nom défini sur le contrôleur</translation>
    </message>
    <message>
        <source>a name that is not text</source>
        <translation>un nom qui n'est pas un texte</translation>
    </message>
    <message>
        <source>a name that is taken</source>
        <translation>un nom déjà pris</translation>
    </message>
    <message>
        <source>a name without dots, other than call</source>
        <translation>un nom sans points, autre que call</translation>
    </message>
    <message>
        <source>a namespace</source>
        <translation>un espace de noms</translation>
    </message>
    <message>
        <source>a new file</source>
        <translation>un nouveau fichier</translation>
    </message>
    <message>
        <source>a new or empty folder</source>
        <translation>un dossier nouveau ou vide</translation>
    </message>
    <message>
        <source>a new results file</source>
        <translation>un nouveau fichier de résultats</translation>
    </message>
    <message>
        <source>a node of the file</source>
        <translation>un nœud du fichier</translation>
    </message>
    <message>
        <source>a node that does not exist</source>
        <translation>un nœud qui n'existe pas</translation>
    </message>
    <message>
        <source>a non-empty separator</source>
        <translation>un texte séparateur</translation>
    </message>
    <message>
        <source>a non-empty text</source>
        <translation>un texte non vide</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>a number above 0</source>
        <translation>un nombre supérieur à 0</translation>
    </message>
    <message>
        <source>a number below %1, the number of vertices</source>
        <translation>moins que les %1 sommets du fichier</translation>
    </message>
    <message>
        <source>a number from 0 to 100</source>
        <translation>un nombre de 0 à 100</translation>
    </message>
    <message>
        <source>a number of a row, below %1</source>
        <translation>un numéro de ligne, inférieur à %1</translation>
    </message>
    <message>
        <source>a number of degrees</source>
        <translation>un nombre de degrés</translation>
    </message>
    <message>
        <source>a number of joints that differs from the robot's</source>
        <translation>des axes que le robot n'a pas</translation>
    </message>
    <message>
        <source>a number that is negative or not finite</source>
        <translation>un nombre non fini ou négatif</translation>
    </message>
    <message>
        <source>a number that is not finite</source>
        <translation>un nombre non fini</translation>
    </message>
    <message>
        <source>a number that is not finite or out of its range</source>
        <translation>un nombre non fini ou hors de sa plage</translation>
    </message>
    <message>
        <source>a number that is too large</source>
        <translation>un nombre trop grand</translation>
    </message>
    <message>
        <source>a number within +-7 rad</source>
        <translation>un nombre entre -7 et +7 rad</translation>
    </message>
    <message>
        <source>a number within 64 bits</source>
        <translation>un nombre sur 64 bits</translation>
    </message>
    <message>
        <source>a number within its domain</source>
        <translation>un nombre de son domaine de définition</translation>
    </message>
    <message>
        <source>a number, %1 to %2</source>
        <translation>un nombre de %1 à %2</translation>
    </message>
    <message>
        <source>a number; the equation needs all fields</source>
        <translation>un nombre ; l'équation a besoin de tous les champs</translation>
    </message>
    <message>
        <source>a pairing code</source>
        <translation>un code d'appairage</translation>
    </message>
    <message>
        <source>a parameter block after the header</source>
        <translation>un bloc après l'en-tête</translation>
    </message>
    <message>
        <source>a part</source>
        <translation>une pièce</translation>
    </message>
    <message>
        <source>a part of the mechanism</source>
        <translation>une pièce du mécanisme</translation>
    </message>
    <message>
        <source>a part of the package</source>
        <translation>un élément du paquet</translation>
    </message>
    <message>
        <source>a part of the text</source>
        <translation>une partie de ce texte</translation>
    </message>
    <message>
        <source>a part that can be moved</source>
        <translation>une pièce qui peut être déplacée</translation>
    </message>
    <message>
        <source>a part that the file still has</source>
        <translation>une pièce encore présente dans le fichier</translation>
    </message>
    <message>
        <source>a path cannot be planned for a %1</source>
        <translation>aucun trajet ne peut être planifié pour une entité du type %1</translation>
    </message>
    <message>
        <source>a path of fewer than two points</source>
        <translation>une trajectoire de moins de deux points</translation>
    </message>
    <message>
        <source>a path of length zero</source>
        <translation>une trajectoire de longueur nulle</translation>
    </message>
    <message>
        <source>a picture of %1 x %2</source>
        <translation>une image de %1 x %2</translation>
    </message>
    <message>
        <source>a pipe, not a regular file</source>
        <translation>un tube, et non un fichier ordinaire</translation>
    </message>
    <message>
        <source>a plan leaves contacts that are up to %1 deep</source>
        <translation>un trajet quitte des contacts profonds de %1 au plus</translation>
    </message>
    <message>
        <source>a point of the path that is not finite</source>
        <translation>un point non fini de la trajectoire</translation>
    </message>
    <message>
        <source>a point that is not a map</source>
        <translation>un point qui n'est pas une table</translation>
    </message>
    <message>
        <source>a point that is not four numbers</source>
        <translation>un point qui n'est pas fait de quatre nombres</translation>
    </message>
    <message>
        <source>a point that is not three numbers</source>
        <translation>un point qui n'est pas fait de trois nombres</translation>
    </message>
    <message>
        <source>a port from 0 (any) to 65535</source>
        <translation>un port de 0 (n'importe lequel) à 65535</translation>
    </message>
    <message>
        <source>a pose and sizes of 0 or more</source>
        <translation>une pose et des tailles d’au moins 0</translation>
    </message>
    <message>
        <source>a pose of '%1'</source>
        <translation>une pose de '%1'</translation>
    </message>
    <message>
        <source>a pose of the mannequin's hand</source>
        <translation>une pose de la main du mannequin</translation>
    </message>
    <message>
        <source>a pose or joints, because it is fixed by its base</source>
        <translation>une pose ou des articulations, car l’entité est fixée par sa base</translation>
    </message>
    <message>
        <source>a pose that can be resolved</source>
        <translation>une pose qui peut être déterminée</translation>
    </message>
    <message>
        <source>a pose that changes while the joints do not</source>
        <translation>une pose qui bouge alors que les axes sont immobiles</translation>
    </message>
    <message>
        <source>a pose that is not valid</source>
        <translation>une pose non valable</translation>
    </message>
    <message>
        <source>a pose, because it has no joints</source>
        <translation>une pose, car l’entité n’a pas d’articulations</translation>
    </message>
    <message>
        <source>a pose, because the mannequin's feet stay</source>
        <translation>une pose, car les pieds du mannequin restent en place</translation>
    </message>
    <message>
        <source>a position %1 from the centre of the workspace</source>
        <translation>une position à %1 du centre de l'espace de travail</translation>
    </message>
    <message>
        <source>a position and a unit quaternion</source>
        <translation>une position et un quaternion unitaire</translation>
    </message>
    <message>
        <source>a position from a register</source>
        <translation>une position donnée par un registre</translation>
    </message>
    <message>
        <source>a position that is too far away</source>
        <translation>une position trop éloignée</translation>
    </message>
    <message>
        <source>a position within the joint's limits</source>
        <translation>une position dans les limites de l'axe</translation>
    </message>
    <message>
        <source>a posture</source>
        <translation>une posture</translation>
    </message>
    <message>
        <source>a posture by its joints, which is not planned: the feet stay, and balance decides on it</source>
        <translation>une posture donnée par ses articulations, ce qui ne se planifie pas : les pieds restent en place et l'équilibre en décide</translation>
    </message>
    <message>
        <source>a power that is not a number (%1 ** %2)</source>
        <translation>une puissance qui n'est pas un nombre (%1 ** %2)</translation>
    </message>
    <message>
        <source>a power that is too large</source>
        <translation>une puissance trop grande</translation>
    </message>
    <message>
        <source>a printable name of 1 to 200 characters</source>
        <translation>un nom imprimable de 1 à 200 lettres</translation>
    </message>
    <message>
        <source>a prismatic joint without limits</source>
        <translation>une glissière sans butées</translation>
    </message>
    <message>
        <source>a program in text format</source>
        <translation>un programme en texte</translation>
    </message>
    <message>
        <source>a program that ends</source>
        <translation>un programme qui se termine</translation>
    </message>
    <message>
        <source>a program that publishes it</source>
        <translation>un programme qui le publie</translation>
    </message>
    <message>
        <source>a program with moves to targets</source>
        <translation>un programme avec des mouvements vers des cibles</translation>
    </message>
    <message>
        <source>a property</source>
        <translation>une propriété</translation>
    </message>
    <message>
        <source>a property with the name '%1'</source>
        <translation>une propriété du nom de '%1'</translation>
    </message>
    <message>
        <source>a property, a parameter or a function that xacro knows</source>
        <translation>une propriété, un paramètre ou une fonction que xacro connaît</translation>
    </message>
    <message>
        <source>a quaternion of length %1</source>
        <translation>un quaternion de norme %1</translation>
    </message>
    <message>
        <source>a quaternion w, x, y, z of length 1</source>
        <translation>un quaternion w, x, y, z de norme 1</translation>
    </message>
    <message>
        <source>a range that leaves at least one frame</source>
        <translation>une plage qui laisse au moins une image</translation>
    </message>
    <message>
        <source>a range within %1 s to %2 s</source>
        <translation>une partie de %1 s à %2 s</translation>
    </message>
    <message>
        <source>a range without steps</source>
        <translation>un intervalle sans pas</translation>
    </message>
    <message>
        <source>a ratio and an offset</source>
        <translation>un rapport et un décalage</translation>
    </message>
    <message>
        <source>a readable CSV file</source>
        <translation>un fichier CSV lisible</translation>
    </message>
    <message>
        <source>a record of kind %1</source>
        <translation>un enregistrement de type %1</translation>
    </message>
    <message>
        <source>a recorded device session (*.hdev)</source>
        <translation>une session de périphérique enregistrée (*.hdev)</translation>
    </message>
    <message>
        <source>a recording in C3D</source>
        <translation>un enregistrement en C3D</translation>
    </message>
    <message>
        <source>a recording with at least one tick</source>
        <translation>un enregistrement d'au moins un cycle</translation>
    </message>
    <message>
        <source>a recovery copy that can be moved</source>
        <translation>une copie de récupération qui peut être déplacée</translation>
    </message>
    <message>
        <source>a reference or count beyond the end of the file's data</source>
        <translation>un renvoi ou un nombre d'éléments au-delà de ce que le fichier contient</translation>
    </message>
    <message>
        <source>a reference to something that is not in the file</source>
        <translation>un renvoi à quelque chose qui n'est pas dans le fichier</translation>
    </message>
    <message>
        <source>a region that is not valid</source>
        <translation>une région non valable</translation>
    </message>
    <message>
        <source>a result</source>
        <translation>un résultat</translation>
    </message>
    <message>
        <source>a result of comb() or perm() beyond 64 bits</source>
        <translation>comb() ou perm() au-delà de 64 bits</translation>
    </message>
    <message>
        <source>a road</source>
        <translation>une route</translation>
    </message>
    <message>
        <source>a robot</source>
        <translation>un robot</translation>
    </message>
    <message>
        <source>a robot attached to a moving link of a mechanism or robot that is not locked</source>
        <translation>un robot porté par un segment mobile d'un mécanisme ou d'un robot non verrouillé</translation>
    </message>
    <message>
        <source>a robot can be planned for only while it is moved by its tool (TCP)</source>
        <translation>un robot ne peut être planifié que s'il est déplacé par son outil (TCP)</translation>
    </message>
    <message>
        <source>a robot file, or library:NAME</source>
        <translation>un fichier de robot, ou library:NAME</translation>
    </message>
    <message>
        <source>a robot of six joints</source>
        <translation>un robot à six axes</translation>
    </message>
    <message>
        <source>a robot of the cell</source>
        <translation>un robot de la cellule</translation>
    </message>
    <message>
        <source>a robot or a mechanism</source>
        <translation>un robot ou un mécanisme</translation>
    </message>
    <message>
        <source>a robot that rests</source>
        <translation>un robot au repos</translation>
    </message>
    <message>
        <source>a robot with a moving link</source>
        <translation>un robot avec un segment mobile</translation>
    </message>
    <message>
        <source>a robot with closed loops</source>
        <translation>un robot à boucles fermées</translation>
    </message>
    <message>
        <source>a robot with joints</source>
        <translation>un robot avec des articulations</translation>
    </message>
    <message>
        <source>a robot with named tools</source>
        <translation>un robot avec des outils nommés</translation>
    </message>
    <message>
        <source>a robot within 0.01 rad (1 mm) of it</source>
        <translation>un robot à moins de 0,01 rad (1 mm) de celui-ci</translation>
    </message>
    <message>
        <source>a robot's file or library:NAME, or --collision-free with --workcell and --entity</source>
        <translation>le fichier d'un robot ou library:NAME, ou --collision-free avec --workcell et --entity</translation>
    </message>
    <message>
        <source>a robot, a mannequin or a solid of the cell</source>
        <translation>un robot, un mannequin ou un solide de la cellule</translation>
    </message>
    <message>
        <source>a robot, a mechanism, a mannequin or a solid with a shape</source>
        <translation>un robot, un mécanisme, un mannequin ou un solide avec une forme</translation>
    </message>
    <message>
        <source>a robot, which can have a tool</source>
        <translation>un robot, qui peut avoir un outil</translation>
    </message>
    <message>
        <source>a robot, which can have named poses</source>
        <translation>un robot, qui peut avoir des poses nommées</translation>
    </message>
    <message>
        <source>a robot, which can have tools</source>
        <translation>un robot, qui peut avoir des outils</translation>
    </message>
    <message>
        <source>a robot.toml</source>
        <translation>un robot.toml</translation>
    </message>
    <message>
        <source>a running controller</source>
        <translation>un contrôleur en marche</translation>
    </message>
    <message>
        <source>a running server</source>
        <translation>un serveur en marche</translation>
    </message>
    <message>
        <source>a saved simulation state; the models are placed as described</source>
        <translation>des positions enregistrées pendant une simulation ; les modèles sont placés là où ils sont décrits</translation>
    </message>
    <message>
        <source>a scene without nodes</source>
        <translation>une scène sans nœuds</translation>
    </message>
    <message>
        <source>a screw joint without pitch</source>
        <translation>une vis sans pas</translation>
    </message>
    <message>
        <source>a search without a range</source>
        <translation>une recherche sans intervalle</translation>
    </message>
    <message>
        <source>a search, which stops at a signal; it is read up to its end point.</source>
        <translation>une recherche, qui s'arrête à un signal ; elle est lue jusqu'à son point final.</translation>
    </message>
    <message>
        <source>a second ROOT '%1'</source>
        <translation>un second ROOT '%1'</translation>
    </message>
    <message>
        <source>a second agent '%1'</source>
        <translation>un second agent « %1 »</translation>
    </message>
    <message>
        <source>a second document</source>
        <translation>un second document</translation>
    </message>
    <message>
        <source>a second joint '%1' (the first is on %2)</source>
        <translation>un second axe '%1' (le premier : %2)</translation>
    </message>
    <message>
        <source>a second left hand in the same step</source>
        <translation>de nouveau la main gauche dans la même étape</translation>
    </message>
    <message>
        <source>a second link '%1' (the first is on %2)</source>
        <translation>un second segment '%1' (le premier : %2)</translation>
    </message>
    <message>
        <source>a second one called '%1'</source>
        <translation>un deuxième nommé « %1 »</translation>
    </message>
    <message>
        <source>a second right hand in the same step</source>
        <translation>de nouveau la main droite dans la même étape</translation>
    </message>
    <message>
        <source>a second world is left out</source>
        <translation>un second monde est omis</translation>
    </message>
    <message>
        <source>a server that answers until the hand path ends</source>
        <translation>un serveur qui répond jusqu'à la fin du trajet de la main</translation>
    </message>
    <message>
        <source>a server with the DDS of the maker %1</source>
        <translation>un serveur avec le DDS du fabricant %1</translation>
    </message>
    <message>
        <source>a shape</source>
        <translation>une forme</translation>
    </message>
    <message>
        <source>a shape with a bounding box that differs by %1 m</source>
        <translation>une forme dont la boîte englobante s'écarte de %1 m</translation>
    </message>
    <message>
        <source>a shortened list</source>
        <translation>une liste tronquée</translation>
    </message>
    <message>
        <source>a shorter list</source>
        <translation>une liste plus courte</translation>
    </message>
    <message>
        <source>a shorter one</source>
        <translation>un plus court</translation>
    </message>
    <message>
        <source>a simpler one</source>
        <translation>une plus simple</translation>
    </message>
    <message>
        <source>a simulated device</source>
        <translation>un périphérique simulé</translation>
    </message>
    <message>
        <source>a single frame, or frames that the file defines</source>
        <translation>un seul repère, ou des repères dont le fichier donne la pose</translation>
    </message>
    <message>
        <source>a skeleton</source>
        <translation>un squelette</translation>
    </message>
    <message>
        <source>a skeleton in ASF</source>
        <translation>un squelette en ASF</translation>
    </message>
    <message>
        <source>a skeleton with a root</source>
        <translation>un squelette avec sa racine</translation>
    </message>
    <message>
        <source>a skeleton without a joint for the %1 (its joints are %2)</source>
        <translation>un squelette sans articulation pour : %1 (ses articulations sont %2)</translation>
    </message>
    <message>
        <source>a slice of %1</source>
        <translation>une tranche prise dans %1</translation>
    </message>
    <message>
        <source>a slice with a step of 0</source>
        <translation>une tranche de pas 0</translation>
    </message>
    <message>
        <source>a slower motion</source>
        <translation>un mouvement plus lent</translation>
    </message>
    <message>
        <source>a smaller one</source>
        <translation>un plus petit</translation>
    </message>
    <message>
        <source>a smaller or coarser model</source>
        <translation>un modèle plus petit ou plus grossier</translation>
    </message>
    <message>
        <source>a socket, not a regular file</source>
        <translation>une socket, et non un fichier ordinaire</translation>
    </message>
    <message>
        <source>a solid</source>
        <translation>un solide</translation>
    </message>
    <message>
        <source>a solid, a robot or a mannequin</source>
        <translation>un solide, un robot ou un mannequin</translation>
    </message>
    <message>
        <source>a speed above 0 and a friction of 0 or more</source>
        <translation>une vitesse supérieure à 0, un frottement au moins égal à 0</translation>
    </message>
    <message>
        <source>a speed or friction out of range</source>
        <translation>une vitesse ou un frottement hors limites</translation>
    </message>
    <message>
        <source>a spline; it is read as straight lines between its points.</source>
        <translation>une spline ; elle est lue comme des droites entre ses points.</translation>
    </message>
    <message>
        <source>a start free of contact</source>
        <translation>un départ sans contact</translation>
    </message>
    <message>
        <source>a start or end speed that the limits do not allow</source>
        <translation>une vitesse de départ ou d'arrivée qu'aucun mouvement dans les limites n'atteint</translation>
    </message>
    <message>
        <source>a start that is not valid</source>
        <translation>un départ non valable</translation>
    </message>
    <message>
        <source>a step above 0 that gives at most 10 million frames</source>
        <translation>un pas supérieur à 0 qui donne au plus 10 millions d'images</translation>
    </message>
    <message>
        <source>a step of %1 s for a motion of %2 s</source>
        <translation>un pas de %1 s pour un mouvement de %2 s</translation>
    </message>
    <message>
        <source>a step other than 0</source>
        <translation>un autre pas</translation>
    </message>
    <message>
        <source>a stiffness, damping or load that is negative, not finite or too large</source>
        <translation>une raideur, un amortissement ou une charge négatifs, non finis ou trop grands</translation>
    </message>
    <message>
        <source>a stop out of range</source>
        <translation>une butée hors limites</translation>
    </message>
    <message>
        <source>a study (.hstudy)</source>
        <translation>une étude (.hstudy)</translation>
    </message>
    <message>
        <source>a study without objectives</source>
        <translation>une étude sans objectifs</translation>
    </message>
    <message>
        <source>a summary at byte %1</source>
        <translation>un résumé à l’octet %1</translation>
    </message>
    <message>
        <source>a summary of %1 messages in %2 chunks</source>
        <translation>un résumé de %1 messages en %2 blocs</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>une table</translation>
    </message>
    <message>
        <source>a table [%1]</source>
        <translation>une table [%1]</translation>
    </message>
    <message>
        <source>a table in TOML</source>
        <translation>une table en TOML</translation>
    </message>
    <message>
        <source>a table in TOML of at most 1 MB</source>
        <translation>une table en TOML de 1 Mo au plus</translation>
    </message>
    <message>
        <source>a table of markers for a skeleton</source>
        <translation>une table de marqueurs pour un squelette</translation>
    </message>
    <message>
        <source>a table with a header such as [[vary]]</source>
        <translation>une table avec un en-tête tel que [[vary]]</translation>
    </message>
    <message>
        <source>a target before the arc</source>
        <translation>une cible avant lui</translation>
    </message>
    <message>
        <source>a target from %1</source>
        <translation>une cible donnée par %1</translation>
    </message>
    <message>
        <source>a target given by joints</source>
        <translation>une cible donnée par des axes</translation>
    </message>
    <message>
        <source>a target in a position register, which the program does not set</source>
        <translation>une cible dans un registre de position que le programme ne définit pas</translation>
    </message>
    <message>
        <source>a target that is neither p[...] nor six joints</source>
        <translation>une cible qui n'est ni p[...] ni six axes</translation>
    </message>
    <message>
        <source>a target that is not a robtarget or jointtarget</source>
        <translation>une cible qui n'est ni robtarget ni jointtarget</translation>
    </message>
    <message>
        <source>a target that is not finite</source>
        <translation>une cible qui n'est pas finie</translation>
    </message>
    <message>
        <source>a target that the file defines</source>
        <translation>une cible que le fichier donne</translation>
    </message>
    <message>
        <source>a target that the file defines, because moves follow</source>
        <translation>une cible que le fichier donne, car des mouvements la suivent</translation>
    </message>
    <message>
        <source>a target with an offset by a position register</source>
        <translation>une cible décalée par un registre de position</translation>
    </message>
    <message>
        <source>a target without all its coordinates</source>
        <translation>une cible sans toutes ses coordonnées</translation>
    </message>
    <message>
        <source>a task for agents</source>
        <translation>une tâche pour agents</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texte</translation>
    </message>
    <message>
        <source>a text in quotes</source>
        <translation>un texte entre guillemets</translation>
    </message>
    <message>
        <source>a text longer than 1 MB</source>
        <translation>un texte de plus de 1 Mo</translation>
    </message>
    <message>
        <source>a text or a number</source>
        <translation>un texte ou un nombre</translation>
    </message>
    <message>
        <source>a text to replace</source>
        <translation>un texte à remplacer</translation>
    </message>
    <message>
        <source>a text without closing quote in the expression</source>
        <translation>un texte sans guillemet fermant dans l'expression</translation>
    </message>
    <message>
        <source>a text, a number or a list</source>
        <translation>un texte, un nombre ou une liste</translation>
    </message>
    <message>
        <source>a time after that of the line before, %1 s</source>
        <translation>un temps après celui de la ligne précédente, %1 s</translation>
    </message>
    <message>
        <source>a time after the one before, %1 s</source>
        <translation>un temps après le précédent, %1 s</translation>
    </message>
    <message>
        <source>a time between the first and the last frame</source>
        <translation>un temps entre la première et la dernière image</translation>
    </message>
    <message>
        <source>a time of %1 s</source>
        <translation>un temps de %1 s</translation>
    </message>
    <message>
        <source>a time of 0 s or more</source>
        <translation>un temps de 0 s ou plus</translation>
    </message>
    <message>
        <source>a time of more than 30 years</source>
        <translation>un temps de plus de 30 ans</translation>
    </message>
    <message>
        <source>a time that is not a whole number</source>
        <translation>un temps qui n'est pas un nombre entier</translation>
    </message>
    <message>
        <source>a time that is not after the time before</source>
        <translation>un instant qui n'est pas postérieur au précédent</translation>
    </message>
    <message>
        <source>a time within the nanosecond of the frame before</source>
        <translation>un temps à moins d’une nanoseconde du point précédent</translation>
    </message>
    <message>
        <source>a time without a frame</source>
        <translation>un temps sans image</translation>
    </message>
    <message>
        <source>a time_from_start of %1 s</source>
        <translation>un time_from_start de %1 s</translation>
    </message>
    <message>
        <source>a tip that moves</source>
        <translation>une qui bouge</translation>
    </message>
    <message>
        <source>a tolerance in a search</source>
        <translation>une tolérance dans une recherche</translation>
    </message>
    <message>
        <source>a tool of '%1'</source>
        <translation>un outil de '%1'</translation>
    </message>
    <message>
        <source>a tool that moves, because its speed is to be constant</source>
        <translation>un outil qui bouge, pour qu'il ait une vitesse constante</translation>
    </message>
    <message>
        <source>a trajectory</source>
        <translation>une trajectoire</translation>
    </message>
    <message>
        <source>a trajectory file</source>
        <translation>un fichier de trajectoire</translation>
    </message>
    <message>
        <source>a tree from the root link '%1'</source>
        <translation>un arbre issu du segment racine '%1'</translation>
    </message>
    <message>
        <source>a tree with one root link</source>
        <translation>un arbre avec un seul segment racine</translation>
    </message>
    <message>
        <source>a tree without cycles</source>
        <translation>un arbre sans cycle</translation>
    </message>
    <message>
        <source>a triangle with a vertex that does not exist</source>
        <translation>un triangle dont un sommet n'existe pas</translation>
    </message>
    <message>
        <source>a typing error (the checksum is wrong)</source>
        <translation>une faute de frappe (somme de contrôle fausse)</translation>
    </message>
    <message>
        <source>a unique name</source>
        <translation>un nom unique</translation>
    </message>
    <message>
        <source>a unit for a robot</source>
        <translation>une unité pour un robot</translation>
    </message>
    <message>
        <source>a unit quaternion</source>
        <translation>un quaternion unitaire</translation>
    </message>
    <message>
        <source>a unit quaternion, w first</source>
        <translation>un quaternion unitaire, w d'abord</translation>
    </message>
    <message>
        <source>a valid Envelope</source>
        <translation>une Envelope valide</translation>
    </message>
    <message>
        <source>a valid pose and status</source>
        <translation>une pose et un état valides</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>une valeur</translation>
    </message>
    <message>
        <source>a value above 0</source>
        <translation>une valeur positive</translation>
    </message>
    <message>
        <source>a value after the option</source>
        <translation>une valeur à la suite</translation>
    </message>
    <message>
        <source>a value for each parameter</source>
        <translation>une valeur pour chacun</translation>
    </message>
    <message>
        <source>a value in the expression</source>
        <translation>une valeur dans l'expression</translation>
    </message>
    <message>
        <source>a value is out of range</source>
        <translation>une valeur hors de sa plage</translation>
    </message>
    <message>
        <source>a value of the list</source>
        <translation>une de ses valeurs</translation>
    </message>
    <message>
        <source>a value outside its range</source>
        <translation>une valeur hors de sa plage</translation>
    </message>
    <message>
        <source>a value that is not above 0</source>
        <translation>une valeur qui n'est pas positive</translation>
    </message>
    <message>
        <source>a value that is not in the list</source>
        <translation>une valeur qui n'est pas dans la liste</translation>
    </message>
    <message>
        <source>a value that the file does not define</source>
        <translation>une valeur que le fichier ne donne pas</translation>
    </message>
    <message>
        <source>a value without a bound</source>
        <translation>une valeur sans borne</translation>
    </message>
    <message>
        <source>a velocity and an acceleration above 0 for each of %1 axes</source>
        <translation>une vitesse et une accélération positives pour chacun des %1 axes</translation>
    </message>
    <message>
        <source>a vertex number (1: the first, -1: the last one so far)</source>
        <translation>un numéro de sommet (1 pour le premier, -1 pour le dernier lu)</translation>
    </message>
    <message>
        <source>a vertex number below %1</source>
        <translation>un numéro de sommet inférieur à %1</translation>
    </message>
    <message>
        <source>a vertex number beyond the last of %1</source>
        <translation>un numéro de sommet au-delà du dernier des %1</translation>
    </message>
    <message>
        <source>a vertex with %1</source>
        <translation>sommet avec %1</translation>
    </message>
    <message>
        <source>a vertex with fewer than three coordinates</source>
        <translation>un sommet de moins de trois coordonnées</translation>
    </message>
    <message>
        <source>a vertex with the coordinate %1</source>
        <translation>sommet avec la coordonnée %1</translation>
    </message>
    <message>
        <source>a video file that can be written</source>
        <translation>une vidéo qui peut être écrite</translation>
    </message>
    <message>
        <source>a visible marker</source>
        <translation>un marqueur qui est vu</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un nombre entier</translation>
    </message>
    <message>
        <source>a whole number beyond 64 bits</source>
        <translation>un nombre entier au-delà de 64 bits</translation>
    </message>
    <message>
        <source>a whole number, %1 to %2</source>
        <translation>un nombre entier de %1 à %2</translation>
    </message>
    <message>
        <source>a whole number, 1 or more</source>
        <translation>un nombre entier à partir de 1</translation>
    </message>
    <message>
        <source>a work task of the cell, or one of %1</source>
        <translation>une tâche de la cellule, ou l'une de %1</translation>
    </message>
    <message>
        <source>a workcell document</source>
        <translation>un document de cellule</translation>
    </message>
    <message>
        <source>a workcell document (.hcell)</source>
        <translation>un document de cellule (.hcell)</translation>
    </message>
    <message>
        <source>a zip archive</source>
        <translation>une archive zip</translation>
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
        <source>above 0 with driven_axes = 6, else 0</source>
        <translation>plus de 0 avec driven_axes = 6, sinon 0</translation>
    </message>
    <message>
        <source>above 0, at most 100000</source>
        <translation>plus de 0 et au plus 100000</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>accélération</translation>
    </message>
    <message>
        <source>acceptable for nearly all</source>
        <translation>acceptable pour presque tous</translation>
    </message>
    <message>
        <source>accessor %1</source>
        <translation>accesseur %1</translation>
    </message>
    <message>
        <source>added</source>
        <translation>ajouté</translation>
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
        <source>agents %1</source>
        <translation>agents %1</translation>
    </message>
    <message>
        <source>all library robots</source>
        <translation>tous les robots de la bibliothèque</translation>
    </message>
    <message>
        <source>all of them</source>
        <translation>toutes</translation>
    </message>
    <message>
        <source>all parts are read as rigid bodies</source>
        <translation>toutes les pièces sont lues comme des corps rigides</translation>
    </message>
    <message>
        <source>all positions</source>
        <translation>toutes les positions</translation>
    </message>
    <message>
        <source>all triangles have zero area</source>
        <translation>aucun triangle d'aire non nulle</translation>
    </message>
    <message>
        <source>all, translation, rotation, or some of x y z</source>
        <translation>all, translation, rotation, ou certains de x y z</translation>
    </message>
    <message>
        <source>allowed for root</source>
        <translation>root en a le droit</translation>
    </message>
    <message>
        <source>allowed up to %1; 80 is needed</source>
        <translation>autorisée jusqu'à %1, 80 demandé</translation>
    </message>
    <message>
        <source>along %1</source>
        <translation>le long de %1</translation>
    </message>
    <message>
        <source>an 'element' before it</source>
        <translation>un 'element' avant elle</translation>
    </message>
    <message>
        <source>an FBX file</source>
        <translation>un fichier FBX</translation>
    </message>
    <message>
        <source>an IF without its ENDIF</source>
        <translation>un IF sans son ENDIF</translation>
    </message>
    <message>
        <source>an IGES file with surfaces</source>
        <translation>un fichier IGES avec des surfaces</translation>
    </message>
    <message>
        <source>an OBJ statement</source>
        <translation>une instruction OBJ</translation>
    </message>
    <message>
        <source>an SDF file</source>
        <translation>un fichier SDF</translation>
    </message>
    <message>
        <source>an absolute path</source>
        <translation>un chemin absolu</translation>
    </message>
    <message>
        <source>an acknowledgement</source>
        <translation>un accusé de réception</translation>
    </message>
    <message>
        <source>an action of the type %1</source>
        <translation>une action du type %1</translation>
    </message>
    <message>
        <source>an address of this machine and a free port</source>
        <translation>une adresse de cette machine et un port libre</translation>
    </message>
    <message>
        <source>an address of this machine only (127.0.0.1 or ::1)</source>
        <translation>une adresse de cette seule machine (127.0.0.1 ou ::1)</translation>
    </message>
    <message>
        <source>an address of this machine, such as 127.0.0.1</source>
        <translation>une adresse de cette machine, par exemple 127.0.0.1</translation>
    </message>
    <message>
        <source>an address that other machines can reach, so anybody could control the stylus</source>
        <translation>une adresse joignable par d'autres machines, où n'importe qui pourrait prendre le stylet</translation>
    </message>
    <message>
        <source>an address that other machines reach, without a code</source>
        <translation>une adresse accessible à d'autres machines, sans code</translation>
    </message>
    <message>
        <source>an angle above 0, at most 100 rad</source>
        <translation>un angle de 100 rad au plus</translation>
    </message>
    <message>
        <source>an animated actor</source>
        <translation>un acteur animé</translation>
    </message>
    <message>
        <source>an arc from an unknown position</source>
        <translation>un arc depuis une position inconnue</translation>
    </message>
    <message>
        <source>an arc or spline with one point per line; it is read as straight lines between the points.</source>
        <translation>un arc ou une spline par points isolés ; lu comme des droites entre eux.</translation>
    </message>
    <message>
        <source>an arc with an angle of zero or of too many turns</source>
        <translation>un arc d'angle nul ou de trop de tours</translation>
    </message>
    <message>
        <source>an arc with three points on a line or in the wrong order</source>
        <translation>un arc dont les trois points sont alignés, ou dans un autre ordre</translation>
    </message>
    <message>
        <source>an arc with undefined points</source>
        <translation>un arc sans points connus</translation>
    </message>
    <message>
        <source>an assembly inside itself</source>
        <translation>un assemblage à l'intérieur de lui-même</translation>
    </message>
    <message>
        <source>an assembly that holds '%1'</source>
        <translation>un assemblage qui contient « %1 »</translation>
    </message>
    <message>
        <source>an attempt</source>
        <translation>un essai</translation>
    </message>
    <message>
        <source>an axis</source>
        <translation>un axe de mouvement</translation>
    </message>
    <message>
        <source>an axis of length zero</source>
        <translation>un vecteur d'axe de longueur nulle</translation>
    </message>
    <message>
        <source>an element 'face'</source>
        <translation>un élément 'face'</translation>
    </message>
    <message>
        <source>an element 'vertex' with x, y and z</source>
        <translation>un élément 'vertex' avec x, y et z</translation>
    </message>
    <message>
        <source>an element beyond the end of the list</source>
        <translation>un élément que la liste n'a pas</translation>
    </message>
    <message>
        <source>an element that is not true or false</source>
        <translation>un élément qui n'est ni true ni false</translation>
    </message>
    <message>
        <source>an element with more than %1 attributes</source>
        <translation>un élément de plus de %1 attributs</translation>
    </message>
    <message>
        <source>an empty &lt;geometry&gt;</source>
        <translation>un &lt;geometry&gt; vide</translation>
    </message>
    <message>
        <source>an empty cell</source>
        <translation>une cellule vide</translation>
    </message>
    <message>
        <source>an empty file</source>
        <translation>un fichier vide</translation>
    </message>
    <message>
        <source>an empty list</source>
        <translation>une liste vide</translation>
    </message>
    <message>
        <source>an empty message</source>
        <translation>un message vide</translation>
    </message>
    <message>
        <source>an empty picture</source>
        <translation>une image vide</translation>
    </message>
    <message>
        <source>an empty recording</source>
        <translation>un enregistrement vide</translation>
    </message>
    <message>
        <source>an endless loop</source>
        <translation>une boucle sans fin</translation>
    </message>
    <message>
        <source>an entity (the workcell is empty)</source>
        <translation>une entité (la cellule est vide)</translation>
    </message>
    <message>
        <source>an entity of the cell</source>
        <translation>une entité de la cellule</translation>
    </message>
    <message>
        <source>an entity of the document</source>
        <translation>une entité du document</translation>
    </message>
    <message>
        <source>an entity of the workcell</source>
        <translation>un élément de la cellule</translation>
    </message>
    <message>
        <source>an entity that can be moved</source>
        <translation>une entité qui peut être déplacée</translation>
    </message>
    <message>
        <source>an error</source>
        <translation>une erreur</translation>
    </message>
    <message>
        <source>an even width and height</source>
        <translation>une largeur et une hauteur paires</translation>
    </message>
    <message>
        <source>an exact copy</source>
        <translation>une copie exacte</translation>
    </message>
    <message>
        <source>an existing entity or link</source>
        <translation>une entité ou un segment qui existe</translation>
    </message>
    <message>
        <source>an existing folder</source>
        <translation>un dossier qui existe</translation>
    </message>
    <message>
        <source>an existing name</source>
        <translation>un nom qui existe</translation>
    </message>
    <message>
        <source>an expression</source>
        <translation>une expression</translation>
    </message>
    <message>
        <source>an expression nested deeper than 100 levels</source>
        <translation>une expression imbriquée sur plus de 100 niveaux</translation>
    </message>
    <message>
        <source>an expression of more than 300 nested steps</source>
        <translation>une expression de plus de 300 étapes imbriquées</translation>
    </message>
    <message>
        <source>an expression of more than 64 kB</source>
        <translation>une expression de plus de 64 ko</translation>
    </message>
    <message>
        <source>an expression that ends too early</source>
        <translation>une expression qui se termine trop tôt</translation>
    </message>
    <message>
        <source>an expression with too many brackets</source>
        <translation>une expression avec trop de parenthèses</translation>
    </message>
    <message>
        <source>an extruded outline</source>
        <translation>un contour extrudé</translation>
    </message>
    <message>
        <source>an implicit shape</source>
        <translation>une forme implicite</translation>
    </message>
    <message>
        <source>an increased risk for some</source>
        <translation>un risque accru pour certains</translation>
    </message>
    <message>
        <source>an index</source>
        <translation>un indice</translation>
    </message>
    <message>
        <source>an index entry for byte %1, where no such record is</source>
        <translation>une entrée d’index pour l’octet %1, où cet enregistrement n’existe pas</translation>
    </message>
    <message>
        <source>an index into %1</source>
        <translation>un indice appliqué à %1</translation>
    </message>
    <message>
        <source>an index within the range</source>
        <translation>un indice dans les limites</translation>
    </message>
    <message>
        <source>an infinite plane</source>
        <translation>un plan infini</translation>
    </message>
    <message>
        <source>an integer type for the list's length</source>
        <translation>un type entier pour la longueur de la liste</translation>
    </message>
    <message>
        <source>an invalid '%' in a format text</source>
        <translation>un '%' non valide dans un texte de format</translation>
    </message>
    <message>
        <source>an invalid FOR</source>
        <translation>un FOR non valide</translation>
    </message>
    <message>
        <source>an invalid answer of the importer</source>
        <translation>une réponse de l'importateur qui n'est pas valable</translation>
    </message>
    <message>
        <source>an invalid frame</source>
        <translation>un repère non valide</translation>
    </message>
    <message>
        <source>an invalid length</source>
        <translation>une longueur non valide</translation>
    </message>
    <message>
        <source>an invalid mass</source>
        <translation>une masse non valide</translation>
    </message>
    <message>
        <source>an invalid number in the expression</source>
        <translation>un nombre mal écrit dans l'expression</translation>
    </message>
    <message>
        <source>an invalid origin (&quot;%1&quot;)</source>
        <translation>une origine non valide (&quot;%1&quot;)</translation>
    </message>
    <message>
        <source>an invalid placement</source>
        <translation>un placement qui n'est pas valable</translation>
    </message>
    <message>
        <source>an invalid pose</source>
        <translation>une pose non valide</translation>
    </message>
    <message>
        <source>an invalid quaternion</source>
        <translation>un quaternion non valide</translation>
    </message>
    <message>
        <source>an invalid radius</source>
        <translation>un rayon qui n'est pas valable</translation>
    </message>
    <message>
        <source>an invalid tolerance</source>
        <translation>une tolérance non valide</translation>
    </message>
    <message>
        <source>an invalid transform</source>
        <translation>une transformation non valide</translation>
    </message>
    <message>
        <source>an invalid vertex</source>
        <translation>un sommet non valide</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>un objet</translation>
    </message>
    <message>
        <source>an object of more than %1 members</source>
        <translation>un objet de plus de %1 membres</translation>
    </message>
    <message>
        <source>an object of this part</source>
        <translation>un objet de cet élément</translation>
    </message>
    <message>
        <source>an object that does not exist</source>
        <translation>un objet qui n'existe pas</translation>
    </message>
    <message>
        <source>an object with fields</source>
        <translation>un objet avec des champs</translation>
    </message>
    <message>
        <source>an open chain of joints</source>
        <translation>une chaîne ouverte d'axes</translation>
    </message>
    <message>
        <source>an option that --help lists</source>
        <translation>l'une de celles que --help énumère</translation>
    </message>
    <message>
        <source>an undamaged %1 file</source>
        <translation>un fichier %1 intact</translation>
    </message>
    <message>
        <source>an undamaged file</source>
        <translation>un fichier intact</translation>
    </message>
    <message>
        <source>an undamaged mesh</source>
        <translation>un maillage intact</translation>
    </message>
    <message>
        <source>an undefined element of '%1'</source>
        <translation>un élément de '%1' qui n'a pas de valeur</translation>
    </message>
    <message>
        <source>an unexpected error: %1</source>
        <translation>une erreur imprévue : %1</translation>
    </message>
    <message>
        <source>an unexpected file</source>
        <translation>un fichier inattendu</translation>
    </message>
    <message>
        <source>an unexpected or repeated file</source>
        <translation>un fichier inattendu ou répété</translation>
    </message>
    <message>
        <source>an unknown compression</source>
        <translation>il est compressé d'une façon inconnue</translation>
    </message>
    <message>
        <source>an unknown joint type</source>
        <translation>un type d'axe inconnu</translation>
    </message>
    <message>
        <source>an unknown user</source>
        <translation>un utilisateur inconnu</translation>
    </message>
    <message>
        <source>an unsupported picture format</source>
        <translation>un format d'image qui ne peut pas être écrit</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>et %1 de plus</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>angle</translation>
    </message>
    <message>
        <source>angles of the motion are in degrees, as the AMC states; angles of the skeleton are in radians</source>
        <translation>les angles du mouvement sont en degrés, comme l'indique l'AMC ; ceux du squelette sont en radians</translation>
    </message>
    <message>
        <source>angles of the motion are in radians, as the AMC states; angles of the skeleton are in degrees</source>
        <translation>les angles du mouvement sont en radians, comme l'indique l'AMC ; ceux du squelette sont en degrés</translation>
    </message>
    <message>
        <source>animation; all parts are shown at rest</source>
        <translation>du mouvement ; tout est affiché au repos</translation>
    </message>
    <message>
        <source>another assembly</source>
        <translation>un autre assemblage</translation>
    </message>
    <message>
        <source>another clicked</source>
        <translation>un autre cliqué</translation>
    </message>
    <message>
        <source>another entity</source>
        <translation>une autre entité</translation>
    </message>
    <message>
        <source>another entity or other joints</source>
        <translation>une autre entité ou d'autres axes</translation>
    </message>
    <message>
        <source>another entity to attach it to</source>
        <translation>une autre entité à laquelle l'attacher</translation>
    </message>
    <message>
        <source>another format</source>
        <translation>un autre format</translation>
    </message>
    <message>
        <source>another joint</source>
        <translation>un autre axe</translation>
    </message>
    <message>
        <source>another kind of entity</source>
        <translation>une entité d'un autre type</translation>
    </message>
    <message>
        <source>another name than %1</source>
        <translation>un autre nom que %1</translation>
    </message>
    <message>
        <source>another program writes into this file</source>
        <translation>un autre programme écrit dans ce fichier</translation>
    </message>
    <message>
        <source>another version</source>
        <translation>une autre version</translation>
    </message>
    <message>
        <source>any text</source>
        <translation>un texte quelconque</translation>
    </message>
    <message>
        <source>approach or retract</source>
        <translation>approche ou dégagement</translation>
    </message>
    <message>
        <source>arguments</source>
        <translation>arguments</translation>
    </message>
    <message>
        <source>arms, legs and a trunk with lengths above 0</source>
        <translation>des bras, des jambes et un tronc de longueur non nulle</translation>
    </message>
    <message>
        <source>as in the controller</source>
        <translation>celui de la commande</translation>
    </message>
    <message>
        <source>as many values as the others</source>
        <translation>autant de valeurs que les autres</translation>
    </message>
    <message>
        <source>assembly '%1'</source>
        <translation>assemblage '%1'</translation>
    </message>
    <message>
        <source>at %1 s</source>
        <translation>à %1 s</translation>
    </message>
    <message>
        <source>at frame %1</source>
        <translation>à l'image %1</translation>
    </message>
    <message>
        <source>at its start</source>
        <translation>à son début</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>au moins %1</translation>
    </message>
    <message>
        <source>at least one</source>
        <translation>au moins un</translation>
    </message>
    <message>
        <source>at least one &lt;link&gt;</source>
        <translation>au moins un &lt;link&gt;</translation>
    </message>
    <message>
        <source>at least one [[vary]] with from and to, without steps</source>
        <translation>au moins un [[vary]] avec from et to, sans steps</translation>
    </message>
    <message>
        <source>at least one frame</source>
        <translation>au moins une image</translation>
    </message>
    <message>
        <source>at least one marker</source>
        <translation>au moins un marqueur</translation>
    </message>
    <message>
        <source>at least one motion that is switched on</source>
        <translation>au moins un mouvement activé</translation>
    </message>
    <message>
        <source>at least one number</source>
        <translation>au moins un nombre</translation>
    </message>
    <message>
        <source>at least one part that can be read</source>
        <translation>au moins une pièce lisible</translation>
    </message>
    <message>
        <source>at least one part, such as a table or a fixture</source>
        <translation>au moins une pièce, par exemple une table ou un montage</translation>
    </message>
    <message>
        <source>at least one pose</source>
        <translation>au moins une pose</translation>
    </message>
    <message>
        <source>at least one results file</source>
        <translation>au moins un fichier de résultats</translation>
    </message>
    <message>
        <source>at least one solid</source>
        <translation>au moins un solide</translation>
    </message>
    <message>
        <source>at least one solid or surface</source>
        <translation>au moins un solide ou une surface</translation>
    </message>
    <message>
        <source>at least one table [[agent]]</source>
        <translation>au moins une table [[agent]]</translation>
    </message>
    <message>
        <source>at least one table [[objective]]</source>
        <translation>au moins une table [[objective]]</translation>
    </message>
    <message>
        <source>at least one target</source>
        <translation>au moins une cible</translation>
    </message>
    <message>
        <source>at least one text</source>
        <translation>au moins un texte</translation>
    </message>
    <message>
        <source>at least one value</source>
        <translation>au moins une valeur</translation>
    </message>
    <message>
        <source>at least the 84 bytes of a binary STL's header</source>
        <translation>au moins les 84 octets de l'en-tête d'un STL binaire</translation>
    </message>
    <message>
        <source>at least the time of the line before</source>
        <translation>au moins la valeur de la ligne précédente</translation>
    </message>
    <message>
        <source>at least two</source>
        <translation>au moins deux</translation>
    </message>
    <message>
        <source>at least two different frames</source>
        <translation>au moins deux images différentes</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>au plus %1</translation>
    </message>
    <message>
        <source>at most %1 MB</source>
        <translation>au plus %1 Mo</translation>
    </message>
    <message>
        <source>at most %1 bytes</source>
        <translation>au plus %1 octets</translation>
    </message>
    <message>
        <source>at most %1 independent actuated joints</source>
        <translation>au plus %1 axes indépendants</translation>
    </message>
    <message>
        <source>at most %1 levels</source>
        <translation>au plus %1 niveaux</translation>
    </message>
    <message>
        <source>at most %1 m and %2 rad</source>
        <translation>au plus %1 m, %2 rad</translation>
    </message>
    <message>
        <source>at most %1, the limit of an INFORM job</source>
        <translation>au plus %1, ce qu'un job INFORM peut contenir</translation>
    </message>
    <message>
        <source>at most %1, the number that fits the file size</source>
        <translation>au plus les %1 que permet la longueur du fichier</translation>
    </message>
    <message>
        <source>at most 1 GB and 200 times the packed size</source>
        <translation>au plus 1 Go et 200 fois la taille compressée</translation>
    </message>
    <message>
        <source>at most 1, the newest version that this program can read</source>
        <translation>au plus 1, la plus récente que ce programme connaît</translation>
    </message>
    <message>
        <source>at most 1000</source>
        <translation>au plus 1000</translation>
    </message>
    <message>
        <source>at most 10000</source>
        <translation>au plus 10000</translation>
    </message>
    <message>
        <source>at most 16</source>
        <translation>au plus 16</translation>
    </message>
    <message>
        <source>at most 1e12 m</source>
        <translation>au plus 1e12 m</translation>
    </message>
    <message>
        <source>at most 2 GB</source>
        <translation>au plus 2 Go</translation>
    </message>
    <message>
        <source>at most 2 m/s</source>
        <translation>au plus 2 m/s</translation>
    </message>
    <message>
        <source>at most 200000 as STEP faces</source>
        <translation>au plus 200000 comme faces STEP</translation>
    </message>
    <message>
        <source>at most 2000000</source>
        <translation>au plus 2000000</translation>
    </message>
    <message>
        <source>at most 24</source>
        <translation>au plus 24</translation>
    </message>
    <message>
        <source>at most 4 GB and 200 times the packed size</source>
        <translation>au plus 4 Go et 200 fois la taille compressée</translation>
    </message>
    <message>
        <source>at most 50 nested calls</source>
        <translation>au plus 50 imbriquées</translation>
    </message>
    <message>
        <source>at most 5000</source>
        <translation>au plus 5000</translation>
    </message>
    <message>
        <source>at most 9e9 s</source>
        <translation>au plus 9e9 s</translation>
    </message>
    <message>
        <source>at most peak_force, %1</source>
        <translation>au plus peak_force, %1</translation>
    </message>
    <message>
        <source>at the start %1 is %2 deep in %3 (%4); move %5 out of it</source>
        <translation>au départ, %1 est enfoncé de %2 dans %3 (%4) ; sortez %5 de là</translation>
    </message>
    <message>
        <source>at the start %1 is %2 from %3, nearer than the clearance of %4</source>
        <translation>au départ, %1 est à %2 de %3, plus près que la distance de passage de %4</translation>
    </message>
    <message>
        <source>at the start %1 is too deep in %2 (%3); move %4 out of it</source>
        <translation>au départ, %1 est enfoncé trop profondément dans %2 (%3) ; sortez %4 de là</translation>
    </message>
    <message>
        <source>at the start %1 touches %2</source>
        <translation>au départ, %1 touche %2</translation>
    </message>
    <message>
        <source>at work</source>
        <translation>au travail</translation>
    </message>
    <message>
        <source>at_least or at_most</source>
        <translation>at_least ou at_most</translation>
    </message>
    <message>
        <source>attachment, not read: %1</source>
        <translation>pièce jointe, non lue : %1</translation>
    </message>
    <message>
        <source>attempt %1</source>
        <translation>essai %1</translation>
    </message>
    <message>
        <source>axes</source>
        <translation>axes</translation>
    </message>
    <message>
        <source>axis = &quot;z&quot;, or direction = [x, y, z]</source>
        <translation>axis = &quot;z&quot;, ou direction = [x, y, z]</translation>
    </message>
    <message>
        <source>back</source>
        <translation>derrière</translation>
    </message>
    <message>
        <source>base</source>
        <translation>base</translation>
    </message>
    <message>
        <source>base_radius, upper_arm, lower_arm and platform_radius above 0</source>
        <translation>base_radius, upper_arm, lower_arm et platform_radius supérieurs à 0</translation>
    </message>
    <message>
        <source>bash, zsh or fish</source>
        <translation>bash, zsh ou fish</translation>
    </message>
    <message>
        <source>beginning</source>
        <translation>début</translation>
    </message>
    <message>
        <source>best</source>
        <translation>best</translation>
    </message>
    <message>
        <source>best %1</source>
        <translation>meilleur %1</translation>
    </message>
    <message>
        <source>blend</source>
        <translation>rayon de raccordement</translation>
    </message>
    <message>
        <source>bodies = [...]</source>
        <translation>bodies = [...]</translation>
    </message>
    <message>
        <source>bodies such as &quot;female:5&quot; or &quot;male:1750mm&quot;</source>
        <translation>des corps tels que &quot;female:5&quot; ou &quot;male:1750mm&quot;</translation>
    </message>
    <message>
        <source>bones and shape morphing; the mesh is shown as modelled</source>
        <translation>des os et des mélanges de formes ; le maillage est affiché tel que modélisé</translation>
    </message>
    <message>
        <source>bones of length zero</source>
        <translation>des os de longueur nulle</translation>
    </message>
    <message>
        <source>bones that slide or change length are kept as in the rest pose</source>
        <translation>les os qui glissent ou s'allongent sont pris comme au repos</translation>
    </message>
    <message>
        <source>bones; the mesh is shown as modelled</source>
        <translation>des os ; le maillage est affiché tel que modélisé</translation>
    </message>
    <message>
        <source>both --percentile and --stature</source>
        <translation>à la fois --percentile et --stature</translation>
    </message>
    <message>
        <source>both [%1] and [%2]</source>
        <translation>à la fois [%1] et [%2]</translation>
    </message>
    <message>
        <source>both [sampling] and [search]</source>
        <translation>à la fois [sampling] et [search]</translation>
    </message>
    <message>
        <source>both are given</source>
        <translation>les deux sont donnés</translation>
    </message>
    <message>
        <source>both joints of the leg are at the same point</source>
        <translation>les deux articulations de la jambe sont au même point</translation>
    </message>
    <message>
        <source>both library and values</source>
        <translation>à la fois library et values</translation>
    </message>
    <message>
        <source>box:, table:, fence: or another built-in part</source>
        <translation>box:, table:, fence: ou une autre pièce paramétrique</translation>
    </message>
    <message>
        <source>buffer %1</source>
        <translation>tampon (buffer) %1</translation>
    </message>
    <message>
        <source>buffer view %1</source>
        <translation>vue de tampon (buffer view) %1</translation>
    </message>
    <message>
        <source>by %1</source>
        <translation>de %1</translation>
    </message>
    <message>
        <source>byte %1</source>
        <translation>octet %1</translation>
    </message>
    <message>
        <source>bytes that are not text</source>
        <translation>des octets qui ne sont pas un texte</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>annulé</translation>
    </message>
    <message>
        <source>cannot listen at this address: %1</source>
        <translation>écoute impossible à cette adresse : %1</translation>
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
        <source>changes by the methods of the cell</source>
        <translation>des modifications par les méthodes de la cellule</translation>
    </message>
    <message>
        <source>changes to the included model</source>
        <translation>des changements du modèle inclus</translation>
    </message>
    <message>
        <source>channel %1 twice, with different content</source>
        <translation>le canal %1 deux fois, avec des contenus différents</translation>
    </message>
    <message>
        <source>channels of the joints</source>
        <translation>des canaux des articulations</translation>
    </message>
    <message>
        <source>check cancelled</source>
        <translation>vérification interrompue</translation>
    </message>
    <message>
        <source>check of the written program</source>
        <translation>contrôle du programme écrit</translation>
    </message>
    <message>
        <source>checked</source>
        <translation>vérifié</translation>
    </message>
    <message>
        <source>checking</source>
        <translation>vérification</translation>
    </message>
    <message>
        <source>chord</source>
        <translation>flèche</translation>
    </message>
    <message>
        <source>chunk</source>
        <translation>bloc (chunk)</translation>
    </message>
    <message>
        <source>chunks %1 failed %2 times</source>
        <translation>les morceaux %1 ont échoué %2 fois</translation>
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
        <source>collecting</source>
        <translation>collecte des pièces</translation>
    </message>
    <message>
        <source>columns of each body without bodies</source>
        <translation>des colonnes de chaque corps sans corps</translation>
    </message>
    <message>
        <source>columns x, y, z</source>
        <translation>colonnes x, y, z</translation>
    </message>
    <message>
        <source>comb() or perm() of a negative number</source>
        <translation>comb() ou perm() appliqué à un nombre négatif</translation>
    </message>
    <message>
        <source>complete results of every chunk</source>
        <translation>des résultats complets de chaque morceau</translation>
    </message>
    <message>
        <source>completion</source>
        <translation>completion</translation>
    </message>
    <message>
        <source>components that contain each other</source>
        <translation>des composants qui se contiennent l'un l'autre</translation>
    </message>
    <message>
        <source>components without cycles</source>
        <translation>des composants sans cycle</translation>
    </message>
    <message>
        <source>compressed records</source>
        <translation>des enregistrements comprimés</translation>
    </message>
    <message>
        <source>consecutive frame numbers</source>
        <translation>des images qui se suivent</translation>
    </message>
    <message>
        <source>constant, contact or dynamics</source>
        <translation>constant, contact ou dynamics</translation>
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
        <source>contacts of the session, not read: %1</source>
        <translation>contacts de la session, non lus : %1</translation>
    </message>
    <message>
        <source>contacts: %1</source>
        <translation>contacts : %1</translation>
    </message>
    <message>
        <source>content of an unknown type</source>
        <translation>un contenu d'un type inconnu</translation>
    </message>
    <message>
        <source>content that is not of this format</source>
        <translation>un contenu qui n'est pas de ce format</translation>
    </message>
    <message>
        <source>content that makes the SDF library crash</source>
        <translation>un contenu qui fait échouer la bibliothèque SDF</translation>
    </message>
    <message>
        <source>content that makes the reader crash</source>
        <translation>un contenu qui fait échouer le lecteur</translation>
    </message>
    <message>
        <source>control_msgs/action/FollowJointTrajectory</source>
        <translation>control_msgs/action/FollowJointTrajectory</translation>
    </message>
    <message>
        <source>counts that fit the file</source>
        <translation>des nombres d'éléments conformes au fichier</translation>
    </message>
    <message>
        <source>csv, json, ros, krl, rapid, fanuc, urscript, val3 or inform</source>
        <translation>csv, json, ros, krl, rapid, fanuc, urscript, val3 ou inform</translation>
    </message>
    <message>
        <source>current</source>
        <translation>actuelle</translation>
    </message>
    <message>
        <source>curves</source>
        <translation>des courbes</translation>
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
        <source>data of EXT_meshopt_compression that cannot be decompressed</source>
        <translation>des données de EXT_meshopt_compression impossibles à décompresser</translation>
    </message>
    <message>
        <source>data that cannot be decompressed (%1)</source>
        <translation>des données impossibles à décompresser (%1)</translation>
    </message>
    <message>
        <source>data that is not in the database</source>
        <translation>des données que la base de données n'a pas</translation>
    </message>
    <message>
        <source>deg or rad</source>
        <translation>deg ou rad</translation>
    </message>
    <message>
        <source>degrees or a length</source>
        <translation>des degrés, ou une longueur</translation>
    </message>
    <message>
        <source>delay: median %1 ms, maximum %2 ms, contacts: %3; up to %4 ms is not noticeable</source>
        <translation>délai : médiane %1 ms, maximum %2 ms, contacts : %3 ; jusqu'à %4 ms, imperceptible</translation>
    </message>
    <message>
        <source>device</source>
        <translation>périphérique</translation>
    </message>
    <message>
        <source>dict() of values that are not pairs</source>
        <translation>dict() appliqué à autre chose que des paires</translation>
    </message>
    <message>
        <source>different content</source>
        <translation>un contenu différent</translation>
    </message>
    <message>
        <source>digit %1 (%2) is '%3'</source>
        <translation>le chiffre %1 (%2) est '%3'</translation>
    </message>
    <message>
        <source>directions of non-zero length that are not parallel</source>
        <translation>des directions de longueur non nulle et non parallèles</translation>
    </message>
    <message>
        <source>dist() of points with different dimensions</source>
        <translation>dist() appliqué à des points de dimensions différentes</translation>
    </message>
    <message>
        <source>down</source>
        <translation>bas</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>dessin</translation>
    </message>
    <message>
        <source>duplicate triangles, kept once in a workcell</source>
        <translation>triangles en double, laissés de côté une fois dans une cellule</translation>
    </message>
    <message>
        <source>duration</source>
        <translation>durée</translation>
    </message>
    <message>
        <source>dwell</source>
        <translation>temporisation</translation>
    </message>
    <message>
        <source>each agent once</source>
        <translation>chaque agent une seule fois</translation>
    </message>
    <message>
        <source>each bone of :bonedata once</source>
        <translation>chaque os de :bonedata une fois</translation>
    </message>
    <message>
        <source>each bone once</source>
        <translation>chaque os une seule fois</translation>
    </message>
    <message>
        <source>each chunk once</source>
        <translation>chaque morceau une fois</translation>
    </message>
    <message>
        <source>each element once</source>
        <translation>chaque élément une seule fois</translation>
    </message>
    <message>
        <source>each entity on one side only: an entity is not checked against itself</source>
        <translation>chaque entité une seule fois : rien n'est vérifié par rapport à soi-même</translation>
    </message>
    <message>
        <source>each hand once per step</source>
        <translation>chaque main une fois par étape</translation>
    </message>
    <message>
        <source>each joint once</source>
        <translation>chaque axe une fois</translation>
    </message>
    <message>
        <source>each key at most once</source>
        <translation>chaque clé une fois</translation>
    </message>
    <message>
        <source>each name once</source>
        <translation>chaque nom une seule fois</translation>
    </message>
    <message>
        <source>each option at most once</source>
        <translation>chaque option une fois</translation>
    </message>
    <message>
        <source>each wrist has one marker; neither pronation nor supination of the forearms is assumed</source>
        <translation>les poignets ont un seul marqueur ; les avant-bras sont supposés ni en pronation ni en supination</translation>
    </message>
    <message>
        <source>each_body = true</source>
        <translation>each_body = true</translation>
    </message>
    <message>
        <source>either targets = &quot;poses.csv&quot; or frames = [...]</source>
        <translation>soit targets = &quot;poses.csv&quot;, soit frames = [...]</translation>
    </message>
    <message>
        <source>either values, or from and to (with steps), or sigma (with middle)</source>
        <translation>soit values, soit from et to (avec steps), soit sigma (avec middle)</translation>
    </message>
    <message>
        <source>elements nested deeper than %1</source>
        <translation>des éléments imbriqués sur plus de %1 niveaux</translation>
    </message>
    <message>
        <source>elements, macros or expressions nested too deeply</source>
        <translation>des éléments, macros ou expressions trop imbriqués</translation>
    </message>
    <message>
        <source>endless jumps</source>
        <translation>des sauts sans fin</translation>
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
        <source>entity</source>
        <translation>entité</translation>
    </message>
    <message>
        <source>entity %1</source>
        <translation>entité %1</translation>
    </message>
    <message>
        <source>entity '%1'</source>
        <translation>entité '%1'</translation>
    </message>
    <message>
        <source>entity '%1' is packed without its file, because the file could not be read</source>
        <translation>l'entité '%1' est archivée sans son fichier, qui n'a pas pu être lu</translation>
    </message>
    <message>
        <source>entity '%1' of another kind</source>
        <translation>l'entité « %1 » d'un autre genre</translation>
    </message>
    <message>
        <source>entity '%1' without joints</source>
        <translation>l'entité « %1 » sans articulations</translation>
    </message>
    <message>
        <source>entity '%1', link '%2'</source>
        <translation>entité '%1', segment '%2'</translation>
    </message>
    <message>
        <source>entity '%1': its &quot;placement&quot; does not match its attachment to '%2'; the attachment is used</source>
        <translation>entité '%1' : son &quot;placement&quot; n'est pas là où elle est attachée à '%2' ; elle est placée là où elle est attachée</translation>
    </message>
    <message>
        <source>entity = &quot;...&quot; or entities = [...]</source>
        <translation>entity = &quot;...&quot; ou entities = [...]</translation>
    </message>
    <message>
        <source>entry '%1'</source>
        <translation>entrée '%1'</translation>
    </message>
    <message>
        <source>equal results</source>
        <translation>des résultats égaux</translation>
    </message>
    <message>
        <source>error, warning, info or debug</source>
        <translation>error, warning, info ou debug</translation>
    </message>
    <message>
        <source>everything that was packed</source>
        <translation>tout ce qui a été archivé</translation>
    </message>
    <message>
        <source>exact surfaces</source>
        <translation>des surfaces exactes</translation>
    </message>
    <message>
        <source>exactly one of these options</source>
        <translation>exactement une de ces options</translation>
    </message>
    <message>
        <source>exactly one robot in a URDF</source>
        <translation>un seul, car un URDF n'en contient pas plus</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>exclu</translation>
    </message>
    <message>
        <source>exit status %1</source>
        <translation>code de sortie %1</translation>
    </message>
    <message>
        <source>expected %1</source>
        <translation>attendu : %1</translation>
    </message>
    <message>
        <source>extensions that docs/user/formats.md lists</source>
        <translation>des extensions listées dans docs/user/formats.md</translation>
    </message>
    <message>
        <source>extensionsRequired</source>
        <translation>extensionsRequired</translation>
    </message>
    <message>
        <source>face %1 of %2</source>
        <translation>face %1 sur %2</translation>
    </message>
    <message>
        <source>face corner %1</source>
        <translation>coin de face %1</translation>
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
        <source>fewer</source>
        <translation>un nombre plus petit</translation>
    </message>
    <message>
        <source>fewer nested levels</source>
        <translation>moins de niveaux</translation>
    </message>
    <message>
        <source>fewer repeated nodes</source>
        <translation>moins de nœuds répétés</translation>
    </message>
    <message>
        <source>fewer starts or evaluations</source>
        <translation>moins de départs ou d'évaluations</translation>
    </message>
    <message>
        <source>fewer than a million</source>
        <translation>moins d'un million</translation>
    </message>
    <message>
        <source>fewer than two different frames</source>
        <translation>moins de deux images différentes</translation>
    </message>
    <message>
        <source>fewer values, or samples</source>
        <translation>moins de valeurs, ou un échantillonnage</translation>
    </message>
    <message>
        <source>ffmpeg</source>
        <translation>ffmpeg</translation>
    </message>
    <message>
        <source>field '%1'</source>
        <translation>champ '%1'</translation>
    </message>
    <message>
        <source>file %1: %2</source>
        <translation>fichier %1 : %2</translation>
    </message>
    <message>
        <source>file missing</source>
        <translation>fichier manquant</translation>
    </message>
    <message>
        <source>files in this folder cannot be locked</source>
        <translation>aucun fichier ne peut y être verrouillé</translation>
    </message>
    <message>
        <source>files inside %1</source>
        <translation>des fichiers à l'intérieur de %1</translation>
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
        <source>finite numbers</source>
        <translation>des nombres finis</translation>
    </message>
    <message>
        <source>finite numbers and a quaternion of length 1</source>
        <translation>des nombres finis et un quaternion de norme 1</translation>
    </message>
    <message>
        <source>finite numbers and a unit quaternion</source>
        <translation>des nombres finis et un quaternion unitaire</translation>
    </message>
    <message>
        <source>finite numbers for all joints</source>
        <translation>des nombres finis pour toutes les articulations</translation>
    </message>
    <message>
        <source>finite numbers of a plausible size</source>
        <translation>des nombres finis d'une grandeur vraisemblable</translation>
    </message>
    <message>
        <source>finite numbers separated by commas</source>
        <translation>des nombres finis séparés par des virgules</translation>
    </message>
    <message>
        <source>finite numbers within the bounds of docs/library/protocol.md, a unit quaternion, a zone above 0, and no negative stiffness, damping or friction</source>
        <translation>des nombres finis dans les limites de docs/library/protocol.md, un quaternion unitaire, une zone positive, ni raideur, ni amortissement, ni frottement négatifs</translation>
    </message>
    <message>
        <source>finite numbers, 0 or more</source>
        <translation>des nombres finis, 0 ou plus</translation>
    </message>
    <message>
        <source>finite numbers, and a minimum below the maximum</source>
        <translation>des nombres finis, et un minimum inférieur au maximum</translation>
    </message>
    <message>
        <source>finite numbers, at most 1 000 000 m, and a unit quaternion</source>
        <translation>des nombres finis à moins d'un million de mètres et un quaternion unitaire</translation>
    </message>
    <message>
        <source>finite numbers, within 1e12 m</source>
        <translation>des nombres finis, à moins de 1e12 m</translation>
    </message>
    <message>
        <source>first chunk</source>
        <translation>premier bloc (chunk)</translation>
    </message>
    <message>
        <source>flip</source>
        <translation>ret.</translation>
    </message>
    <message>
        <source>float(&quot;%1&quot;)</source>
        <translation>float(&quot;%1&quot;)</translation>
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
        <source>force_x, force_y, force_z, contact or configuration</source>
        <translation>force_x, force_y, force_z, contact ou configuration</translation>
    </message>
    <message>
        <source>forces off</source>
        <translation>coupe les efforts</translation>
    </message>
    <message>
        <source>format %1</source>
        <translation>format %1</translation>
    </message>
    <message>
        <source>four digits: back, arms, legs, load</source>
        <translation>quatre chiffres : dos, bras, jambes, charge</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>image %1</translation>
    </message>
    <message>
        <source>frame %1 after frame %2</source>
        <translation>l'image %1 après l'image %2</translation>
    </message>
    <message>
        <source>frame %1 is called '%2'</source>
        <translation>l'image %1 s'appelle '%2'</translation>
    </message>
    <message>
        <source>frame %1 ms</source>
        <translation>image %1 ms</translation>
    </message>
    <message>
        <source>frame length</source>
        <translation>longueur de trame</translation>
    </message>
    <message>
        <source>frame moved</source>
        <translation>image déplacée</translation>
    </message>
    <message>
        <source>frame with frames, which have their own places</source>
        <translation>frame avec frames, qui ont leurs propres places</translation>
    </message>
    <message>
        <source>frame: alone</source>
        <translation>frame: seul</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>images</translation>
    </message>
    <message>
        <source>frames at least a nanosecond apart</source>
        <translation>des points espacés d’au moins une nanoseconde</translation>
    </message>
    <message>
        <source>frames of the cell; remove it from the list</source>
        <translation>des repères de la cellule ; retirez-le de la liste</translation>
    </message>
    <message>
        <source>frames per second above 0</source>
        <translation>un nombre d'images par seconde supérieur à 0</translation>
    </message>
    <message>
        <source>frames, samples or scores</source>
        <translation>des points, des échantillons ou des notes</translation>
    </message>
    <message>
        <source>frames: %1</source>
        <translation>images : %1</translation>
    </message>
    <message>
        <source>free space and permission to write</source>
        <translation>de l'espace libre et le droit d'écrire</translation>
    </message>
    <message>
        <source>free space and permission to write the file</source>
        <translation>de l'espace libre et le droit d'écrire le fichier</translation>
    </message>
    <message>
        <source>free space in the folder TMPDIR</source>
        <translation>de l'espace libre dans le dossier TMPDIR</translation>
    </message>
    <message>
        <source>free space, and the name of a new or empty folder</source>
        <translation>de l'espace libre et le nom d'un dossier nouveau ou vide</translation>
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
        <source>given without --motion</source>
        <translation>donné sans --motion</translation>
    </message>
    <message>
        <source>glTF (*.glb)</source>
        <translation>glTF (*.glb)</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>but</translation>
    </message>
    <message>
        <source>good, fair or poor</source>
        <translation>good, fair ou poor</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>grille</translation>
    </message>
    <message>
        <source>guide %1</source>
        <translation>guide virtuel %1</translation>
    </message>
    <message>
        <source>guide '%1'</source>
        <translation>guide virtuel '%1'</translation>
    </message>
    <message>
        <source>guides</source>
        <translation>guides</translation>
    </message>
    <message>
        <source>h</source>
        <translation>h</translation>
    </message>
    <message>
        <source>hand:left or hand:right, and :SEX:PERCENTILE</source>
        <translation>hand:left ou hand:right, et :SEX:PERCENTILE</translation>
    </message>
    <message>
        <source>handing over</source>
        <translation>transmission</translation>
    </message>
    <message>
        <source>hapticell-haptic-server --help lists the options.</source>
        <translation>Lancez hapticell-haptic-server --help pour la liste des options.</translation>
    </message>
    <message>
        <source>hapticell-ros2 gave no result</source>
        <translation>hapticell-ros2 n’a donné aucun résultat</translation>
    </message>
    <message>
        <source>head</source>
        <translation>tête</translation>
    </message>
    <message>
        <source>header</source>
        <translation>en-tête</translation>
    </message>
    <message>
        <source>header and parameters disagree on the number format; integers match the file size and are read</source>
        <translation>l'en-tête et les paramètres indiquent des types de nombres différents ; les nombres entiers remplissent le fichier</translation>
    </message>
    <message>
        <source>header and parameters disagree on the number format; real numbers match the file size and are read</source>
        <translation>l'en-tête et les paramètres indiquent des types de nombres différents ; les nombres réels remplissent le fichier</translation>
    </message>
    <message>
        <source>header and parameters disagree on where the points begin; they are read from byte %1</source>
        <translation>le début des points n'est pas indiqué deux fois de la même façon ; ils sont lus à partir de l'octet %1</translation>
    </message>
    <message>
        <source>held</source>
        <translation>tenu</translation>
    </message>
    <message>
        <source>hexapod '%1'</source>
        <translation>hexapode '%1'</translation>
    </message>
    <message>
        <source>hexapod '%1', %2</source>
        <translation>hexapode '%1', %2</translation>
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
        <source>holes in the surface</source>
        <translation>trous dans la surface</translation>
    </message>
    <message>
        <source>how many elements '%1' follow</source>
        <translation>le nombre d'éléments '%1' qui suivent</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>au repos</translation>
    </message>
    <message>
        <source>in %1 of %2 frames, no marker is visible; the person is assumed to stand still or to move straight, and these frames count like others</source>
        <translation>dans %1 images sur %2, aucun marqueur de la personne n'est vu ; elle y est supposée immobile ou en ligne droite, et ces images comptent comme les autres</translation>
    </message>
    <message>
        <source>in balance</source>
        <translation>en équilibre</translation>
    </message>
    <message>
        <source>in several pieces</source>
        <translation>en plusieurs morceaux</translation>
    </message>
    <message>
        <source>in several pieces, %1</source>
        <translation>en plusieurs morceaux, %1</translation>
    </message>
    <message>
        <source>in the file, %1 points up; the model was rotated so that z points up</source>
        <translation>le fichier a %1 vers le haut ; il a été tourné pour que z soit vers le haut</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>pouce</translation>
    </message>
    <message>
        <source>inconsistent content</source>
        <translation>un contenu contradictoire</translation>
    </message>
    <message>
        <source>inconsistent content (%1)</source>
        <translation>un contenu contradictoire (%1)</translation>
    </message>
    <message>
        <source>increasing times in seconds</source>
        <translation>des temps croissants, en s</translation>
    </message>
    <message>
        <source>int(&quot;%1&quot;)</source>
        <translation>int(&quot;%1&quot;)</translation>
    </message>
    <message>
        <source>int(%1)</source>
        <translation>int(%1)</translation>
    </message>
    <message>
        <source>invalid JSON</source>
        <translation>JSON non valide</translation>
    </message>
    <message>
        <source>invalid XML (%1)</source>
        <translation>XML non valide (%1)</translation>
    </message>
    <message>
        <source>invalid YAML</source>
        <translation>YAML non valide</translation>
    </message>
    <message>
        <source>invalid YAML (%1)</source>
        <translation>YAML non valide (%1)</translation>
    </message>
    <message>
        <source>invalid dimensions '%1'</source>
        <translation>des dimensions inutilisables : '%1'</translation>
    </message>
    <message>
        <source>invalid number for '%1': '%2'</source>
        <translation>pas un nombre pour '%1' : '%2'</translation>
    </message>
    <message>
        <source>invalid positions</source>
        <translation>des positions qui n'en sont pas</translation>
    </message>
    <message>
        <source>invalid signs</source>
        <translation>des signes qui ne sont pas valables</translation>
    </message>
    <message>
        <source>inverse: %1</source>
        <translation>inverse : %1</translation>
    </message>
    <message>
        <source>is left out: a shape &lt;%1&gt; without size</source>
        <translation>omis : une forme &lt;%1&gt; sans taille</translation>
    </message>
    <message>
        <source>isqrt() of a negative number</source>
        <translation>isqrt() appliqué à un nombre négatif</translation>
    </message>
    <message>
        <source>it belongs to %1</source>
        <translation>il appartient à %1</translation>
    </message>
    <message>
        <source>it belongs to user %1</source>
        <translation>il appartient à l'utilisateur %1</translation>
    </message>
    <message>
        <source>it beside hapticell-cli</source>
        <translation>ce programme à côté de hapticell-cli</translation>
    </message>
    <message>
        <source>it cannot be loaded</source>
        <translation>il ne peut pas être chargé</translation>
    </message>
    <message>
        <source>it cannot be read</source>
        <translation>lecture impossible</translation>
    </message>
    <message>
        <source>it cannot be read (%1)</source>
        <translation>il n'est pas lisible (%1)</translation>
    </message>
    <message>
        <source>it cannot be read back</source>
        <translation>relecture impossible</translation>
    </message>
    <message>
        <source>it cannot be read: %1</source>
        <translation>lecture impossible : %1</translation>
    </message>
    <message>
        <source>it cannot be written</source>
        <translation>écriture impossible</translation>
    </message>
    <message>
        <source>it contains itself</source>
        <translation>il se contient lui-même</translation>
    </message>
    <message>
        <source>it contains no shape that can be built</source>
        <translation>aucune forme n'a pu en être tirée</translation>
    </message>
    <message>
        <source>it contains only tessellated shapes (%1, triangles as in AP242), which are not supported</source>
        <translation>il ne contient que des formes tessellées (%1, triangles selon AP242), qui ne sont pas lues</translation>
    </message>
    <message>
        <source>it could not be started</source>
        <translation>il n'a pas pu être lancé</translation>
    </message>
    <message>
        <source>it could not be written</source>
        <translation>impossible d'y écrire</translation>
    </message>
    <message>
        <source>it did not finish</source>
        <translation>il ne s'est pas terminé</translation>
    </message>
    <message>
        <source>it does not speak TLS 1.3</source>
        <translation>il ne parle pas TLS 1.3</translation>
    </message>
    <message>
        <source>it ended by signal %1</source>
        <translation>il s’est terminé par le signal %1</translation>
    </message>
    <message>
        <source>it ended too early</source>
        <translation>il s'est terminé trop tôt</translation>
    </message>
    <message>
        <source>it ended with an error</source>
        <translation>il s'est terminé par une erreur</translation>
    </message>
    <message>
        <source>it expands to more than %1 nodes</source>
        <translation>une fois déplié, il compte plus de %1 nœuds</translation>
    </message>
    <message>
        <source>it exports no function hapticell_driver</source>
        <translation>il n'exporte pas de fonction hapticell_driver</translation>
    </message>
    <message>
        <source>it has closed loops</source>
        <translation>il a des boucles fermées</translation>
    </message>
    <message>
        <source>it has no joints</source>
        <translation>elle n'a pas d'axes</translation>
    </message>
    <message>
        <source>it has no model</source>
        <translation>aucun modèle dans le fichier</translation>
    </message>
    <message>
        <source>it has no moving link</source>
        <translation>il n'a pas de segment mobile</translation>
    </message>
    <message>
        <source>it has no part '%1'</source>
        <translation>aucune pièce '%1' dans le fichier</translation>
    </message>
    <message>
        <source>it has no shape</source>
        <translation>elle n'a pas de forme</translation>
    </message>
    <message>
        <source>it has no trunk to lock</source>
        <translation>elle n'a pas de tronc à verrouiller</translation>
    </message>
    <message>
        <source>it includes itself</source>
        <translation>il s'inclut lui-même</translation>
    </message>
    <message>
        <source>it is attached through a chain of more than %1 entities</source>
        <translation>elle est attachée à plus de %1 entités à la suite</translation>
    </message>
    <message>
        <source>it is attached to '%1', link '%2', which does not exist</source>
        <translation>elle est attachée à '%1', segment '%2', qui n'existe pas</translation>
    </message>
    <message>
        <source>it is attached to '%1', which does not exist</source>
        <translation>elle est attachée à '%1', qui n'existe pas</translation>
    </message>
    <message>
        <source>it is attached to itself through '%1'</source>
        <translation>elle est attachée à elle-même par l'intermédiaire de '%1'</translation>
    </message>
    <message>
        <source>it is coupled to '%1', which does not exist</source>
        <translation>il est couplé à '%1', qui n'existe pas</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>c'est vide</translation>
    </message>
    <message>
        <source>it is locked</source>
        <translation>elle est verrouillée</translation>
    </message>
    <message>
        <source>it is missing</source>
        <translation>absent</translation>
    </message>
    <message>
        <source>it is missing or has the wrong type</source>
        <translation>absent, ou pas ce qui est attendu</translation>
    </message>
    <message>
        <source>it is missing or invalid</source>
        <translation>absent ou non valide</translation>
    </message>
    <message>
        <source>it is not a mechanism</source>
        <translation>ce n'est pas un mécanisme</translation>
    </message>
    <message>
        <source>it is not a robot</source>
        <translation>ce n'est pas un robot</translation>
    </message>
    <message>
        <source>it is not a solid</source>
        <translation>ce n'est pas un solide</translation>
    </message>
    <message>
        <source>it is not attached to anything that moves</source>
        <translation>elle ne repose sur rien de mobile</translation>
    </message>
    <message>
        <source>it is not in this cell</source>
        <translation>elle n'est pas dans cette cellule</translation>
    </message>
    <message>
        <source>it is of another kind</source>
        <translation>elle est d'un autre type</translation>
    </message>
    <message>
        <source>it joins part '%1' to itself</source>
        <translation>il relie la pièce '%1' à elle-même</translation>
    </message>
    <message>
        <source>it meets '%1' in frame %2</source>
        <translation>il rencontre « %1 » à l'image %2</translation>
    </message>
    <message>
        <source>it needs a good, fair or poor grip.</source>
        <translation>il lui faut une prise bonne, moyenne ou mauvaise.</translation>
    </message>
    <message>
        <source>it or its buffer does not exist</source>
        <translation>elle n'existe pas, ou son tampon n'existe pas</translation>
    </message>
    <message>
        <source>it reaches %1 km from the origin</source>
        <translation>elle s'étend jusqu'à %1 km de l'origine</translation>
    </message>
    <message>
        <source>it reaches %1 m from the origin</source>
        <translation>elle s'étend jusqu'à %1 m de l'origine</translation>
    </message>
    <message>
        <source>it stopped accepting pictures</source>
        <translation>il n'accepte plus d'images</translation>
    </message>
    <message>
        <source>it was asked %1 times</source>
        <translation>il a été interrogé %1 fois</translation>
    </message>
    <message>
        <source>it was built for another version of HaptiCell's driver interface</source>
        <translation>il a été compilé pour une autre version de l'interface de pilote de HaptiCell</translation>
    </message>
    <message>
        <source>it was deleted</source>
        <translation>il a été supprimé</translation>
    </message>
    <message>
        <source>it would not be as in the variant</source>
        <translation>elle ne serait pas comme dans la variante</translation>
    </message>
    <message>
        <source>its *.hexercise file in the same folder</source>
        <translation>son fichier *.hexercise dans le même dossier</translation>
    </message>
    <message>
        <source>its colours are missing: the material file %1 is not in the same folder</source>
        <translation>ses couleurs manquent : le fichier de matériaux %1 n'est pas à côté de lui</translation>
    </message>
    <message>
        <source>its coupling leads back to itself</source>
        <translation>il est couplé à lui-même en boucle</translation>
    </message>
    <message>
        <source>its file cannot be read</source>
        <translation>son fichier ne peut pas être lu</translation>
    </message>
    <message>
        <source>its joint states</source>
        <translation>ses états articulaires</translation>
    </message>
    <message>
        <source>its left or right hand</source>
        <translation>sa main gauche ou droite</translation>
    </message>
    <message>
        <source>its link '%1' is not in the model</source>
        <translation>il cite le segment '%1', qui n'est pas dans le modèle</translation>
    </message>
    <message>
        <source>its lower limit %1 is above its upper limit %2</source>
        <translation>sa butée inférieure %1 dépasse la butée supérieure %2</translation>
    </message>
    <message>
        <source>its name is used twice</source>
        <translation>son nom apparaît deux fois</translation>
    </message>
    <message>
        <source>join() of %1</source>
        <translation>join() appliqué à %1</translation>
    </message>
    <message>
        <source>joined</source>
        <translation>joint</translation>
    </message>
    <message>
        <source>joint '%1'</source>
        <translation>axe '%1'</translation>
    </message>
    <message>
        <source>joint '%1' has a lower limit above its upper limit</source>
        <translation>la butée inférieure de l'axe '%1' dépasse la butée supérieure</translation>
    </message>
    <message>
        <source>joint '%1' has no child link</source>
        <translation>l'axe '%1' ne cite pas de segment enfant</translation>
    </message>
    <message>
        <source>joint '%1' has no parent link</source>
        <translation>l'axe '%1' ne cite pas de segment parent</translation>
    </message>
    <message>
        <source>joint '%1' has the axis &quot;%2&quot;</source>
        <translation>l'axe '%1' a la direction &quot;%2&quot;</translation>
    </message>
    <message>
        <source>joint '%1' has the type '%2'</source>
        <translation>l'axe '%1' est de type '%2'</translation>
    </message>
    <message>
        <source>joint '%1' is beyond its limit %2 ms after the start</source>
        <translation>l'articulation '%1' dépasse sa limite %2 ms après le début</translation>
    </message>
    <message>
        <source>joint '%1' is faster than its limit %2 ms after the start</source>
        <translation>l'articulation '%1' est plus rapide que sa limite %2 ms après le début</translation>
    </message>
    <message>
        <source>joint '%1' left the motion by more than 0.2 rad (20 mm)</source>
        <translation>l'articulation '%1' s'est écartée du mouvement de plus de 0,2 rad (20 mm)</translation>
    </message>
    <message>
        <source>joint '%1' mimics itself through other joints</source>
        <translation>l'axe '%1' se suit lui-même en boucle</translation>
    </message>
    <message>
        <source>joint '%1' names the link '%2', which is not in the file</source>
        <translation>l'axe '%1' cite le segment '%2', qui n'est pas dans le fichier</translation>
    </message>
    <message>
        <source>joint '%1' of the goal is at %2, outside its limits of %3 to %4</source>
        <translation>l'articulation '%1' du but est à %2, hors de ses limites de %3 à %4</translation>
    </message>
    <message>
        <source>joint '%1' of the robot is not at the first point of the motion</source>
        <translation>l'articulation '%1' du robot n'est pas au premier point du mouvement</translation>
    </message>
    <message>
        <source>joint '%1' twice</source>
        <translation>axe '%1' deux fois</translation>
    </message>
    <message>
        <source>joint '%1' with other limits</source>
        <translation>l’axe « %1 » avec d’autres limites</translation>
    </message>
    <message>
        <source>joint names</source>
        <translation>des noms d'axes</translation>
    </message>
    <message>
        <source>joint names that are not a list</source>
        <translation>des noms d'axes qui ne sont pas une liste</translation>
    </message>
    <message>
        <source>joint names with angles</source>
        <translation>des noms d'articulations avec des angles</translation>
    </message>
    <message>
        <source>joint positions in the channels are near zero; they are added to the offsets</source>
        <translation>les positions d'articulations dans les canaux restent proches de zéro ; elles sont ajoutées aux décalages</translation>
    </message>
    <message>
        <source>joint positions near an assembled pose</source>
        <translation>des positions d'axes proches d'une pose assemblée</translation>
    </message>
    <message>
        <source>joint speed</source>
        <translation>vitesse articulaire</translation>
    </message>
    <message>
        <source>joint values without poses</source>
        <translation>des valeurs d'axes sans poses</translation>
    </message>
    <message>
        <source>joint values without poses, so the program has no targets</source>
        <translation>des axes seuls, qui ne donnent pas de cibles à un programme</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>axes</translation>
    </message>
    <message>
        <source>joints %1</source>
        <translation>axes %1</translation>
    </message>
    <message>
        <source>joints are left out; all parts are read as rigid bodies</source>
        <translation>les articulations sont ignorées ; toutes les pièces sont lues comme des corps rigides</translation>
    </message>
    <message>
        <source>joints of '%1'</source>
        <translation>axes de « %1 »</translation>
    </message>
    <message>
        <source>joints relative to the target before</source>
        <translation>des axes relatifs à la cible précédente</translation>
    </message>
    <message>
        <source>joints that move while the tool does not</source>
        <translation>des axes qui bougent alors que l'outil est immobile</translation>
    </message>
    <message>
        <source>joints that move, because their limits set the speed</source>
        <translation>des axes qui bougent, pour que leurs limites s'appliquent</translation>
    </message>
    <message>
        <source>joints: %1</source>
        <translation>articulations : %1</translation>
    </message>
    <message>
        <source>joints; all parts are read as rigid bodies</source>
        <translation>des articulations ; toutes les pièces sont lues comme des corps rigides</translation>
    </message>
    <message>
        <source>keep or merge</source>
        <translation>keep ou merge</translation>
    </message>
    <message>
        <source>key '%1'</source>
        <translation>clé '%1'</translation>
    </message>
    <message>
        <source>key file</source>
        <translation>fichier de clé</translation>
    </message>
    <message>
        <source>kg</source>
        <translation>kg</translation>
    </message>
    <message>
        <source>kilograms above 0</source>
        <translation>des kilogrammes, plus de 0</translation>
    </message>
    <message>
        <source>known</source>
        <translation>connu</translation>
    </message>
    <message>
        <source>large %1</source>
        <translation>%1 grand</translation>
    </message>
    <message>
        <source>late %1 ms</source>
        <translation>retard %1 ms</translation>
    </message>
    <message>
        <source>leaves at once</source>
        <translation>le quitte aussitôt</translation>
    </message>
    <message>
        <source>left %1</source>
        <translation>%1 gauche</translation>
    </message>
    <message>
        <source>left ankle</source>
        <translation>cheville gauche</translation>
    </message>
    <message>
        <source>left elbow</source>
        <translation>coude gauche</translation>
    </message>
    <message>
        <source>left hand</source>
        <translation>main gauche</translation>
    </message>
    <message>
        <source>left hip</source>
        <translation>hanche gauche</translation>
    </message>
    <message>
        <source>left knee</source>
        <translation>genou gauche</translation>
    </message>
    <message>
        <source>left or right</source>
        <translation>left ou right</translation>
    </message>
    <message>
        <source>left out, because it is after the last known target: %1.</source>
        <translation>omis, car après la dernière cible connue : %1.</translation>
    </message>
    <message>
        <source>left out, because it is before the first known target: %1.</source>
        <translation>omis, car avant la première cible connue : %1.</translation>
    </message>
    <message>
        <source>left out, because they have no shape: %1 nodes (%2)</source>
        <translation>omis, faute de forme : %1 nœuds (%2)</translation>
    </message>
    <message>
        <source>left shoulder</source>
        <translation>épaule gauche</translation>
    </message>
    <message>
        <source>left wrist</source>
        <translation>poignet gauche</translation>
    </message>
    <message>
        <source>left, right or both</source>
        <translation>left, right ou both</translation>
    </message>
    <message>
        <source>left_hand or right_hand</source>
        <translation>left_hand ou right_hand</translation>
    </message>
    <message>
        <source>legs of length zero</source>
        <translation>des jambes de longueur nulle</translation>
    </message>
    <message>
        <source>len() of %1</source>
        <translation>len() appliqué à %1</translation>
    </message>
    <message>
        <source>lengths above 0</source>
        <translation>des longueurs supérieures à 0</translation>
    </message>
    <message>
        <source>lengths that can be assembled</source>
        <translation>des longueurs qui peuvent être assemblées</translation>
    </message>
    <message>
        <source>less than the file size of %1 bytes</source>
        <translation>moins que la taille du fichier, %1 octets</translation>
    </message>
    <message>
        <source>letters, digits and _, no Python keyword, no __ at the start</source>
        <translation>des lettres, des chiffres et _, pas un mot de Python, pas de __ au début</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>butée</translation>
    </message>
    <message>
        <source>limited to %1 KiB</source>
        <translation>limitée à %1 Kio</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>limites</translation>
    </message>
    <message>
        <source>limits exceeded: %1</source>
        <translation>limites dépassées : %1</translation>
    </message>
    <message>
        <source>limits that are missing or not above 0</source>
        <translation>des limites absentes ou non positives</translation>
    </message>
    <message>
        <source>limits that are not numbers</source>
        <translation>des butées qui ne sont pas des nombres</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>ligne %1</translation>
    </message>
    <message>
        <source>line %1, %2</source>
        <translation>ligne %1, %2</translation>
    </message>
    <message>
        <source>line %1, agent '%2'</source>
        <translation>ligne %1, agent « %2 »</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>ligne %1, colonne %2</translation>
    </message>
    <message>
        <source>line %1, column '%2'</source>
        <translation>ligne %1, colonne '%2'</translation>
    </message>
    <message>
        <source>line %1, columns qw,qx,qy,qz</source>
        <translation>ligne %1, colonnes qw,qx,qy,qz</translation>
    </message>
    <message>
        <source>line %1: text that is not UTF-8; %2 bytes were read as Latin-1</source>
        <translation>ligne %1 : du texte qui n'est pas en UTF-8 ; %2 octets ont été lus comme du Latin-1</translation>
    </message>
    <message>
        <source>lines only, or a file that is missing</source>
        <translation>des lignes seulement, ou un fichier manquant</translation>
    </message>
    <message>
        <source>lines that run one after the other</source>
        <translation>des lignes exécutées dans leur ordre</translation>
    </message>
    <message>
        <source>link '%1'</source>
        <translation>segment '%1'</translation>
    </message>
    <message>
        <source>link '%1' at another place</source>
        <translation>le segment « %1 » à un autre endroit</translation>
    </message>
    <message>
        <source>link '%1' does not move</source>
        <translation>le segment '%1' ne bouge pas</translation>
    </message>
    <message>
        <source>link '%1' has different shapes</source>
        <translation>un segment '%1' avec d'autres formes</translation>
    </message>
    <message>
        <source>link '%1' is the child of two joints, '%2' and '%3'</source>
        <translation>le segment '%1' est l'enfant de deux axes, '%2' et '%3'</translation>
    </message>
    <message>
        <source>link '%1' with other shapes</source>
        <translation>le segment « %1 » avec d’autres formes</translation>
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
        <source>lists and objects nested deeper than %1</source>
        <translation>des listes et des objets imbriqués sur plus de %1 niveaux</translation>
    </message>
    <message>
        <source>lists nested deeper than 60</source>
        <translation>des listes imbriquées sur plus de 60 niveaux</translation>
    </message>
    <message>
        <source>lists of unequal length</source>
        <translation>des listes de longueurs différentes</translation>
    </message>
    <message>
        <source>lists that contain themselves</source>
        <translation>des listes imbriquées sans fin</translation>
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
        <source>log() of %1</source>
        <translation>log() appliqué à %1</translation>
    </message>
    <message>
        <source>look_at = &quot;NAME&quot; in [goal]</source>
        <translation>look_at = &quot;NOM&quot; dans [goal]</translation>
    </message>
    <message>
        <source>loops and branches instead of jumps</source>
        <translation>des boucles et des branches au lieu de sauts</translation>
    </message>
    <message>
        <source>m, mm or in</source>
        <translation>m, mm ou in</translation>
    </message>
    <message>
        <source>macro '%1' called in %2 line %3</source>
        <translation>macro '%1' appelée dans %2 ligne %3</translation>
    </message>
    <message>
        <source>male or female</source>
        <translation>male ou female</translation>
    </message>
    <message>
        <source>mannequin</source>
        <translation>mannequin</translation>
    </message>
    <message>
        <source>mannequin:SEX:PERCENTILE or mannequin:SEX:STATUREmm, such as mannequin:female:5</source>
        <translation>mannequin:SEXE:PERCENTILE ou mannequin:SEXE:STATUREmm, par exemple mannequin:female:5</translation>
    </message>
    <message>
        <source>markers</source>
        <translation>marqueurs</translation>
    </message>
    <message>
        <source>markers at the same point</source>
        <translation>des marqueurs confondus</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>masse</translation>
    </message>
    <message>
        <source>max() without values</source>
        <translation>max() sans valeurs</translation>
    </message>
    <message>
        <source>measure '%1'</source>
        <translation>mesure '%1'</translation>
    </message>
    <message>
        <source>measures that fit one body</source>
        <translation>les mesures d'un même corps</translation>
    </message>
    <message>
        <source>mechanism '%1'</source>
        <translation>mécanisme '%1'</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>moyenne</translation>
    </message>
    <message>
        <source>member of dialout</source>
        <translation>membre de dialout</translation>
    </message>
    <message>
        <source>mesh %1, which does not exist</source>
        <translation>le maillage %1, qui n'existe pas</translation>
    </message>
    <message>
        <source>mesh '%1'</source>
        <translation>maillage '%1'</translation>
    </message>
    <message>
        <source>meshes that cannot be read: convert them to STL, OBJ or PLY</source>
        <translation>maillages illisibles : convertissez-les en STL, OBJ ou PLY</translation>
    </message>
    <message>
        <source>meshing part %1 of %2, %3</source>
        <translation>maillage de la pièce %1 sur %2, %3</translation>
    </message>
    <message>
        <source>message type %1</source>
        <translation>type de message %1</translation>
    </message>
    <message>
        <source>metadata '%1'</source>
        <translation>métadonnées « %1 »</translation>
    </message>
    <message>
        <source>method = &quot;halton&quot; or &quot;sobol&quot;</source>
        <translation>method = &quot;halton&quot; ou &quot;sobol&quot;</translation>
    </message>
    <message>
        <source>metre</source>
        <translation>mètre</translation>
    </message>
    <message>
        <source>metres above 0</source>
        <translation>des mètres, au-dessus de 0</translation>
    </message>
    <message>
        <source>metres and radians</source>
        <translation>des mètres et des radians</translation>
    </message>
    <message>
        <source>metres from 0 to 1</source>
        <translation>des mètres, de 0 à 1</translation>
    </message>
    <message>
        <source>metres in the cell</source>
        <translation>des mètres dans la cellule</translation>
    </message>
    <message>
        <source>metres in the device frame, within %1 (or millimetres)</source>
        <translation>des mètres dans le repère du périphérique, au plus %1 (ou des millimètres)</translation>
    </message>
    <message>
        <source>metres or radians</source>
        <translation>des mètres ou des radians</translation>
    </message>
    <message>
        <source>metres per turn, not 0</source>
        <translation>des mètres par tour, différents de 0</translation>
    </message>
    <message>
        <source>metres per unit, 1e-9 to 1e9</source>
        <translation>des mètres par unité, de 1e-9 à 1e9</translation>
    </message>
    <message>
        <source>metres, 0 or more</source>
        <translation>des mètres, 0 ou plus</translation>
    </message>
    <message>
        <source>metres, 0 to 1</source>
        <translation>des mètres, de 0 à 1</translation>
    </message>
    <message>
        <source>metres, 0 to 1000</source>
        <translation>des mètres, de 0 à 1000</translation>
    </message>
    <message>
        <source>metres, 1e-9 to 1000</source>
        <translation>des mètres, de 1e-9 à 1000</translation>
    </message>
    <message>
        <source>metres, above 0</source>
        <translation>des mètres, plus de 0</translation>
    </message>
    <message>
        <source>metres, at most 1e12</source>
        <translation>des mètres, au plus 1e12</translation>
    </message>
    <message>
        <source>millimetre</source>
        <translation>millimètre</translation>
    </message>
    <message>
        <source>min() without values</source>
        <translation>min() sans valeurs</translation>
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
        <source>missing triangles</source>
        <translation>des triangles manquants</translation>
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
        <source>mm, cm, m, in or ft</source>
        <translation>mm, cm, m, in ou ft</translation>
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
        <source>model '%1'</source>
        <translation>modèle '%1'</translation>
    </message>
    <message>
        <source>more bytes than its buffer has</source>
        <translation>plus d'octets que son tampon n'en contient</translation>
    </message>
    <message>
        <source>more elements than its buffer views have</source>
        <translation>plus d'éléments que ses vues de tampon n'en contiennent</translation>
    </message>
    <message>
        <source>more than %1 MB of messages</source>
        <translation>plus de %1 Mo de messages</translation>
    </message>
    <message>
        <source>more than %1 MB once unpacked</source>
        <translation>plus de %1 Mo une fois décompressé</translation>
    </message>
    <message>
        <source>more than %1 instances</source>
        <translation>plus de %1 instances</translation>
    </message>
    <message>
        <source>more than %1 nested assemblies</source>
        <translation>plus de %1 assemblages les uns dans les autres</translation>
    </message>
    <message>
        <source>more than %1 nested levels</source>
        <translation>plus de %1 niveaux imbriqués</translation>
    </message>
    <message>
        <source>more than 10 000 000 variants</source>
        <translation>plus de 10 000 000 variantes</translation>
    </message>
    <message>
        <source>more than 100 nested blocks</source>
        <translation>plus de 100 blocs imbriqués</translation>
    </message>
    <message>
        <source>more than 1000 bones</source>
        <translation>plus de 1000 os</translation>
    </message>
    <message>
        <source>more than 1000 joints</source>
        <translation>plus de 1000 articulations</translation>
    </message>
    <message>
        <source>more than 2 000 000 targets</source>
        <translation>plus de 2 000 000 de cibles</translation>
    </message>
    <message>
        <source>more than 200 000 elements, including all included files</source>
        <translation>plus de 200 000 éléments avec tout ce qu'il inclut</translation>
    </message>
    <message>
        <source>more than 2000000 frames</source>
        <translation>plus de 2000000 d'images</translation>
    </message>
    <message>
        <source>more than 3 million evaluation steps</source>
        <translation>plus de 3 millions d'étapes d'évaluation</translation>
    </message>
    <message>
        <source>more than 500 nested levels</source>
        <translation>plus de 500 niveaux imbriqués</translation>
    </message>
    <message>
        <source>more than one robot ('%1', '%2')</source>
        <translation>plus d'un robot ('%1', '%2')</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>mouvement</translation>
    </message>
    <message>
        <source>motion '%1'</source>
        <translation>mouvement '%1'</translation>
    </message>
    <message>
        <source>motion.path point %1</source>
        <translation>motion.path, point %1</translation>
    </message>
    <message>
        <source>motions</source>
        <translation>mouvements</translation>
    </message>
    <message>
        <source>motions in the file, of which the first is read: %1</source>
        <translation>mouvements dans le fichier, dont le premier est lu : %1</translation>
    </message>
    <message>
        <source>motions of its external axes with other times or joints</source>
        <translation>des mouvements de ses axes externes avec d'autres instants ou d'autres articulations</translation>
    </message>
    <message>
        <source>motions of one robot</source>
        <translation>des mouvements d’un même robot</translation>
    </message>
    <message>
        <source>motions that were written together</source>
        <translation>des mouvements écrits ensemble</translation>
    </message>
    <message>
        <source>moved by %1 m, %2 rad</source>
        <translation>déplacée de %1 m, %2 rad</translation>
    </message>
    <message>
        <source>moved_by = &quot;%1&quot;</source>
        <translation>moved_by = &quot;%1&quot;</translation>
    </message>
    <message>
        <source>moves that depend on %1</source>
        <translation>des mouvements qui dépendent de %1</translation>
    </message>
    <message>
        <source>moves that depend on '%1'</source>
        <translation>des mouvements qui dépendent de '%1'</translation>
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
        <source>name '%1' is not defined</source>
        <translation>le nom '%1' n'est pas défini</translation>
    </message>
    <message>
        <source>name '%1' is not defined in the namespace</source>
        <translation>le nom '%1' n'est pas défini dans l'espace de noms</translation>
    </message>
    <message>
        <source>named arguments after the others</source>
        <translation>des arguments nommés après les autres</translation>
    </message>
    <message>
        <source>names and links inside the archive</source>
        <translation>des fichiers à l'intérieur</translation>
    </message>
    <message>
        <source>names in one line</source>
        <translation>des noms sur une ligne</translation>
    </message>
    <message>
        <source>names of entities of the cell</source>
        <translation>des noms d'entités de la cellule</translation>
    </message>
    <message>
        <source>names of the robot's joints</source>
        <translation>les noms de ses axes</translation>
    </message>
    <message>
        <source>names of the robot's joints, or q1, q2, ...</source>
        <translation>les noms de ses axes, ou q1, q2, ...</translation>
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
        <source>nearest: %1, %2</source>
        <translation>le plus proche : %1, %2</translation>
    </message>
    <message>
        <source>neither is given</source>
        <translation>aucun des deux n'est donné</translation>
    </message>
    <message>
        <source>neither the file nor its markers show which axis is up; z is assumed; to change this, use --up</source>
        <translation>ni le fichier ni ses marqueurs n'indiquent quel axe est vers le haut ; son axe z est utilisé ; --up en indique un autre</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>no --unit: robot files are in metres</source>
        <translation>pas d'unité : les fichiers de robots sont en mètres</translation>
    </message>
    <message>
        <source>no &lt;COLLADA&gt;</source>
        <translation>pas de &lt;COLLADA&gt;</translation>
    </message>
    <message>
        <source>no &lt;model&gt;</source>
        <translation>pas de &lt;model&gt;</translation>
    </message>
    <message>
        <source>no IP address</source>
        <translation>pas une adresse IP</translation>
    </message>
    <message>
        <source>no PROC has moves</source>
        <translation>pas de PROC avec des mouvements</translation>
    </message>
    <message>
        <source>no XML element</source>
        <translation>pas d'élément XML</translation>
    </message>
    <message>
        <source>no agents</source>
        <translation>aucun agent</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>pas de réponse</translation>
    </message>
    <message>
        <source>no assembly is named '%1'</source>
        <translation>aucun assemblage ne s'appelle « %1 »</translation>
    </message>
    <message>
        <source>no body size</source>
        <translation>pas de taille</translation>
    </message>
    <message>
        <source>no bound</source>
        <translation>pas de borne</translation>
    </message>
    <message>
        <source>no button of the stylus was pressed</source>
        <translation>aucun bouton du stylet n'a été enfoncé</translation>
    </message>
    <message>
        <source>no cell</source>
        <translation>aucune cellule</translation>
    </message>
    <message>
        <source>no clearance</source>
        <translation>pas de distance</translation>
    </message>
    <message>
        <source>no cluster</source>
        <translation>aucune grappe</translation>
    </message>
    <message>
        <source>no column '%1' in %2</source>
        <translation>pas de colonne '%1' dans %2</translation>
    </message>
    <message>
        <source>no command is named '%1'</source>
        <translation>aucune commande ne s'appelle '%1'</translation>
    </message>
    <message>
        <source>no contact</source>
        <translation>sans contact</translation>
    </message>
    <message>
        <source>no contact on the way</source>
        <translation>aucun contact en chemin</translation>
    </message>
    <message>
        <source>no controller offers this action</source>
        <translation>aucun contrôleur n'offre cette action</translation>
    </message>
    <message>
        <source>no device</source>
        <translation>pas de périphérique</translation>
    </message>
    <message>
        <source>no direction</source>
        <translation>pas de direction</translation>
    </message>
    <message>
        <source>no entity</source>
        <translation>aucune entité</translation>
    </message>
    <message>
        <source>no entity has the number %1</source>
        <translation>pas d'entité %1</translation>
    </message>
    <message>
        <source>no entity is chosen</source>
        <translation>aucune entité n’est choisie</translation>
    </message>
    <message>
        <source>no entity is named '%1'</source>
        <translation>aucune entité ne s'appelle '%1'</translation>
    </message>
    <message>
        <source>no entity of the cell is named '%1'</source>
        <translation>aucune entité de la cellule ne s'appelle « %1 »</translation>
    </message>
    <message>
        <source>no entity with a shape</source>
        <translation>rien qui ait une forme</translation>
    </message>
    <message>
        <source>no extension</source>
        <translation>pas d'extension</translation>
    </message>
    <message>
        <source>no field has this name</source>
        <translation>aucun champ n'a ce nom</translation>
    </message>
    <message>
        <source>no file matches %1</source>
        <translation>aucun fichier ne correspond à %1</translation>
    </message>
    <message>
        <source>no flip</source>
        <translation>non ret.</translation>
    </message>
    <message>
        <source>no folder can be created next to it</source>
        <translation>aucun dossier ne peut être créé à côté</translation>
    </message>
    <message>
        <source>no folder for temporary files can be created</source>
        <translation>aucun dossier temporaire ne peut être créé</translation>
    </message>
    <message>
        <source>no frame</source>
        <translation>aucun repère</translation>
    </message>
    <message>
        <source>no frame is called '%1'</source>
        <translation>aucun repère ne s'appelle '%1'</translation>
    </message>
    <message>
        <source>no frame is called '%1' in this variant</source>
        <translation>aucun repère ne s'appelle '%1' dans cette variante</translation>
    </message>
    <message>
        <source>no frame is named '%1'</source>
        <translation>aucun repère ne s'appelle '%1'</translation>
    </message>
    <message>
        <source>no frame of the entity is named '%1'</source>
        <translation>aucun repère de l'entité ne s'appelle '%1'</translation>
    </message>
    <message>
        <source>no free space for a copy</source>
        <translation>pas assez d'espace pour une copie</translation>
    </message>
    <message>
        <source>no further arguments</source>
        <translation>pas d'autres arguments</translation>
    </message>
    <message>
        <source>no guide is named '%1'</source>
        <translation>aucun guide virtuel ne s'appelle '%1'</translation>
    </message>
    <message>
        <source>no haptic server answers</source>
        <translation>aucun serveur haptique ne répond</translation>
    </message>
    <message>
        <source>no joint connects it to the root link '%1'</source>
        <translation>aucune liaison ne le relie au segment racine '%1'</translation>
    </message>
    <message>
        <source>no joint is named '%1'</source>
        <translation>aucun axe ne s'appelle '%1'</translation>
    </message>
    <message>
        <source>no joint limits</source>
        <translation>pas de limites pour les axes</translation>
    </message>
    <message>
        <source>no joints or no points</source>
        <translation>pas d’axes ou pas de points</translation>
    </message>
    <message>
        <source>no joints, or fewer than two frames</source>
        <translation>pas d'articulations, ou moins de deux images</translation>
    </message>
    <message>
        <source>no key is named '%1'</source>
        <translation>aucune clé ne s'appelle '%1'</translation>
    </message>
    <message>
        <source>no line after the header</source>
        <translation>pas de ligne après l'en-tête</translation>
    </message>
    <message>
        <source>no link '%1'</source>
        <translation>pas de segment « %1 »</translation>
    </message>
    <message>
        <source>no link is named '%1'</source>
        <translation>aucun segment ne s'appelle '%1'</translation>
    </message>
    <message>
        <source>no load is acceptable</source>
        <translation>aucune charge n'est acceptable</translation>
    </message>
    <message>
        <source>no lock, because %1 moves no part of a mannequin</source>
        <translation>aucun blocage, car %1 ne déplace aucune partie d'un mannequin</translation>
    </message>
    <message>
        <source>no longer following job %1; Slurm continues with it</source>
        <translation>le travail %1 n'est plus suivi ; Slurm le continue</translation>
    </message>
    <message>
        <source>no mannequin</source>
        <translation>pas un mannequin</translation>
    </message>
    <message>
        <source>no mannequin in the cell</source>
        <translation>pas de mannequin dans la cellule</translation>
    </message>
    <message>
        <source>no mannequin is named '%1'</source>
        <translation>aucun mannequin ne s'appelle '%1'</translation>
    </message>
    <message>
        <source>no marker for %1</source>
        <translation>aucun marqueur pour %1</translation>
    </message>
    <message>
        <source>no marker on %1 by the names of %2 (the file has %3)</source>
        <translation>aucun marqueur sur %1 selon les noms de %2 (les marqueurs sont %3)</translation>
    </message>
    <message>
        <source>no memory for the import: %1</source>
        <translation>pas de mémoire pour l'importation : %1</translation>
    </message>
    <message>
        <source>no mesh for the collision check</source>
        <translation>aucun maillage pour le contrôle de collision</translation>
    </message>
    <message>
        <source>no message of these types</source>
        <translation>aucun message de ce type</translation>
    </message>
    <message>
        <source>no message within %1 s</source>
        <translation>aucun message en %1 s</translation>
    </message>
    <message>
        <source>no more than the file size allows</source>
        <translation>pas plus que la longueur du fichier ne permet</translation>
    </message>
    <message>
        <source>no motion at start and end</source>
        <translation>l'arrêt aux deux extrémités</translation>
    </message>
    <message>
        <source>no motion is switched on</source>
        <translation>aucun mouvement n'est activé</translation>
    </message>
    <message>
        <source>no moving joint is named '%1'</source>
        <translation>aucun axe mobile ne s'appelle '%1'</translation>
    </message>
    <message>
        <source>no moving joint moves this link</source>
        <translation>aucun axe mobile ne le porte</translation>
    </message>
    <message>
        <source>no option is named '%1'</source>
        <translation>aucune option ne s'appelle '%1'</translation>
    </message>
    <message>
        <source>no pair set is named '%1'</source>
        <translation>aucun jeu de paires ne s'appelle '%1'</translation>
    </message>
    <message>
        <source>no pairing code</source>
        <translation>pas un code d'appairage</translation>
    </message>
    <message>
        <source>no part '%1' in %2</source>
        <translation>pas de pièce '%1' dans %2</translation>
    </message>
    <message>
        <source>no part is named '%1'</source>
        <translation>aucune pièce ne s'appelle '%1'</translation>
    </message>
    <message>
        <source>no parts to merge</source>
        <translation>aucune partie à fusionner</translation>
    </message>
    <message>
        <source>no parts to move</source>
        <translation>aucune pièce à déplacer</translation>
    </message>
    <message>
        <source>no path</source>
        <translation>aucun chemin</translation>
    </message>
    <message>
        <source>no plan: %1</source>
        <translation>aucun trajet : %1</translation>
    </message>
    <message>
        <source>no plan_goal</source>
        <translation>pas de plan_goal</translation>
    </message>
    <message>
        <source>no points</source>
        <translation>pas de points</translation>
    </message>
    <message>
        <source>no progress, %1 from the goal (%2), and the planner finds no way: %3; lead it by hand from here</source>
        <translation>aucun progrès, à %1 du but (%2), et le planificateur ne trouve pas de chemin : %3 ; menez à la main à partir d’ici</translation>
    </message>
    <message>
        <source>no progress, %1 from the goal (%2); handed to the %3</source>
        <translation>aucun progrès, à %1 du but (%2) ; remis à %3</translation>
    </message>
    <message>
        <source>no progress, %1 from the goal (%2); handed to the planner, whose way is followed</source>
        <translation>aucun progrès, à %1 du but (%2) ; confié au planificateur, dont le chemin est suivi</translation>
    </message>
    <message>
        <source>no progress, %1 from the goal (%2); lead it by hand from here, or plan a path</source>
        <translation>aucun progrès, à %1 du but (%2) ; guidez à la main à partir d'ici, ou planifiez un trajet</translation>
    </message>
    <message>
        <source>no reader</source>
        <translation>aucun lecteur</translation>
    </message>
    <message>
        <source>no result is called '%1'</source>
        <translation>aucun résultat ne s'appelle « %1 »</translation>
    </message>
    <message>
        <source>no results file</source>
        <translation>aucun fichier de résultats</translation>
    </message>
    <message>
        <source>no results of a study</source>
        <translation>pas de résultats d'une étude</translation>
    </message>
    <message>
        <source>no robot</source>
        <translation>aucun robot</translation>
    </message>
    <message>
        <source>no robot of this name</source>
        <translation>aucun robot de ce nom</translation>
    </message>
    <message>
        <source>no shape</source>
        <translation>aucune forme</translation>
    </message>
    <message>
        <source>no shape in it</source>
        <translation>pas de forme à l'intérieur</translation>
    </message>
    <message>
        <source>no shape with an area above 0</source>
        <translation>aucune forme ayant une surface</translation>
    </message>
    <message>
        <source>no shell given</source>
        <translation>pas de shell indiqué</translation>
    </message>
    <message>
        <source>no simulated device is named '%1'</source>
        <translation>aucun périphérique simulé ne s'appelle '%1'</translation>
    </message>
    <message>
        <source>no single direction</source>
        <translation>pas une seule direction</translation>
    </message>
    <message>
        <source>no single list of targets</source>
        <translation>pas une seule liste de cibles</translation>
    </message>
    <message>
        <source>no single range of values</source>
        <translation>pas d'intervalle de valeurs unique</translation>
    </message>
    <message>
        <source>no such column</source>
        <translation>cette colonne n'existe pas</translation>
    </message>
    <message>
        <source>no table defines how the robot moves</source>
        <translation>aucune table qui décrit sa cinématique</translation>
    </message>
    <message>
        <source>no table of its own in the document</source>
        <translation>pas de table à elle dans le document</translation>
    </message>
    <message>
        <source>no tag, or one of !degrees, !radians, !meters, !millimeters, !foot, !inches</source>
        <translation>aucune, ou une parmi !degrees, !radians, !meters, !millimeters, !foot, !inches</translation>
    </message>
    <message>
        <source>no target</source>
        <translation>pas de cible</translation>
    </message>
    <message>
        <source>no task is named '%1'</source>
        <translation>aucune tâche ne s'appelle '%1'</translation>
    </message>
    <message>
        <source>no ticks</source>
        <translation>aucun cycle</translation>
    </message>
    <message>
        <source>no tool is named '%1'</source>
        <translation>aucun outil ne s'appelle '%1'</translation>
    </message>
    <message>
        <source>no tool of '%1' is named '%2'</source>
        <translation>aucun outil de « %1 » ne s'appelle « %2 »</translation>
    </message>
    <message>
        <source>no trajectory is named '%1'</source>
        <translation>aucune trajectoire ne s'appelle '%1'</translation>
    </message>
    <message>
        <source>no unit: robot files are in metres</source>
        <translation>aucune : les fichiers de robots sont en mètres</translation>
    </message>
    <message>
        <source>no variant %1</source>
        <translation>pas de variante %1</translation>
    </message>
    <message>
        <source>no way out was found for %1, so nothing was written</source>
        <translation>aucun chemin de sortie n'a été trouvé pour %1, donc rien n'a été écrit</translation>
    </message>
    <message>
        <source>no way to the goal was found in %1 s</source>
        <translation>aucun chemin vers le but n’a été trouvé en %1 s</translation>
    </message>
    <message>
        <source>no way to the goal was found with %1 checks</source>
        <translation>aucun chemin vers le but n’a été trouvé en %1 vérifications</translation>
    </message>
    <message>
        <source>no work task is named '%1'</source>
        <translation>aucune tâche ne s'appelle « %1 »</translation>
    </message>
    <message>
        <source>node %1</source>
        <translation>nœud %1</translation>
    </message>
    <message>
        <source>node '%1'</source>
        <translation>nœud '%1'</translation>
    </message>
    <message>
        <source>nodes below the 500th level were left out</source>
        <translation>les nœuds au-delà du 500e niveau ont été laissés de côté</translation>
    </message>
    <message>
        <source>nodes with meshes</source>
        <translation>des nœuds avec des maillages</translation>
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
        <source>none yet</source>
        <translation>pas encore choisi</translation>
    </message>
    <message>
        <source>none; e.g. %1</source>
        <translation>aucun ; p. ex. %1</translation>
    </message>
    <message>
        <source>normal, sigma %1</source>
        <translation>normale, sigma %1</translation>
    </message>
    <message>
        <source>not 22 numbers each for gain and offset</source>
        <translation>pas 22 nombres de gain et 22 de décalage</translation>
    </message>
    <message>
        <source>not a HaptiCell trajectory</source>
        <translation>pas une trajectoire HaptiCell</translation>
    </message>
    <message>
        <source>not a JSON object</source>
        <translation>pas d'objet JSON</translation>
    </message>
    <message>
        <source>not a ZIP archive</source>
        <translation>ce n'est pas une archive ZIP</translation>
    </message>
    <message>
        <source>not a built-in part</source>
        <translation>ce n'est pas une pièce paramétrique</translation>
    </message>
    <message>
        <source>not a list</source>
        <translation>pas une liste</translation>
    </message>
    <message>
        <source>not a list of numbers</source>
        <translation>pas une liste de nombres</translation>
    </message>
    <message>
        <source>not a list of three numbers</source>
        <translation>pas trois nombres</translation>
    </message>
    <message>
        <source>not a member of dialout</source>
        <translation>pas membre de dialout</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>pas un nombre</translation>
    </message>
    <message>
        <source>not a regular file</source>
        <translation>ce n'est pas un fichier ordinaire</translation>
    </message>
    <message>
        <source>not a table</source>
        <translation>pas une table</translation>
    </message>
    <message>
        <source>not a training session</source>
        <translation>pas une session d'entraînement</translation>
    </message>
    <message>
        <source>not a unit quaternion</source>
        <translation>pas un quaternion unitaire</translation>
    </message>
    <message>
        <source>not a whole number</source>
        <translation>pas un nombre entier</translation>
    </message>
    <message>
        <source>not an IP address</source>
        <translation>pas une adresse IP</translation>
    </message>
    <message>
        <source>not an absolute path</source>
        <translation>pas un chemin absolu</translation>
    </message>
    <message>
        <source>not an angle</source>
        <translation>pas un angle</translation>
    </message>
    <message>
        <source>not an exercise</source>
        <translation>pas un exercice</translation>
    </message>
    <message>
        <source>not an option</source>
        <translation>pas une option</translation>
    </message>
    <message>
        <source>not checked</source>
        <translation>non vérifié</translation>
    </message>
    <message>
        <source>not checked, because they always touch: %1</source>
        <translation>non vérifiés, parce qu'ils se touchent toujours : %1</translation>
    </message>
    <message>
        <source>not checked, because they touch at rest: %1</source>
        <translation>non vérifiés, parce qu'ils se touchent au repos : %1</translation>
    </message>
    <message>
        <source>not enough memory</source>
        <translation>pas assez de mémoire</translation>
    </message>
    <message>
        <source>not enough memory for the text of the file</source>
        <translation>pas assez de mémoire pour le texte du fichier</translation>
    </message>
    <message>
        <source>not enough memory for this file</source>
        <translation>pas assez de mémoire pour ce fichier</translation>
    </message>
    <message>
        <source>not enough memory or disk space to transfer the result</source>
        <translation>pas assez de mémoire ou de place sur le disque pour transmettre le résultat</translation>
    </message>
    <message>
        <source>not found in the folders of shipped files</source>
        <translation>absent de tous les dossiers de fichiers livrés</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>valeur non donnée</translation>
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
        <source>not supported by this reader</source>
        <translation>inconnu de ce lecteur</translation>
    </message>
    <message>
        <source>not there after %1 s, %2 from the goal</source>
        <translation>pas arrivé après %1 s, à %2 du but</translation>
    </message>
    <message>
        <source>not two numbers</source>
        <translation>pas deux nombres</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>nothing held</source>
        <translation>rien n'est tenu</translation>
    </message>
    <message>
        <source>nothing is near</source>
        <translation>rien n'est proche</translation>
    </message>
    <message>
        <source>nothing that is moved</source>
        <translation>rien qui soit déplacé</translation>
    </message>
    <message>
        <source>nothing to listen for</source>
        <translation>rien à écouter</translation>
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
        <source>numbers</source>
        <translation>des nombres</translation>
    </message>
    <message>
        <source>numbers of vertices of the mesh</source>
        <translation>des numéros de sommets du maillage</translation>
    </message>
    <message>
        <source>numbers that define no valid shape</source>
        <translation>des nombres qui ne donnent pas de forme</translation>
    </message>
    <message>
        <source>numbers, or registers that the program sets</source>
        <translation>des nombres ou des registres définis</translation>
    </message>
    <message>
        <source>object '%1'</source>
        <translation>objet '%1'</translation>
    </message>
    <message>
        <source>object '%1' is left out: it has no box, sphere, cylinder or mesh</source>
        <translation>l’objet « %1 » est ignoré : il n’a ni boîte, ni sphère, ni cylindre, ni maillage</translation>
    </message>
    <message>
        <source>object '%1' is left out: it has no name, no pose, or the frame '%2' instead of 'world'</source>
        <translation>l’objet « %1 » est ignoré : il n’a pas de nom, pas de position, ou le repère « %2 » au lieu de « world »</translation>
    </message>
    <message>
        <source>objects to be built</source>
        <translation>des objets à construire</translation>
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
        <source>on</source>
        <translation>on</translation>
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
        <source>on or off</source>
        <translation>on ou off</translation>
    </message>
    <message>
        <source>one</source>
        <translation>un</translation>
    </message>
    <message>
        <source>one at byte %1</source>
        <translation>un résumé à l’octet %1</translation>
    </message>
    <message>
        <source>one character</source>
        <translation>un seul caractère</translation>
    </message>
    <message>
        <source>one document</source>
        <translation>un seul document</translation>
    </message>
    <message>
        <source>one element inside the call for each block</source>
        <translation>un élément dans l'appel pour chaque bloc</translation>
    </message>
    <message>
        <source>one finite position for each joint and rising times</source>
        <translation>une position finie par axe et des temps croissants</translation>
    </message>
    <message>
        <source>one link that is not the child of a joint</source>
        <translation>un seul segment qui ne soit l'enfant d'aucun axe</translation>
    </message>
    <message>
        <source>one name per joint</source>
        <translation>un nom par axe</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>une valeur parmi %1</translation>
    </message>
    <message>
        <source>one of --percentile and --stature</source>
        <translation>l'une des options --percentile et --stature</translation>
    </message>
    <message>
        <source>one of [opw], [dh], [[chain]], [delta], [hexapod], [urdf]</source>
        <translation>l'un de [opw], [dh], [[chain]], [delta], [hexapod], [urdf]</translation>
    </message>
    <message>
        <source>one of hapticell.fbs</source>
        <translation>l’une de celles de hapticell.fbs</translation>
    </message>
    <message>
        <source>one of the %1 vertices</source>
        <translation>un des %1 sommets</translation>
    </message>
    <message>
        <source>one of the landmarks %1</source>
        <translation>l'un des repères anatomiques %1</translation>
    </message>
    <message>
        <source>one of the two</source>
        <translation>l'un des deux</translation>
    </message>
    <message>
        <source>one of them</source>
        <translation>un seul d'entre eux</translation>
    </message>
    <message>
        <source>one point</source>
        <translation>un seul point</translation>
    </message>
    <message>
        <source>one robot</source>
        <translation>un seul robot</translation>
    </message>
    <message>
        <source>one robot for a URDF</source>
        <translation>un robot, pour un URDF</translation>
    </message>
    <message>
        <source>one scene per file</source>
        <translation>une scène par fichier</translation>
    </message>
    <message>
        <source>one shape cut out of another</source>
        <translation>une forme découpée dans une autre</translation>
    </message>
    <message>
        <source>one skeleton per file</source>
        <translation>un squelette par fichier</translation>
    </message>
    <message>
        <source>one that exists in the cell</source>
        <translation>un élément de la cellule</translation>
    </message>
    <message>
        <source>one that exists in the document</source>
        <translation>une entité du document</translation>
    </message>
    <message>
        <source>one value</source>
        <translation>une seule valeur</translation>
    </message>
    <message>
        <source>one value for each %</source>
        <translation>une valeur pour chaque %</translation>
    </message>
    <message>
        <source>one value, or %1</source>
        <translation>un seul, ou %1</translation>
    </message>
    <message>
        <source>one whose joints are a chain or a tree</source>
        <translation>un robot dont les articulations forment une chaîne ou un arbre</translation>
    </message>
    <message>
        <source>one, another, …</source>
        <translation>une, une autre, …</translation>
    </message>
    <message>
        <source>only files in %1</source>
        <translation>seulement des fichiers dans %1</translation>
    </message>
    <message>
        <source>only one hand carries the load; it covers lifts with both hands. Use RULA or REBA.</source>
        <translation>une seule main porte la charge ; elle vaut pour les levages à deux mains. Utilisez RULA ou REBA.</translation>
    </message>
    <message>
        <source>only zero-area triangles</source>
        <translation>seulement des triangles sans aire</translation>
    </message>
    <message>
        <source>open %1 in Foxglove or Lichtblick ('Foxglove WebSocket')</source>
        <translation>ouvrez %1 dans Foxglove ou Lichtblick (« Foxglove WebSocket »)</translation>
    </message>
    <message>
        <source>operator '%1' between lists</source>
        <translation>un opérateur '%1' entre des listes</translation>
    </message>
    <message>
        <source>operator '%1' on a list</source>
        <translation>un opérateur '%1' sur une liste</translation>
    </message>
    <message>
        <source>operator '%1', which is not supported</source>
        <translation>un opérateur '%1' qui n'est pas compris</translation>
    </message>
    <message>
        <source>operator, agents or both</source>
        <translation>operator, agents ou both</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>origine</translation>
    </message>
    <message>
        <source>other first bytes</source>
        <translation>d’autres premiers octets</translation>
    </message>
    <message>
        <source>other joints</source>
        <translation>d'autres axes</translation>
    </message>
    <message>
        <source>other joints or channels than the first motion</source>
        <translation>d’autres axes ou canaux que le premier mouvement</translation>
    </message>
    <message>
        <source>other users can write to it</source>
        <translation>d'autres utilisateurs peuvent y écrire</translation>
    </message>
    <message>
        <source>out of balance</source>
        <translation>hors d'équilibre</translation>
    </message>
    <message>
        <source>out of range</source>
        <translation>hors limites</translation>
    </message>
    <message>
        <source>out of the cell</source>
        <translation>hors de la cellule</translation>
    </message>
    <message>
        <source>out, frame:NAME, pose:x,y,z,qw,qx,qy,qz (metres and a quaternion of length 1) or joints:q1,q2,... (radians or metres)</source>
        <translation>out, frame:NOM, pose:x,y,z,qw,qx,qy,qz (mètres et quaternion de longueur 1) ou joints:q1,q2,... (radians ou mètres)</translation>
    </message>
    <message>
        <source>outside the folder: %1</source>
        <translation>hors du dossier : %1</translation>
    </message>
    <message>
        <source>packages that are not found: put the package folder next to the robot file or above it, or add its path to ROS_PACKAGE_PATH</source>
        <translation>paquets introuvables : placez le dossier du paquet à côté ou au-dessus du fichier du robot, ou indiquez son emplacement dans ROS_PACKAGE_PATH</translation>
    </message>
    <message>
        <source>packing</source>
        <translation>compression</translation>
    </message>
    <message>
        <source>pair rule</source>
        <translation>une règle de paire</translation>
    </message>
    <message>
        <source>pair rule %1</source>
        <translation>règle de paire %1</translation>
    </message>
    <message>
        <source>pair rules</source>
        <translation>règles de paires</translation>
    </message>
    <message>
        <source>pair set %1</source>
        <translation>jeu de paires %1</translation>
    </message>
    <message>
        <source>pair set '%1'</source>
        <translation>jeu de paires '%1'</translation>
    </message>
    <message>
        <source>pair set '%1' names '%2', which does not exist</source>
        <translation>le jeu de paires '%1' nomme '%2', qui n'existe pas</translation>
    </message>
    <message>
        <source>pair sets</source>
        <translation>jeux de paires</translation>
    </message>
    <message>
        <source>pairing code</source>
        <translation>code d'appairage</translation>
    </message>
    <message>
        <source>pairing key</source>
        <translation>clé d'appairage</translation>
    </message>
    <message>
        <source>pairs of a key and a value</source>
        <translation>des paires de clé et de valeur</translation>
    </message>
    <message>
        <source>parents before their children</source>
        <translation>les parents d'abord</translation>
    </message>
    <message>
        <source>part</source>
        <translation>pièce</translation>
    </message>
    <message>
        <source>part '%1'</source>
        <translation>pièce '%1'</translation>
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
        <source>parts of the cell, not the mannequin itself</source>
        <translation>des pièces de la cellule, pas le mannequin lui-même</translation>
    </message>
    <message>
        <source>parts within 2 km of the origin, where 0.1 mm can still be drawn</source>
        <translation>des pièces à moins de 2 km, où un dixième de millimètre se dessine encore</translation>
    </message>
    <message>
        <source>path</source>
        <translation>trajectoire</translation>
    </message>
    <message>
        <source>pelvis and legs stay, because the mannequin does not stand on its feet</source>
        <translation>le bassin et les jambes restent en place, car le mannequin ne se tient pas sur ses pieds</translation>
    </message>
    <message>
        <source>percentile</source>
        <translation>percentile</translation>
    </message>
    <message>
        <source>permission to write</source>
        <translation>le droit d'écriture</translation>
    </message>
    <message>
        <source>phantom_desktop, touch, touch_x, premium or premium_6dof</source>
        <translation>phantom_desktop, touch, touch_x, premium ou premium_6dof</translation>
    </message>
    <message>
        <source>plain URDF</source>
        <translation>de l'URDF simple</translation>
    </message>
    <message>
        <source>plain text (UTF-8)</source>
        <translation>du texte simple (UTF-8)</translation>
    </message>
    <message>
        <source>planned</source>
        <translation>planifié</translation>
    </message>
    <message>
        <source>planned, %1</source>
        <translation>planifié, %1</translation>
    </message>
    <message>
        <source>planning was cancelled</source>
        <translation>la planification a été annulée</translation>
    </message>
    <message>
        <source>png, jpg, bmp or tiff</source>
        <translation>png, jpg, bmp ou tiff</translation>
    </message>
    <message>
        <source>points</source>
        <translation>points</translation>
    </message>
    <message>
        <source>points and lines</source>
        <translation>des points et des lignes</translation>
    </message>
    <message>
        <source>points reordered</source>
        <translation>points réordonnés</translation>
    </message>
    <message>
        <source>points that are not a list</source>
        <translation>des points qui ne sont pas une liste</translation>
    </message>
    <message>
        <source>points without faces</source>
        <translation>des points sans faces</translation>
    </message>
    <message>
        <source>pose %1 on the way, %2</source>
        <translation>pose %1 en chemin, %2</translation>
    </message>
    <message>
        <source>poses</source>
        <translation>poses</translation>
    </message>
    <message>
        <source>poses, because this edit changes them</source>
        <translation>des poses, pour les modifier</translation>
    </message>
    <message>
        <source>positions and time_from_start</source>
        <translation>positions et time_from_start</translation>
    </message>
    <message>
        <source>positions reach %1: millimetres are assumed</source>
        <translation>les positions vont jusqu'à %1 : l'unité supposée est le millimètre</translation>
    </message>
    <message>
        <source>positions that are not a list</source>
        <translation>des positions qui ne sont pas une liste</translation>
    </message>
    <message>
        <source>positions that do not fit the joints, or a time that does not rise</source>
        <translation>des positions qui ne correspondent pas aux axes, ou un temps qui n’augmente pas</translation>
    </message>
    <message>
        <source>positive values</source>
        <translation>des valeurs positives</translation>
    </message>
    <message>
        <source>postures without each_body</source>
        <translation>postures sans each_body</translation>
    </message>
    <message>
        <source>practice, retention or transfer</source>
        <translation>practice, retention ou transfer</translation>
    </message>
    <message>
        <source>preparing the collision shape</source>
        <translation>préparation de la forme contrôlée</translation>
    </message>
    <message>
        <source>printable text of at most 200 characters</source>
        <translation>des caractères imprimables, 200 au plus</translation>
    </message>
    <message>
        <source>processor %1</source>
        <translation>processeur %1</translation>
    </message>
    <message>
        <source>properties that do not depend on themselves</source>
        <translation>des propriétés sans boucle</translation>
    </message>
    <message>
        <source>rad or deg</source>
        <translation>rad ou deg</translation>
    </message>
    <message>
        <source>radians, 0.001 to 3</source>
        <translation>des radians, de 0,001 à 3</translation>
    </message>
    <message>
        <source>range() with a step of 0</source>
        <translation>range() avec un pas de 0</translation>
    </message>
    <message>
        <source>rate</source>
        <translation>fréquence</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>lecture</translation>
    </message>
    <message>
        <source>reading %1</source>
        <translation>lecture de %1</translation>
    </message>
    <message>
        <source>reading meshes</source>
        <translation>lecture des maillages</translation>
    </message>
    <message>
        <source>reading part %1 of %2</source>
        <translation>lecture de la pièce %1 sur %2</translation>
    </message>
    <message>
        <source>reading took longer than %1 s</source>
        <translation>la lecture a duré plus de %1 s</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>enregistrement</translation>
    </message>
    <message>
        <source>red, green and blue from 0 to 1</source>
        <translation>rouge, vert et bleu de 0 à 1</translation>
    </message>
    <message>
        <source>reference to '%1'</source>
        <translation>renvoi à '%1'</translation>
    </message>
    <message>
        <source>references to existing elements</source>
        <translation>des renvois à ce qui existe</translation>
    </message>
    <message>
        <source>relative axis values after a target without axis values</source>
        <translation>des axes relatifs à une cible qui n'en a pas</translation>
    </message>
    <message>
        <source>relative chord</source>
        <translation>flèche relative</translation>
    </message>
    <message>
        <source>release</source>
        <translation>relâcher</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>supprimée</translation>
    </message>
    <message>
        <source>replace() of an empty text</source>
        <translation>replace() appliqué à un texte vide</translation>
    </message>
    <message>
        <source>requiredextensions</source>
        <translation>requiredextensions</translation>
    </message>
    <message>
        <source>resampled</source>
        <translation>rééchantillonné</translation>
    </message>
    <message>
        <source>resource not found: %1 (%2)</source>
        <translation>ressource introuvable : %1 (%2)</translation>
    </message>
    <message>
        <source>results of '%1' as it is now</source>
        <translation>les résultats de « %1 » dans son état actuel</translation>
    </message>
    <message>
        <source>results of another study, or of files that have changed since</source>
        <translation>les résultats d'une autre étude, ou de fichiers modifiés depuis</translation>
    </message>
    <message>
        <source>results of format %1</source>
        <translation>des résultats au format %1</translation>
    </message>
    <message>
        <source>results of this study</source>
        <translation>les résultats de cette étude</translation>
    </message>
    <message>
        <source>results of training, not read: %1</source>
        <translation>résultats d'entraînement, non lus : %1</translation>
    </message>
    <message>
        <source>results of version %1</source>
        <translation>les résultats de la version %1</translation>
    </message>
    <message>
        <source>results that differ from a new evaluation</source>
        <translation>des résultats différents d'une nouvelle évaluation</translation>
    </message>
    <message>
        <source>results.pdf</source>
        <translation>resultats.pdf</translation>
    </message>
    <message>
        <source>retention: an exercise that the trainee practised</source>
        <translation>retention : un exercice que l'apprenant a pratiqué</translation>
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
        <source>revolute or prismatic</source>
        <translation>revolute ou prismatic</translation>
    </message>
    <message>
        <source>revolute, continuous, prismatic, fixed, floating or planar</source>
        <translation>revolute, continuous, prismatic, fixed, floating ou planar</translation>
    </message>
    <message>
        <source>revolute, continuous, prismatic, fixed, screw, universal, revolute2 or ball</source>
        <translation>revolute, continuous, prismatic, fixed, screw, universal, revolute2 ou ball</translation>
    </message>
    <message>
        <source>right %1</source>
        <translation>%1 droite</translation>
    </message>
    <message>
        <source>right ankle</source>
        <translation>cheville droite</translation>
    </message>
    <message>
        <source>right elbow</source>
        <translation>coude droit</translation>
    </message>
    <message>
        <source>right hand</source>
        <translation>main droite</translation>
    </message>
    <message>
        <source>right hip</source>
        <translation>hanche droite</translation>
    </message>
    <message>
        <source>right knee</source>
        <translation>genou droit</translation>
    </message>
    <message>
        <source>right shoulder</source>
        <translation>épaule droite</translation>
    </message>
    <message>
        <source>right wrist</source>
        <translation>poignet droit</translation>
    </message>
    <message>
        <source>robot '%1', link '%2'</source>
        <translation>robot '%1', segment '%2'</translation>
    </message>
    <message>
        <source>robots</source>
        <translation>des robots</translation>
    </message>
    <message>
        <source>ros2 listen</source>
        <translation>ros2 listen</translation>
    </message>
    <message>
        <source>rough</source>
        <translation>grosse</translation>
    </message>
    <message>
        <source>rough, medium, fine, screen or a number from 0.001 to 1000</source>
        <translation>rough, medium, fine, screen ou un nombre de 0.001 à 1000</translation>
    </message>
    <message>
        <source>round(%1)</source>
        <translation>round(%1)</translation>
    </message>
    <message>
        <source>routines that call each other endlessly</source>
        <translation>des routines qui s'appellent sans fin</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>sample</source>
        <translation>pas de temps</translation>
    </message>
    <message>
        <source>sample %1</source>
        <translation>échantillon %1</translation>
    </message>
    <message>
        <source>samples of the stylus, not read: %1</source>
        <translation>échantillons du stylet, non lus : %1</translation>
    </message>
    <message>
        <source>samples with a method that has none</source>
        <translation>samples avec une méthode qui n'en a pas</translation>
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
        <source>scenes other than the main one</source>
        <translation>des scènes en plus de la principale</translation>
    </message>
    <message>
        <source>schema %1 twice, with different content</source>
        <translation>le schéma %1 deux fois, avec des contenus différents</translation>
    </message>
    <message>
        <source>scope=&quot;%1&quot; is unknown; the property '%2' is set in the current scope</source>
        <translation>scope=&quot;%1&quot; n'est pas connu ; la propriété '%2' est définie là où elle se trouve</translation>
    </message>
    <message>
        <source>screen</source>
        <translation>écran</translation>
    </message>
    <message>
        <source>screen, cell or frame:NAME</source>
        <translation>screen, cell ou frame:NAME</translation>
    </message>
    <message>
        <source>sdformat: %1 more messages</source>
        <translation>sdformat : %1 autres messages</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>des secondes</translation>
    </message>
    <message>
        <source>seconds above 0, 24 h at most</source>
        <translation>des secondes au-dessus de 0, 24 h au plus</translation>
    </message>
    <message>
        <source>seconds and nanoseconds: {sec, nanosec} or {secs, nsecs}</source>
        <translation>des secondes et nanosecondes : {sec, nanosec} ou {secs, nsecs}</translation>
    </message>
    <message>
        <source>seconds from the beginning</source>
        <translation>des secondes depuis le début</translation>
    </message>
    <message>
        <source>seconds or metres above 0</source>
        <translation>des secondes ou des mètres, plus que 0</translation>
    </message>
    <message>
        <source>seconds, 0 or more (0: no limit)</source>
        <translation>des secondes, 0 ou plus (0 : sans limite)</translation>
    </message>
    <message>
        <source>seconds, above 0</source>
        <translation>des secondes, plus de 0</translation>
    </message>
    <message>
        <source>self_origin, geometric_center or frame:NAME of an entity</source>
        <translation>self_origin, geometric_center ou frame:NAME d'une entité</translation>
    </message>
    <message>
        <source>seven numbers x,y,z,qw,qx,qy,qz with a quaternion of length 1</source>
        <translation>sept nombres x,y,z,qw,qx,qy,qz avec un quaternion de norme 1</translation>
    </message>
    <message>
        <source>several of type %1: %2</source>
        <translation>plusieurs du type %1 : %2</translation>
    </message>
    <message>
        <source>shape morphing; the mesh is shown as modelled</source>
        <translation>des changements de forme ; le maillage est affiché tel que modélisé</translation>
    </message>
    <message>
        <source>shapes that cannot be read</source>
        <translation>formes qui ne peuvent pas être lues</translation>
    </message>
    <message>
        <source>shapes that cannot be read (%1)</source>
        <translation>formes qui ne peuvent pas être lues (%1)</translation>
    </message>
    <message>
        <source>share of the limit</source>
        <translation>part de la limite</translation>
    </message>
    <message>
        <source>shares</source>
        <translation>parts du cycle</translation>
    </message>
    <message>
        <source>shares of the cycle with a sum of at most 1</source>
        <translation>des parts du cycle dont la somme est au plus 1</translation>
    </message>
    <message>
        <source>shipped or classic</source>
        <translation>shipped ou classic</translation>
    </message>
    <message>
        <source>shown by hand</source>
        <translation>montré à la main</translation>
    </message>
    <message>
        <source>shown by hand, %1</source>
        <translation>montré à la main, %1</translation>
    </message>
    <message>
        <source>simplified</source>
        <translation>simplifié</translation>
    </message>
    <message>
        <source>simplifying</source>
        <translation>simplification</translation>
    </message>
    <message>
        <source>simulation bodies</source>
        <translation>des corps de simulation</translation>
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
        <source>six joint values</source>
        <translation>six valeurs d'axes</translation>
    </message>
    <message>
        <source>six joints, or none</source>
        <translation>six, ou aucun</translation>
    </message>
    <message>
        <source>six numbers, each 1 or -1</source>
        <translation>six fois 1 ou -1</translation>
    </message>
    <message>
        <source>six values, each true or false</source>
        <translation>six fois true ou false</translation>
    </message>
    <message>
        <source>size</source>
        <translation>dimension</translation>
    </message>
    <message>
        <source>slices</source>
        <translation>des tranches</translation>
    </message>
    <message>
        <source>small %1</source>
        <translation>%1 petit</translation>
    </message>
    <message>
        <source>smaller numbers</source>
        <translation>des nombres plus petits</translation>
    </message>
    <message>
        <source>smoothed</source>
        <translation>lissé</translation>
    </message>
    <message>
        <source>solids as parts of a mechanism</source>
        <translation>des solides comme pièces d'un mécanisme</translation>
    </message>
    <message>
        <source>solids or surfaces with exact faces</source>
        <translation>des solides ou des surfaces aux faces exactes</translation>
    </message>
    <message>
        <source>some of the markers C7, T10, CLAV and STRN are missing; the chest is derived from shoulders and hips</source>
        <translation>C7, T10, CLAV et STRN ne sont pas tous présents ; l'orientation du thorax est déduite des épaules et des hanches</translation>
    </message>
    <message>
        <source>sparse accessor</source>
        <translation>accesseur creux (sparse)</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>vitesse</translation>
    </message>
    <message>
        <source>speed, acceleration</source>
        <translation>vitesse, accélération</translation>
    </message>
    <message>
        <source>speed, acceleration, blend</source>
        <translation>vitesse, accélération, rayon de raccordement</translation>
    </message>
    <message>
        <source>speeds above 0, a joint speed of at most 1, a blend of 0 or more</source>
        <translation>des vitesses positives, une vitesse articulaire de 1 au plus, un rayon de raccordement de 0 ou plus</translation>
    </message>
    <message>
        <source>split</source>
        <translation>coupé</translation>
    </message>
    <message>
        <source>split() with an empty separator</source>
        <translation>split() avec un texte séparateur vide</translation>
    </message>
    <message>
        <source>standard input</source>
        <translation>entrée standard</translation>
    </message>
    <message>
        <source>standing</source>
        <translation>debout</translation>
    </message>
    <message>
        <source>start of file</source>
        <translation>début du fichier</translation>
    </message>
    <message>
        <source>starting</source>
        <translation>démarrage</translation>
    </message>
    <message>
        <source>statements that run endlessly</source>
        <translation>des instructions exécutées sans fin</translation>
    </message>
    <message>
        <source>station</source>
        <translation>poste</translation>
    </message>
    <message>
        <source>stature</source>
        <translation>stature</translation>
    </message>
    <message>
        <source>status %1</source>
        <translation>code %1</translation>
    </message>
    <message>
        <source>stays with it on %1 % of the way</source>
        <translation>l'accompagne sur %1 % du chemin</translation>
    </message>
    <message>
        <source>step</source>
        <translation>pas</translation>
    </message>
    <message>
        <source>step %1 ms</source>
        <translation>pas %1 ms</translation>
    </message>
    <message>
        <source>steps for a full grid, or [sampling]</source>
        <translation>steps pour une grille complète, ou [sampling]</translation>
    </message>
    <message>
        <source>steps is not a whole number</source>
        <translation>steps n'est pas un nombre entier</translation>
    </message>
    <message>
        <source>stop, slide or pass</source>
        <translation>stop, slide ou pass</translation>
    </message>
    <message>
        <source>stopped before all runs were made; there is no result</source>
        <translation>arrêté avant la fin des essais ; il n'y a pas de résultat</translation>
    </message>
    <message>
        <source>stopped before all variants were evaluated; the rows so far are kept</source>
        <translation>arrêt avant l'évaluation de toutes les variantes ; les lignes déjà produites sont gardées</translation>
    </message>
    <message>
        <source>stopped before everything was answered</source>
        <translation>arrêté avant que tout ait une réponse</translation>
    </message>
    <message>
        <source>stopped before its end</source>
        <translation>arrêté avant la fin</translation>
    </message>
    <message>
        <source>stopped before the motion was sent</source>
        <translation>arrêté avant l'envoi du mouvement</translation>
    </message>
    <message>
        <source>stopped before the shown way was checked</source>
        <translation>arrêté avant la vérification du trajet montré</translation>
    </message>
    <message>
        <source>stopped by the user</source>
        <translation>arrêté par l'utilisateur</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>droit</translation>
    </message>
    <message>
        <source>straight, %1</source>
        <translation>droit, %1</translation>
    </message>
    <message>
        <source>study submit</source>
        <translation>study submit</translation>
    </message>
    <message>
        <source>stylus button</source>
        <translation>bouton du stylet</translation>
    </message>
    <message>
        <source>sudo usermod -aG dialout %1, then log in again</source>
        <translation>sudo usermod -aG dialout %1, puis reconnectez-vous</translation>
    </message>
    <message>
        <source>symbolic links that refer to each other</source>
        <translation>des liens symboliques qui renvoient l'un à l'autre</translation>
    </message>
    <message>
        <source>table '%1'</source>
        <translation>table '%1'</translation>
    </message>
    <message>
        <source>table of poses (.csv)</source>
        <translation>tableau de poses (.csv)</translation>
    </message>
    <message>
        <source>tables [[%1]]</source>
        <translation>des tables [[%1]]</translation>
    </message>
    <message>
        <source>tables and lists nested deeper than %1</source>
        <translation>des tables et des listes imbriquées sur plus de %1 niveaux</translation>
    </message>
    <message>
        <source>targets in several frames: %1</source>
        <translation>des cibles dans plusieurs repères : %1</translation>
    </message>
    <message>
        <source>targets without a shift</source>
        <translation>des cibles sans décalage</translation>
    </message>
    <message>
        <source>task</source>
        <translation>tâche</translation>
    </message>
    <message>
        <source>task %1</source>
        <translation>tâche %1</translation>
    </message>
    <message>
        <source>task %1, %2</source>
        <translation>tâche %1, %2</translation>
    </message>
    <message>
        <source>task '%1'</source>
        <translation>tâche '%1'</translation>
    </message>
    <message>
        <source>tasks</source>
        <translation>tâches</translation>
    </message>
    <message>
        <source>tcp, tcp_with_axes, base, base_keeping_tcp or frame:NAME of one of its links</source>
        <translation>tcp, tcp_with_axes, base, base_keeping_tcp ou frame:NAME d'un de ses segments</translation>
    </message>
    <message>
        <source>tcp, tcp_with_axes, base, base_keeping_tcp, self_origin, geometric_center, frame:NAME, whole, left_hand, right_hand, both_hands or head</source>
        <translation>tcp, tcp_with_axes, base, base_keeping_tcp, self_origin, geometric_center, frame:NAME, whole, left_hand, right_hand, both_hands ou head</translation>
    </message>
    <message>
        <source>terrain from an image</source>
        <translation>un terrain tiré d'une image</translation>
    </message>
    <message>
        <source>text in quotes</source>
        <translation>un texte entre guillemets</translation>
    </message>
    <message>
        <source>text instead of a number, or a number that is too large</source>
        <translation>un texte au lieu d'un nombre, ou un nombre trop grand</translation>
    </message>
    <message>
        <source>text that is not JSON</source>
        <translation>un texte qui n'est pas du JSON</translation>
    </message>
    <message>
        <source>text that is not TOML (%1)</source>
        <translation>un texte qui n'est pas du TOML (%1)</translation>
    </message>
    <message>
        <source>texts</source>
        <translation>des textes</translation>
    </message>
    <message>
        <source>texts and lists with more than 64 MB in total</source>
        <translation>des textes et des listes de plus de 64 Mo</translation>
    </message>
    <message>
        <source>the %1 that were packed</source>
        <translation>les %1 qui ont été archivés</translation>
    </message>
    <message>
        <source>the 20 bytes of a binary glTF file's header and more</source>
        <translation>les 20 octets de l'en-tête d'un fichier glTF binaire et davantage</translation>
    </message>
    <message>
        <source>the C3D header is missing</source>
        <translation>pas d'en-tête C3D</translation>
    </message>
    <message>
        <source>the JSON header of a recording</source>
        <translation>l'en-tête JSON d'un enregistrement</translation>
    </message>
    <message>
        <source>the active frame</source>
        <translation>le repère actif</translation>
    </message>
    <message>
        <source>the actuated joints block each other</source>
        <translation>les axes actionnés se bloquent mutuellement</translation>
    </message>
    <message>
        <source>the angle CA</source>
        <translation>l'angle CA</translation>
    </message>
    <message>
        <source>the angle unit '%1'</source>
        <translation>l'unité d'angle '%1'</translation>
    </message>
    <message>
        <source>the ankle</source>
        <translation>la cheville</translation>
    </message>
    <message>
        <source>the arm is at the edge of its reach</source>
        <translation>le bras est au bord de son atteinte</translation>
    </message>
    <message>
        <source>the axis '%1'</source>
        <translation>l'axe '%1'</translation>
    </message>
    <message>
        <source>the axis is missing</source>
        <translation>pas de direction d'axe</translation>
    </message>
    <message>
        <source>the ball joint of rod %1</source>
        <translation>la rotule de la barre %1</translation>
    </message>
    <message>
        <source>the base $BASE, set from %1</source>
        <translation>la base $BASE, définie par %1</translation>
    </message>
    <message>
        <source>the base BASE_DATA[%1]</source>
        <translation>la base BASE_DATA[%1]</translation>
    </message>
    <message>
        <source>the base of the skull</source>
        <translation>la base du crâne</translation>
    </message>
    <message>
        <source>the best place and its four postures</source>
        <translation>l'emplacement et ses quatre postures</translation>
    </message>
    <message>
        <source>the block '%1' is not defined</source>
        <translation>le bloc '%1' n'est pas défini</translation>
    </message>
    <message>
        <source>the bone '%1'</source>
        <translation>l'os '%1'</translation>
    </message>
    <message>
        <source>the bone '%1' has no values in %2 of %3 frames; its rest pose is used there</source>
        <translation>l'os '%1' n'a pas de nombres dans %2 images sur %3 ; il y est pris au repos</translation>
    </message>
    <message>
        <source>the bone '%1' twice in a frame</source>
        <translation>l'os '%1' deux fois dans une image</translation>
    </message>
    <message>
        <source>the bounding box of the shape in the workcell, within 1e-9 m</source>
        <translation>la boîte englobante de la forme dans la cellule, à 1e-9 m près</translation>
    </message>
    <message>
        <source>the button of the stylus was released, or its server was lost</source>
        <translation>le bouton du stylet a été relâché, ou son serveur est perdu</translation>
    </message>
    <message>
        <source>the call of macro '%1' does not set %2</source>
        <translation>la macro '%1' sans ses paramètres %2</translation>
    </message>
    <message>
        <source>the call of macro '%1' has no block for %2</source>
        <translation>la macro '%1' sans son bloc %2</translation>
    </message>
    <message>
        <source>the capabilities are missing</source>
        <translation>pas de caractéristiques</translation>
    </message>
    <message>
        <source>the cell</source>
        <translation>la cellule</translation>
    </message>
    <message>
        <source>the cell has no robot</source>
        <translation>aucun robot</translation>
    </message>
    <message>
        <source>the cell of the study</source>
        <translation>la cellule de l'étude</translation>
    </message>
    <message>
        <source>the channel '%1'</source>
        <translation>le canal '%1'</translation>
    </message>
    <message>
        <source>the character '%1'</source>
        <translation>le caractère '%1'</translation>
    </message>
    <message>
        <source>the character '%1' in the expression</source>
        <translation>le caractère '%1' dans l'expression</translation>
    </message>
    <message>
        <source>the cluster's</source>
        <translation>celle de la grappe</translation>
    </message>
    <message>
        <source>the cluster's, or 02:00:00</source>
        <translation>celle de la grappe, ou 02:00:00</translation>
    </message>
    <message>
        <source>the column is missing</source>
        <translation>la colonne manque</translation>
    </message>
    <message>
        <source>the command line</source>
        <translation>ligne de commande</translation>
    </message>
    <message>
        <source>the command needs a subcommand</source>
        <translation>la commande demande une sous-commande</translation>
    </message>
    <message>
        <source>the compression '%1'</source>
        <translation>la compression « %1 »</translation>
    </message>
    <message>
        <source>the condition &quot;%1&quot;, which gives &quot;%2&quot;</source>
        <translation>la condition &quot;%1&quot;, qui donne &quot;%2&quot;</translation>
    </message>
    <message>
        <source>the confirmed motion</source>
        <translation>le mouvement confirmé</translation>
    </message>
    <message>
        <source>the connection ended before the keys were checked</source>
        <translation>la connexion s'est terminée avant la comparaison des clés</translation>
    </message>
    <message>
        <source>the connection is not encrypted: whoever can listen to this network can watch</source>
        <translation>la connexion n'est pas chiffrée : quiconque écoute ce réseau peut regarder</translation>
    </message>
    <message>
        <source>the connection was interrupted</source>
        <translation>la connexion a été interrompue</translation>
    </message>
    <message>
        <source>the content differs from %1</source>
        <translation>le contenu diffère de %1</translation>
    </message>
    <message>
        <source>the content of %1</source>
        <translation>un contenu valable pour %1</translation>
    </message>
    <message>
        <source>the content of a Collada file</source>
        <translation>le contenu d'un fichier Collada</translation>
    </message>
    <message>
        <source>the content of a glTF file</source>
        <translation>le contenu d'un fichier glTF</translation>
    </message>
    <message>
        <source>the controller did not start the motion within 5 s</source>
        <translation>le contrôleur n'a pas commencé le mouvement en 5 s</translation>
    </message>
    <message>
        <source>the controller does not answer on all topics of the action</source>
        <translation>le contrôleur ne répond pas sur tous les topics de l'action</translation>
    </message>
    <message>
        <source>the copied file</source>
        <translation>le fichier copié</translation>
    </message>
    <message>
        <source>the current position of the robot</source>
        <translation>la position du robot</translation>
    </message>
    <message>
        <source>the data is missing</source>
        <translation>pas de données</translation>
    </message>
    <message>
        <source>the dictionary has no key %1</source>
        <translation>le dictionnaire n'a pas de clé %1</translation>
    </message>
    <message>
        <source>the dictionary has no key '%1'</source>
        <translation>le dictionnaire n'a pas de clé '%1'</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>le disque est plein</translation>
    </message>
    <message>
        <source>the document</source>
        <translation>le document</translation>
    </message>
    <message>
        <source>the element %1 twice</source>
        <translation>un deuxième élément %1</translation>
    </message>
    <message>
        <source>the encoding is guessed</source>
        <translation>l'encodage est deviné</translation>
    </message>
    <message>
        <source>the end of the expression</source>
        <translation>la fin de l'expression</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>la fin du fichier</translation>
    </message>
    <message>
        <source>the end of the loop depends on %1; the moves up to here are read.</source>
        <translation>une boucle qui se termine selon %1 ; ses mouvements sont lus jusque-là.</translation>
    </message>
    <message>
        <source>the entity '%1' is no mannequin</source>
        <translation>l'entité « %1 » n'est pas un mannequin</translation>
    </message>
    <message>
        <source>the entity cannot be moved in this way</source>
        <translation>elle ne peut pas être déplacée ainsi</translation>
    </message>
    <message>
        <source>the entity does not exist</source>
        <translation>cette entité n'existe pas</translation>
    </message>
    <message>
        <source>the entity is locked</source>
        <translation>l'entité est verrouillée</translation>
    </message>
    <message>
        <source>the entity is missing</source>
        <translation>aucune entité</translation>
    </message>
    <message>
        <source>the entity's name</source>
        <translation>le nom de l'entité</translation>
    </message>
    <message>
        <source>the environment variable %1 is not set</source>
        <translation>la variable d'environnement %1 n'est pas définie</translation>
    </message>
    <message>
        <source>the equation covers shifts of up to 8 h.</source>
        <translation>l'équation vaut pour des postes de 8 h au plus.</translation>
    </message>
    <message>
        <source>the exercise '%1' of these results was not found</source>
        <translation>l'exercice '%1' de ces résultats est introuvable</translation>
    </message>
    <message>
        <source>the expression ends too early</source>
        <translation>l'expression se termine trop tôt</translation>
    </message>
    <message>
        <source>the extension %1, which is not supported</source>
        <translation>l'extension %1, qui n'est pas lue</translation>
    </message>
    <message>
        <source>the extension '%1'</source>
        <translation>l'extension '%1'</translation>
    </message>
    <message>
        <source>the extension '%1' (%2), which is not supported</source>
        <translation>l'extension '%1' (%2), qui n'est pas lue</translation>
    </message>
    <message>
        <source>the field '%1'</source>
        <translation>le champ '%1'</translation>
    </message>
    <message>
        <source>the field '%1' is not kept.</source>
        <translation>le champ '%1' n'est pas conservé.</translation>
    </message>
    <message>
        <source>the field is missing</source>
        <translation>le champ manque</translation>
    </message>
    <message>
        <source>the fields of docs/user/formats.md</source>
        <translation>les champs de docs/user/formats.md</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>le fichier</translation>
    </message>
    <message>
        <source>the file %1 does not exist</source>
        <translation>le fichier %1 n'existe pas</translation>
    </message>
    <message>
        <source>the file cannot be read as %1</source>
        <translation>illisible en tant que %1</translation>
    </message>
    <message>
        <source>the file cannot be written</source>
        <translation>impossible d'écrire le fichier</translation>
    </message>
    <message>
        <source>the file could not be read to its end</source>
        <translation>le fichier n'a pas pu être lu jusqu'à sa fin</translation>
    </message>
    <message>
        <source>the file could not be used (%1)</source>
        <translation>le fichier n'a pas pu être utilisé (%1)</translation>
    </message>
    <message>
        <source>the file differs from what was written</source>
        <translation>le fichier diffère de ce qui a été écrit</translation>
    </message>
    <message>
        <source>the file does not exist</source>
        <translation>ce fichier n'existe pas</translation>
    </message>
    <message>
        <source>the file does not state how the hands are turned about the forearms (no fingers, no rest pose); on average, neither pronation nor supination is assumed</source>
        <translation>rien n'indique la rotation des mains autour des avant-bras (ni doigts, ni position de repos) ; supposées en moyenne ni en pronation ni en supination</translation>
    </message>
    <message>
        <source>the file does not state the top of the head; the frame of the head is used</source>
        <translation>rien n'indique où est le sommet de la tête ; le repère propre de la tête est utilisé</translation>
    </message>
    <message>
        <source>the file does not state which axis is up; the body stands along %1, which is used</source>
        <translation>le fichier n'indique pas quel axe est vers le haut ; le corps se tient selon %1, qui est utilisé</translation>
    </message>
    <message>
        <source>the file does not state which axis is up; the markers extend furthest along %1, which is used; to change this, use --up</source>
        <translation>le fichier n'indique pas quel axe est vers le haut ; les marqueurs s'étendent le plus selon %1, qui est utilisé ; --up en indique un autre</translation>
    </message>
    <message>
        <source>the file ends after %1 bytes</source>
        <translation>le fichier s'arrête après %1 octets</translation>
    </message>
    <message>
        <source>the file ends before frame %1</source>
        <translation>le fichier se termine avant l'image %1</translation>
    </message>
    <message>
        <source>the file ends inside a bone</source>
        <translation>le fichier se termine au milieu d'un os</translation>
    </message>
    <message>
        <source>the file ends inside a vertex</source>
        <translation>le fichier s'arrête au milieu d'un sommet</translation>
    </message>
    <message>
        <source>the file ends too early</source>
        <translation>le fichier se termine trop tôt</translation>
    </message>
    <message>
        <source>the file exists</source>
        <translation>le fichier existe</translation>
    </message>
    <message>
        <source>the file has %1 solids; they were joined to one</source>
        <translation>le fichier a %1 solides ; ils ont été pris comme un seul</translation>
    </message>
    <message>
        <source>the file has more than 64 colours; each solid is shown in its average colour</source>
        <translation>le fichier a plus de 64 couleurs ; chaque solide est affiché dans leur moyenne</translation>
    </message>
    <message>
        <source>the file has no argument '%1'; its value %2 was not used</source>
        <translation>le fichier n'a pas d'argument '%1' ; sa valeur %2 n'a pas été utilisée</translation>
    </message>
    <message>
        <source>the file has no model</source>
        <translation>aucun modèle</translation>
    </message>
    <message>
        <source>the file has no rest pose of a standing person; the joint frames are derived from the joint positions in the motion</source>
        <translation>le fichier n'a pas de position de repos d'une personne debout ; l'orientation des repères de ses articulations est déduite de leurs positions dans le mouvement</translation>
    </message>
    <message>
        <source>the file has no triangles</source>
        <translation>aucun triangle</translation>
    </message>
    <message>
        <source>the file has no unit; %1 is assumed</source>
        <translation>le fichier n'indique pas d'unité ; l'unité supposée est %1</translation>
    </message>
    <message>
        <source>the file has no unit; %1 is assumed from its size (to change this, use --unit)</source>
        <translation>le fichier n'indique pas d'unité ; d'après sa taille, l'unité supposée est %1 (--unit pour une autre)</translation>
    </message>
    <message>
        <source>the file has no unit; in metres it measures %1 m, so the unit is probably mm</source>
        <translation>le fichier n'indique pas d'unité ; lu en mètres, il mesure %1 m : il s'agit sans doute de millimètres (unité mm)</translation>
    </message>
    <message>
        <source>the file has no unit; it was read in metres and measures %1 m; if it measures %1 mm, set the unit mm</source>
        <translation>le fichier n'indique pas d'unité ; il a été lu en mètres et mesure %1 m ; s'il mesure %1 millimètres, indiquez l'unité mm</translation>
    </message>
    <message>
        <source>the file has no unit; millimetres are assumed</source>
        <translation>le fichier n'indique pas d'unité ; l'unité supposée est le millimètre</translation>
    </message>
    <message>
        <source>the file has no vertices</source>
        <translation>aucun sommet</translation>
    </message>
    <message>
        <source>the file is UTF-16 text</source>
        <translation>le fichier est un texte UTF-16</translation>
    </message>
    <message>
        <source>the file is already open in HaptiCell: %1</source>
        <translation>il est ouvert dans HaptiCell : %1</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>le fichier est vide</translation>
    </message>
    <message>
        <source>the file is missing in the pack</source>
        <translation>il n'est pas dans l'archive</translation>
    </message>
    <message>
        <source>the file is not xacro; the value of '%1' was not used</source>
        <translation>le fichier n'est pas un xacro ; la valeur de '%1' n'a pas été utilisée</translation>
    </message>
    <message>
        <source>the file is outside the pack</source>
        <translation>il se trouve en dehors de l'archive</translation>
    </message>
    <message>
        <source>the file is too short</source>
        <translation>le fichier est trop court</translation>
    </message>
    <message>
        <source>the file is write-protected</source>
        <translation>un fichier protégé en écriture</translation>
    </message>
    <message>
        <source>the file places its models at random; they are spread evenly</source>
        <translation>le fichier laisse au hasard les positions de ses modèles ; ils sont répartis régulièrement</translation>
    </message>
    <message>
        <source>the file reports an error: %1</source>
        <translation>le fichier signale une erreur : %1</translation>
    </message>
    <message>
        <source>the file states %1 frames but has %2; all %2 are read</source>
        <translation>le fichier annonce %1 images et en a %2 ; toutes sont lues</translation>
    </message>
    <message>
        <source>the file states that %1 is up (Y_SCREEN), but the body stands along %2, which is used; to change this, use --up</source>
        <translation>le fichier indique que %1 est vers le haut (Y_SCREEN), mais le corps se tient selon %2, qui est utilisé ; --up en indique un autre</translation>
    </message>
    <message>
        <source>the file stops with the error: %1</source>
        <translation>le fichier s'arrête avec l'erreur : %1</translation>
    </message>
    <message>
        <source>the file that study run wrote</source>
        <translation>le fichier écrit par study run</translation>
    </message>
    <message>
        <source>the file warns: %1</source>
        <translation>le fichier avertit : %1</translation>
    </message>
    <message>
        <source>the file's %1 axis</source>
        <translation>l'axe %1 du fichier</translation>
    </message>
    <message>
        <source>the file's ending '%1'</source>
        <translation>la terminaison « %1 » du fichier</translation>
    </message>
    <message>
        <source>the folder already exists and is not empty</source>
        <translation>le dossier existe déjà et n'est pas vide</translation>
    </message>
    <message>
        <source>the folder cannot be created</source>
        <translation>impossible de créer le dossier</translation>
    </message>
    <message>
        <source>the folder of saved states</source>
        <translation>le dossier des états conservés</translation>
    </message>
    <message>
        <source>the folder of settings</source>
        <translation>le dossier des réglages</translation>
    </message>
    <message>
        <source>the folder of the file cannot be opened</source>
        <translation>son dossier est inaccessible</translation>
    </message>
    <message>
        <source>the folder of your plug-ins</source>
        <translation>le dossier des modules personnels</translation>
    </message>
    <message>
        <source>the format &quot;%1&quot;</source>
        <translation>le format &quot;%1&quot;</translation>
    </message>
    <message>
        <source>the frame '%1' no longer exists</source>
        <translation>le repère « %1 » n'existe plus</translation>
    </message>
    <message>
        <source>the frame rate is %1 Hz in the parameters and %2 Hz in the header; %1 Hz is used</source>
        <translation>la fréquence d'images est de %1 Hz dans les paramètres et de %2 Hz dans l'en-tête ; %1 Hz est utilisé</translation>
    </message>
    <message>
        <source>the frame rate is missing</source>
        <translation>pas de fréquence d'images</translation>
    </message>
    <message>
        <source>the frames of %1 do not match the rest pose; they are derived from the joint positions</source>
        <translation>les repères de %1 ne sont pas orientés comme à la position de repos ; ils sont déduits des positions des articulations</translation>
    </message>
    <message>
        <source>the goal is not free with a clearance of %1: %2</source>
        <translation>le but n’est pas libre avec une distance de passage de %1 : %2</translation>
    </message>
    <message>
        <source>the goal is out of reach of %1</source>
        <translation>le but est hors de portée de %1</translation>
    </message>
    <message>
        <source>the goal is out of reach of %1, wherever its external axes are</source>
        <translation>le but est hors de portée de %1, où que soient ses axes externes</translation>
    </message>
    <message>
        <source>the goal is out of reach of the %1 of %2 without a step</source>
        <translation>la %1 de %2 n'atteint pas le but sans faire un pas</translation>
    </message>
    <message>
        <source>the goal is out of reach of the %1 of %2 without a step; %3 are missing</source>
        <translation>la %1 de %2 n'atteint pas le but sans faire un pas ; il manque %3</translation>
    </message>
    <message>
        <source>the goal of '%1'</source>
        <translation>le but de « %1 »</translation>
    </message>
    <message>
        <source>the goal says nothing to look at</source>
        <translation>le but ne dit pas quoi regarder</translation>
    </message>
    <message>
        <source>the guide's name</source>
        <translation>le nom du guide virtuel</translation>
    </message>
    <message>
        <source>the hand '%1'</source>
        <translation>la main '%1'</translation>
    </message>
    <message>
        <source>the haptic server was lost after %1 s</source>
        <translation>le serveur haptique a été perdu après %1 s</translation>
    </message>
    <message>
        <source>the haptic server was lost after %1 s: %2</source>
        <translation>le serveur haptique a été perdu après %1 s : %2</translation>
    </message>
    <message>
        <source>the head markers are assumed to be level when the head is upright</source>
        <translation>les marqueurs de la tête sont supposés horizontaux quand la tête est droite</translation>
    </message>
    <message>
        <source>the head markers lean back by %1 deg on average; this is assumed to be how they were attached, with the head level on average</source>
        <translation>les marqueurs de la tête penchent en moyenne de %1 deg vers l'arrière ; cela est pris comme leur placement, la tête étant horizontale en moyenne</translation>
    </message>
    <message>
        <source>the header states %1 analog samples per frame; %2 (channels × samples) match the file size and are read</source>
        <translation>l'en-tête annonce %1 échantillons analogiques par image ; %2 remplissent le fichier (canaux fois échantillons)</translation>
    </message>
    <message>
        <source>the header states %1 frames; the file has %2, which are read</source>
        <translation>l'en-tête annonce %1 images ; %2 sont dans le fichier et sont lues</translation>
    </message>
    <message>
        <source>the hip</source>
        <translation>la hanche</translation>
    </message>
    <message>
        <source>the home folder of this user</source>
        <translation>le dossier personnel de cet utilisateur</translation>
    </message>
    <message>
        <source>the home position is singular</source>
        <translation>sa position de repos est singulière</translation>
    </message>
    <message>
        <source>the import needs more memory than its limit allows</source>
        <translation>il demande plus de mémoire qu'une importation ne peut en utiliser</translation>
    </message>
    <message>
        <source>the import was cancelled</source>
        <translation>l'importation a été annulée</translation>
    </message>
    <message>
        <source>the imported file, unchanged</source>
        <translation>le fichier dont elle a été importée, inchangé</translation>
    </message>
    <message>
        <source>the importer sent invalid data</source>
        <translation>l'importateur a envoyé des données non valides</translation>
    </message>
    <message>
        <source>the index %1 of %2 items</source>
        <translation>l'indice %1 parmi %2 éléments</translation>
    </message>
    <message>
        <source>the input ended without a pairing code</source>
        <translation>fin sans code d'appairage</translation>
    </message>
    <message>
        <source>the job has no instructions</source>
        <translation>le job n'a pas d'instructions</translation>
    </message>
    <message>
        <source>the joint C4</source>
        <translation>l'articulation C4</translation>
    </message>
    <message>
        <source>the joint C7</source>
        <translation>l'articulation C7</translation>
    </message>
    <message>
        <source>the joint L1</source>
        <translation>l'articulation L1</translation>
    </message>
    <message>
        <source>the joint L5</source>
        <translation>l'articulation L5</translation>
    </message>
    <message>
        <source>the joint T6</source>
        <translation>l'articulation T6</translation>
    </message>
    <message>
        <source>the joint names are missing</source>
        <translation>pas de noms d'axes</translation>
    </message>
    <message>
        <source>the joint type '%1'</source>
        <translation>le type d'axe '%1'</translation>
    </message>
    <message>
        <source>the joints form a cycle: every link is the child of another</source>
        <translation>les axes forment un cycle : chaque segment est l'enfant d'un autre</translation>
    </message>
    <message>
        <source>the joints form a cycle: link '%1' (joint '%2') is attached to itself</source>
        <translation>les axes forment un cycle : le segment '%1' (axe '%2') est rattaché à lui-même</translation>
    </message>
    <message>
        <source>the joints of the first message</source>
        <translation>les axes du premier message</translation>
    </message>
    <message>
        <source>the knee</source>
        <translation>le genou</translation>
    </message>
    <message>
        <source>the length %1</source>
        <translation>la norme %1</translation>
    </message>
    <message>
        <source>the length is missing</source>
        <translation>pas de longueur</translation>
    </message>
    <message>
        <source>the library has no robot of this name</source>
        <translation>aucun robot de ce nom n'est fourni</translation>
    </message>
    <message>
        <source>the lift and the forces</source>
        <translation>le levage et les efforts</translation>
    </message>
    <message>
        <source>the limits of its joints keep the tool of %1 from the goal</source>
        <translation>les limites de ses articulations empêchent l’outil de %1 d’atteindre le but</translation>
    </message>
    <message>
        <source>the limits of its joints keep the tool of %1 from the goal, wherever its external axes are</source>
        <translation>les butées de ses articulations empêchent l'outil de %1 d'atteindre le but, où que soient ses axes externes</translation>
    </message>
    <message>
        <source>the link does not exist</source>
        <translation>ce segment n'existe pas</translation>
    </message>
    <message>
        <source>the loops of robot '%1'</source>
        <translation>les boucles du robot '%1'</translation>
    </message>
    <message>
        <source>the lower joint of leg %1</source>
        <translation>l'articulation inférieure de la jambe %1</translation>
    </message>
    <message>
        <source>the lower stop first</source>
        <translation>d'abord la butée inférieure</translation>
    </message>
    <message>
        <source>the macro '%1' has no parameter '%2'</source>
        <translation>la macro '%1' n'a pas de paramètre '%2'</translation>
    </message>
    <message>
        <source>the mannequin does not exist</source>
        <translation>ce mannequin n'existe pas</translation>
    </message>
    <message>
        <source>the mannequin has no such joint</source>
        <translation>le mannequin n'a pas cette articulation</translation>
    </message>
    <message>
        <source>the mannequin sits or kneels; it covers lifts while standing. Use RULA or REBA.</source>
        <translation>le mannequin est assis ou à genoux ; elle vaut pour les levages debout. Utilisez RULA ou REBA.</translation>
    </message>
    <message>
        <source>the marker '%1', which is not in the recording</source>
        <translation>le marqueur '%1', qui n'est pas dans l'enregistrement</translation>
    </message>
    <message>
        <source>the marker on %1 is never visible</source>
        <translation>le marqueur sur %1 n'est jamais vu</translation>
    </message>
    <message>
        <source>the marker on %1 is never visible; it is left out</source>
        <translation>le marqueur sur %1 n'est jamais vu ; il est omis</translation>
    </message>
    <message>
        <source>the marker on %1 is not visible in %2 of %3 frames, for at most %4 s; its position is interpolated</source>
        <translation>le marqueur sur %1 n'est pas vu dans %2 images sur %3, au plus %4 s de suite ; il est placé sur la droite entre les deux</translation>
    </message>
    <message>
        <source>the markers are read as %1; joints are computed from them with HaptiCell's own offsets</source>
        <translation>les marqueurs sont lus comme %1 ; les articulations en sont déduites avec nos propres décalages</translation>
    </message>
    <message>
        <source>the markers of Plug-in Gait (full body) or Helen Hayes with shoulders, elbows and wrists</source>
        <translation>les marqueurs de Plug-in Gait (corps entier) ou Helen Hayes avec épaules, coudes et poignets</translation>
    </message>
    <message>
        <source>the material file %1 is larger than 16 MB; it was not read</source>
        <translation>le fichier de matériaux %1 dépasse 16 Mo ; il n'a pas été lu</translation>
    </message>
    <message>
        <source>the mechanism has no joint</source>
        <translation>le mécanisme n'a pas d'articulation</translation>
    </message>
    <message>
        <source>the mechanism has no parts</source>
        <translation>aucune pièce</translation>
    </message>
    <message>
        <source>the mechanism is no longer in the cell</source>
        <translation>le mécanisme n'est plus dans la cellule</translation>
    </message>
    <message>
        <source>the mesh %1 does not exist; the shape is left out</source>
        <translation>le maillage %1 est introuvable ; la forme est omise</translation>
    </message>
    <message>
        <source>the mesh %1 is left out: a scale of 0</source>
        <translation>le maillage %1 est omis : une échelle de 0</translation>
    </message>
    <message>
        <source>the mesh %1 is outside the package; the shape is left out</source>
        <translation>le maillage %1 sort du paquet ; la forme est omise</translation>
    </message>
    <message>
        <source>the mesh %1 with scale=&quot;%2&quot; instead of three numbers other than 0</source>
        <translation>le maillage %1 avec scale=&quot;%2&quot; au lieu de trois nombres non nuls</translation>
    </message>
    <message>
        <source>the mesh is missing</source>
        <translation>pas de maillage</translation>
    </message>
    <message>
        <source>the method '%1'</source>
        <translation>la méthode « %1 »</translation>
    </message>
    <message>
        <source>the mimicked joint '%1' is not in the file</source>
        <translation>l'axe '%1' à suivre n'est pas dans le fichier</translation>
    </message>
    <message>
        <source>the model has no links</source>
        <translation>aucun segment</translation>
    </message>
    <message>
        <source>the motion could not be slowed to the limits</source>
        <translation>le mouvement n'a pas pu être ralenti jusqu'aux limites</translation>
    </message>
    <message>
        <source>the motion is not the one that was confirmed</source>
        <translation>le mouvement n'est pas celui qui a été confirmé</translation>
    </message>
    <message>
        <source>the motion lasts longer than it should</source>
        <translation>le mouvement dure plus longtemps qu'il ne devrait</translation>
    </message>
    <message>
        <source>the motion moves the robot's base</source>
        <translation>le mouvement déplace la base du robot</translation>
    </message>
    <message>
        <source>the motion of '%1'</source>
        <translation>le mouvement de « %1 »</translation>
    </message>
    <message>
        <source>the motion of an expert</source>
        <translation>le mouvement d'un expert</translation>
    </message>
    <message>
        <source>the name '%1'</source>
        <translation>le nom « %1 »</translation>
    </message>
    <message>
        <source>the name '%1' is already in use</source>
        <translation>le nom '%1' est déjà utilisé</translation>
    </message>
    <message>
        <source>the name '%1' says nothing; that of the file, '%2', is assumed</source>
        <translation>le nom « %1 » ne dit rien ; celui du fichier, « %2 », est supposé</translation>
    </message>
    <message>
        <source>the name '%1' twice</source>
        <translation>deux fois le nom '%1'</translation>
    </message>
    <message>
        <source>the name is missing</source>
        <translation>aucun nom</translation>
    </message>
    <message>
        <source>the name is used twice</source>
        <translation>le nom est utilisé deux fois</translation>
    </message>
    <message>
        <source>the name is used twice or not allowed; this &lt;%1&gt; is renamed '%2'</source>
        <translation>le nom est en double ou n'est pas permis ; ce &lt;%1&gt; s'appelle '%2'</translation>
    </message>
    <message>
        <source>the name is used twice; it is renamed '%1'</source>
        <translation>le nom est en double ; l'élément s'appelle '%1'</translation>
    </message>
    <message>
        <source>the name of a joint</source>
        <translation>le nom d'un axe</translation>
    </message>
    <message>
        <source>the name of a link</source>
        <translation>le nom d'un segment</translation>
    </message>
    <message>
        <source>the name of a link of the URDF</source>
        <translation>le nom d'un segment de l'URDF</translation>
    </message>
    <message>
        <source>the name of a link of the robot</source>
        <translation>l'un de ses segments</translation>
    </message>
    <message>
        <source>the name of a mannequin of the cell</source>
        <translation>le nom d'un mannequin de la cellule</translation>
    </message>
    <message>
        <source>the name of a robot of the cell</source>
        <translation>le nom d'un robot de la cellule</translation>
    </message>
    <message>
        <source>the name of an entity</source>
        <translation>le nom d'une entité</translation>
    </message>
    <message>
        <source>the name of an entity or of a frame of one</source>
        <translation>le nom d'une entité ou d'un repère d'entité</translation>
    </message>
    <message>
        <source>the name of one of its tools</source>
        <translation>le nom d'un de ses outils</translation>
    </message>
    <message>
        <source>the name of the entity whose surface the guide follows</source>
        <translation>le nom de l'entité dont la surface est suivie</translation>
    </message>
    <message>
        <source>the name of the guided entity</source>
        <translation>le nom de l'entité guidée</translation>
    </message>
    <message>
        <source>the name of the robot, '%1'</source>
        <translation>le nom du robot, '%1'</translation>
    </message>
    <message>
        <source>the number of a job</source>
        <translation>le numéro d'un travail</translation>
    </message>
    <message>
        <source>the number of an element that does not exist</source>
        <translation>un élément au-delà du dernier</translation>
    </message>
    <message>
        <source>the number of channels is missing</source>
        <translation>pas de nombre de canaux</translation>
    </message>
    <message>
        <source>the number of frames is missing</source>
        <translation>pas de nombre d'images</translation>
    </message>
    <message>
        <source>the number of the face's corners</source>
        <translation>le nombre de coins de la face</translation>
    </message>
    <message>
        <source>the number on the controller, %1 to %2</source>
        <translation>son numéro sur le contrôleur, de %1 à %2</translation>
    </message>
    <message>
        <source>the numbers are missing</source>
        <translation>pas de nombres d'éléments</translation>
    </message>
    <message>
        <source>the numbers of vertices, faces and edges</source>
        <translation>les nombres de sommets, de faces et d'arêtes</translation>
    </message>
    <message>
        <source>the opening was cancelled</source>
        <translation>l'ouverture a été annulée</translation>
    </message>
    <message>
        <source>the other side did not use the pairing key</source>
        <translation>l'autre côté n'a pas utilisé la clé d'appairage</translation>
    </message>
    <message>
        <source>the other side has a different pairing key</source>
        <translation>l'autre côté a une autre clé d'appairage</translation>
    </message>
    <message>
        <source>the package of %1 is not found by name; the folder %2 is used, because it contains the rest of the path</source>
        <translation>le paquet de %1 est introuvable par son nom ; le dossier %2, qui contient le reste du chemin, est pris à sa place</translation>
    </message>
    <message>
        <source>the package's folder</source>
        <translation>le dossier du paquet</translation>
    </message>
    <message>
        <source>the pair set's name</source>
        <translation>le nom du jeu de paires</translation>
    </message>
    <message>
        <source>the pairing code on one line</source>
        <translation>le code sur une ligne</translation>
    </message>
    <message>
        <source>the parameter '%1'</source>
        <translation>le paramètre '%1'</translation>
    </message>
    <message>
        <source>the parameters are missing</source>
        <translation>les paramètres manquent</translation>
    </message>
    <message>
        <source>the parameters state %1 points and the header %2; the header matches the file size and is used</source>
        <translation>les paramètres annoncent %1 points et l'en-tête %2, ce qui remplit le fichier</translation>
    </message>
    <message>
        <source>the part does not exist</source>
        <translation>cette pièce n'existe pas</translation>
    </message>
    <message>
        <source>the part that &lt;submesh&gt; names</source>
        <translation>la pièce que cite &lt;submesh&gt;</translation>
    </message>
    <message>
        <source>the parts cannot be written as STEP</source>
        <translation>les pièces ne peuvent pas être écrites en STEP</translation>
    </message>
    <message>
        <source>the place of this program is not known</source>
        <translation>l'emplacement de ce programme est inconnu</translation>
    </message>
    <message>
        <source>the place that you showed</source>
        <translation>la place que vous avez montrée</translation>
    </message>
    <message>
        <source>the placements of the imported files</source>
        <translation>les places des fichiers importés</translation>
    </message>
    <message>
        <source>the plan for '%1'</source>
        <translation>le trajet de « %1 »</translation>
    </message>
    <message>
        <source>the platform</source>
        <translation>la plateforme</translation>
    </message>
    <message>
        <source>the population is left out: it has no region, no models or more than 5000 models</source>
        <translation>la population est omise : elle n'a pas de région, ou aucun modèle, ou plus de 5000</translation>
    </message>
    <message>
        <source>the population is left out: its grid has no models or more than 5000</source>
        <translation>la population est omise : une grille vide ou de plus de 5000 modèles</translation>
    </message>
    <message>
        <source>the pose '%1' has %2 numbers instead of %3; 0 is assumed for the others</source>
        <translation>la pose '%1' a %2 nombres au lieu de %3 ; les autres sont pris égaux à 0</translation>
    </message>
    <message>
        <source>the pose '%1' has a quaternion of length 0; no rotation is assumed</source>
        <translation>la pose '%1' a un quaternion de longueur nulle ; l'absence de rotation est supposée</translation>
    </message>
    <message>
        <source>the pose and joint values of the workcell</source>
        <translation>la pose et les axes de la cellule</translation>
    </message>
    <message>
        <source>the pose or the status is missing or invalid</source>
        <translation>la pose ou l'état manque ou n'est pas valide</translation>
    </message>
    <message>
        <source>the position is missing or invalid</source>
        <translation>la position manque ou n'est pas valide</translation>
    </message>
    <message>
        <source>the positions are missing</source>
        <translation>les positions manquent</translation>
    </message>
    <message>
        <source>the posture does not show which axis is up (the person lies or turns over); y is assumed, as usual in BVH and ASF; to change this, use --up</source>
        <translation>la posture n'indique pas quel axe est vers le haut (la personne est allongée, ou se retourne) ; l'axe y du fichier est utilisé, comme en BVH et ASF ; --up en indique un autre</translation>
    </message>
    <message>
        <source>the program %1 could not be started: %2</source>
        <translation>le programme %1 n'a pas pu être lancé : %2</translation>
    </message>
    <message>
        <source>the program %1 is not installed</source>
        <translation>le programme %1 n'est pas installé</translation>
    </message>
    <message>
        <source>the program as written</source>
        <translation>le programme tel qu'il a été écrit</translation>
    </message>
    <message>
        <source>the program ffmpeg is not installed</source>
        <translation>le programme ffmpeg n'est pas installé</translation>
    </message>
    <message>
        <source>the program ffmpeg, to write videos</source>
        <translation>ffmpeg, qui écrit les vidéos</translation>
    </message>
    <message>
        <source>the program hapticell-ros2 is not installed</source>
        <translation>le programme hapticell-ros2 n’est pas installé</translation>
    </message>
    <message>
        <source>the program has no lines</source>
        <translation>le programme n'a pas de lignes</translation>
    </message>
    <message>
        <source>the program has no moves</source>
        <translation>le programme n'a pas de mouvements</translation>
    </message>
    <message>
        <source>the property '%1' depends on itself (%2)</source>
        <translation>la propriété '%1' dépend d'elle-même (%2)</translation>
    </message>
    <message>
        <source>the property '%1' with more than one of value, default and remove</source>
        <translation>la propriété '%1' avec plus d'un parmi value, default et remove</translation>
    </message>
    <message>
        <source>the reader did not acknowledge the motion</source>
        <translation>le lecteur n'a pas accusé réception du mouvement</translation>
    </message>
    <message>
        <source>the reader rejected the file (%1)</source>
        <translation>le lecteur l'a refusé (%1)</translation>
    </message>
    <message>
        <source>the reading was cancelled</source>
        <translation>la lecture a été annulée</translation>
    </message>
    <message>
        <source>the result of %1() is too large or undefined</source>
        <translation>%1() trop grand ou non défini</translation>
    </message>
    <message>
        <source>the result of '%1'</source>
        <translation>le résultat de '%1'</translation>
    </message>
    <message>
        <source>the results of a study</source>
        <translation>les résultats d'une étude</translation>
    </message>
    <message>
        <source>the robot does not publish all joints of the motion</source>
        <translation>le robot ne publie pas toutes les articulations du mouvement</translation>
    </message>
    <message>
        <source>the robot file has no speed limits</source>
        <translation>le fichier du robot ne donne pas de vitesse</translation>
    </message>
    <message>
        <source>the robot has no joint of this name</source>
        <translation>le robot n'a pas d'axe de ce nom</translation>
    </message>
    <message>
        <source>the robot has no tip</source>
        <translation>le robot n'a pas d'extrémité</translation>
    </message>
    <message>
        <source>the robot of these joints</source>
        <translation>le robot auquel appartiennent ces axes</translation>
    </message>
    <message>
        <source>the robot's base</source>
        <translation>la base du robot</translation>
    </message>
    <message>
        <source>the robot's joint states did not come for 0.5 s</source>
        <translation>les états articulaires du robot ne sont pas venus pendant 0,5 s</translation>
    </message>
    <message>
        <source>the robots %1</source>
        <translation>les robots %1</translation>
    </message>
    <message>
        <source>the rods do not reach the platform at the home position</source>
        <translation>les barres n'atteignent pas la plateforme à la position de repos</translation>
    </message>
    <message>
        <source>the root element &lt;%1&gt;</source>
        <translation>l'élément racine &lt;%1&gt;</translation>
    </message>
    <message>
        <source>the rotation format '%1' is not known; roll, pitch, yaw is assumed</source>
        <translation>le format de rotation '%1' est inconnu ; roulis, tangage, lacet est supposé</translation>
    </message>
    <message>
        <source>the rotation order '%1'</source>
        <translation>l'ordre de rotation '%1'</translation>
    </message>
    <message>
        <source>the rule for '%1' and '%2' is left out: %3</source>
        <translation>la règle pour '%1' et '%2' est ignorée : %3</translation>
    </message>
    <message>
        <source>the same</source>
        <translation>les mêmes</translation>
    </message>
    <message>
        <source>the same as in the first</source>
        <translation>ceux du premier</translation>
    </message>
    <message>
        <source>the same content as the packed file</source>
        <translation>le même contenu que le fichier archivé</translation>
    </message>
    <message>
        <source>the same kind of entity as before</source>
        <translation>le même type d'entité qu'avant</translation>
    </message>
    <message>
        <source>the same link as in the workcell</source>
        <translation>le segment de la cellule</translation>
    </message>
    <message>
        <source>the same number</source>
        <translation>le même nombre</translation>
    </message>
    <message>
        <source>the same number of frames as in the recording</source>
        <translation>le même nombre d'images que dans l'enregistrement</translation>
    </message>
    <message>
        <source>the scale factor is not a number</source>
        <translation>une échelle qui n'est pas un nombre</translation>
    </message>
    <message>
        <source>the scale of the points is %1 in the header and %2 in the parameters; %1 is used</source>
        <translation>l'échelle des points est de %1 dans l'en-tête et de %2 dans les paramètres ; %1 est utilisé</translation>
    </message>
    <message>
        <source>the server stopped sending the state of the stylus</source>
        <translation>l'état du stylet n'arrive plus</translation>
    </message>
    <message>
        <source>the shape is left out: %1</source>
        <translation>la forme est omise : %1</translation>
    </message>
    <message>
        <source>the stance '%1'</source>
        <translation>la station « %1 »</translation>
    </message>
    <message>
        <source>the start is not free: %1</source>
        <translation>le départ n’est pas libre : %1</translation>
    </message>
    <message>
        <source>the start value of joint '%1' is not a number</source>
        <translation>la valeur initiale de l'axe '%1' n'est pas un nombre</translation>
    </message>
    <message>
        <source>the surface is missing</source>
        <translation>aucune surface</translation>
    </message>
    <message>
        <source>the surface is not closed, so the volume is not reliable</source>
        <translation>la surface n'est pas fermée, donc le volume n'est qu'indicatif</translation>
    </message>
    <message>
        <source>the system did not provide random numbers</source>
        <translation>le système ne fournit pas de nombres aléatoires</translation>
    </message>
    <message>
        <source>the tag %1</source>
        <translation>l'étiquette %1</translation>
    </message>
    <message>
        <source>the task has no agent '%1'</source>
        <translation>la tâche n'a pas d'agent « %1 »</translation>
    </message>
    <message>
        <source>the task's name</source>
        <translation>le nom de la tâche</translation>
    </message>
    <message>
        <source>the tool of '%1'</source>
        <translation>l'outil de '%1'</translation>
    </message>
    <message>
        <source>the top level</source>
        <translation>le premier niveau</translation>
    </message>
    <message>
        <source>the top of the head</source>
        <translation>le sommet de la tête</translation>
    </message>
    <message>
        <source>the trajectory does not name the entity that moves</source>
        <translation>la trajectoire ne dit pas ce qui bouge</translation>
    </message>
    <message>
        <source>the trajectory of a robot</source>
        <translation>la trajectoire d'un robot</translation>
    </message>
    <message>
        <source>the trajectory's name</source>
        <translation>le nom de la trajectoire</translation>
    </message>
    <message>
        <source>the tree and the placements of the parts are not kept in this format</source>
        <translation>ce format ne conserve ni l'arbre ni les placements des pièces</translation>
    </message>
    <message>
        <source>the triangles face inward, so the volume is negative</source>
        <translation>les triangles sont tournés vers l'intérieur, donc le volume est négatif</translation>
    </message>
    <message>
        <source>the triangles face inward; they are treated as facing outward</source>
        <translation>les triangles sont tournés vers l'intérieur ; ils sont traités comme tournés vers l'extérieur</translation>
    </message>
    <message>
        <source>the triangles of %1 bodies face inward; they are treated as facing outward</source>
        <translation>les triangles de %1 corps sont tournés vers l'intérieur ; ils sont traités comme tournés vers l'extérieur</translation>
    </message>
    <message>
        <source>the type is wrong or missing</source>
        <translation>le type est faux ou manque</translation>
    </message>
    <message>
        <source>the unit '%1'</source>
        <translation>l'unité '%1'</translation>
    </message>
    <message>
        <source>the unit '%1' is incomplete; %2 is assumed</source>
        <translation>l'unité '%1' est tronquée ; lue comme %2</translation>
    </message>
    <message>
        <source>the unit '%1' is not known; millimetres are assumed</source>
        <translation>l'unité '%1' n'est pas connue ; le millimètre est supposé</translation>
    </message>
    <message>
        <source>the unit of length is missing</source>
        <translation>pas d'unité de longueur</translation>
    </message>
    <message>
        <source>the unknown key '%1'</source>
        <translation>la clé inconnue '%1'</translation>
    </message>
    <message>
        <source>the unknown number %1</source>
        <translation>le numéro inconnu %1</translation>
    </message>
    <message>
        <source>the unpacked size exceeds the limit</source>
        <translation>la taille décompressée dépasse la limite</translation>
    </message>
    <message>
        <source>the upper joint of leg %1</source>
        <translation>l'articulation supérieure de la jambe %1</translation>
    </message>
    <message>
        <source>the user frame %1</source>
        <translation>le repère utilisateur %1</translation>
    </message>
    <message>
        <source>the variant's shape, place, joints and tool</source>
        <translation>la forme, la place, les axes et l'outil de la variante</translation>
    </message>
    <message>
        <source>the version number is missing</source>
        <translation>le numéro de version manque</translation>
    </message>
    <message>
        <source>the way of '%1'</source>
        <translation>le chemin de « %1 »</translation>
    </message>
    <message>
        <source>the whole number %1</source>
        <translation>le nombre entier %1</translation>
    </message>
    <message>
        <source>the work object '%1'</source>
        <translation>l'objet de travail '%1'</translation>
    </message>
    <message>
        <source>the work object, which the file does not define</source>
        <translation>l'objet de travail dont le fichier n'a pas de valeur</translation>
    </message>
    <message>
        <source>there are no joints for the toes; the feet follow the ankles</source>
        <translation>il n'y a pas d'articulations pour les orteils ; les pieds suivent leurs chevilles</translation>
    </message>
    <message>
        <source>there are no markers on the fingers; straight wrists are assumed</source>
        <translation>il n'y a pas de marqueurs sur les doigts ; les poignets sont supposés droits</translation>
    </message>
    <message>
        <source>there are no markers on the head; it follows the chest, which also affects the neck score</source>
        <translation>il n'y a pas de marqueurs sur la tête ; elle suit le thorax, et le score du cou avec elle</translation>
    </message>
    <message>
        <source>there are no markers on the heels; straight feet are assumed</source>
        <translation>il n'y a pas de marqueurs sur les talons ; les pieds sont supposés droits</translation>
    </message>
    <message>
        <source>there are no markers on the toes; straight feet are assumed</source>
        <translation>il n'y a pas de marqueurs sur les orteils ; les pieds sont supposés droits</translation>
    </message>
    <message>
        <source>there is a frame at %1 s</source>
        <translation>il y a une image à %1 s</translation>
    </message>
    <message>
        <source>there is no joint for the neck; its base is assumed midway between the collars</source>
        <translation>il n'y a pas d'articulation pour le cou ; sa base est placée au milieu entre les clavicules</translation>
    </message>
    <message>
        <source>there is no joint for the neck; its base is assumed midway between the shoulders</source>
        <translation>il n'y a pas d'articulation pour le cou ; sa base est placée au milieu entre les épaules</translation>
    </message>
    <message>
        <source>there is no joint for the spine; the trunk moves as one piece</source>
        <translation>il n'y a pas d'articulation pour la colonne ; le tronc est d'un seul tenant</translation>
    </message>
    <message>
        <source>there is no room around the place where it is</source>
        <translation>il n'y a pas de place autour de l'endroit où il est</translation>
    </message>
    <message>
        <source>theta, d, a, alpha and types of one length, 1 to 16</source>
        <translation>theta, d, a, alpha et types d'une même longueur, de 1 à 16</translation>
    </message>
    <message>
        <source>they cannot be closed from the start values; a gap of %1 remains</source>
        <translation>elles ne peuvent pas être fermées depuis le départ ; il reste un écart de %1</translation>
    </message>
    <message>
        <source>they differ from the packed ones</source>
        <translation>elles diffèrent de celles qui ont été archivées</translation>
    </message>
    <message>
        <source>this display has no OpenGL 3.3</source>
        <translation>pas d'OpenGL 3.3 sur cet affichage</translation>
    </message>
    <message>
        <source>this frame does not exist</source>
        <translation>cette image n'existe pas</translation>
    </message>
    <message>
        <source>this key does not exist</source>
        <translation>cette clé n'existe pas</translation>
    </message>
    <message>
        <source>this part is not in the package</source>
        <translation>cet élément n'est pas dans le paquet</translation>
    </message>
    <message>
        <source>this program next to the other programs of HaptiCell</source>
        <translation>ce programme à côté des autres programmes de HaptiCell</translation>
    </message>
    <message>
        <source>three coordinates</source>
        <translation>trois coordonnées</translation>
    </message>
    <message>
        <source>three numbers</source>
        <translation>trois nombres</translation>
    </message>
    <message>
        <source>three numbers in metres</source>
        <translation>trois nombres, en mètres</translation>
    </message>
    <message>
        <source>three numbers with '.' as decimal point</source>
        <translation>trois nombres avec '.' comme séparateur décimal</translation>
    </message>
    <message>
        <source>three numbers, not all 0</source>
        <translation>trois nombres, pas tous 0</translation>
    </message>
    <message>
        <source>three points of a circle in order</source>
        <translation>trois points d'un cercle</translation>
    </message>
    <message>
        <source>through</source>
        <translation>passage par</translation>
    </message>
    <message>
        <source>tick %1</source>
        <translation>cycle %1</translation>
    </message>
    <message>
        <source>time</source>
        <translation>temps</translation>
    </message>
    <message>
        <source>time %1</source>
        <translation>temps %1</translation>
    </message>
    <message>
        <source>time-optimal or constant-speed</source>
        <translation>time-optimal ou constant-speed</translation>
    </message>
    <message>
        <source>times</source>
        <translation>fois</translation>
    </message>
    <message>
        <source>times are whole numbers up to %1: milliseconds are assumed</source>
        <translation>les temps sont des nombres entiers jusqu'à %1 : l'unité supposée est la milliseconde</translation>
    </message>
    <message>
        <source>times start at %1: clock times in microseconds are assumed; the first line is time 0</source>
        <translation>les temps commencent à %1 : temps d'horloge supposés en microsecondes ; la première ligne est le temps 0</translation>
    </message>
    <message>
        <source>times start at %1: clock times in milliseconds are assumed; the first line is time 0</source>
        <translation>les temps commencent à %1 : temps d'horloge supposés en millisecondes ; la première ligne est le temps 0</translation>
    </message>
    <message>
        <source>times start at %1: clock times in nanoseconds are assumed; the first line is time 0</source>
        <translation>les temps commencent à %1 : temps d'horloge supposés en nanosecondes ; la première ligne est le temps 0</translation>
    </message>
    <message>
        <source>times start at %1: the first line is time 0</source>
        <translation>les temps commencent à %1 : la première ligne est le temps 0</translation>
    </message>
    <message>
        <source>times that increase</source>
        <translation>des temps croissants</translation>
    </message>
    <message>
        <source>to device edge</source>
        <translation>jusqu'au bord</translation>
    </message>
    <message>
        <source>to is not above from</source>
        <translation>to n'est pas supérieur à from</translation>
    </message>
    <message>
        <source>too many brackets</source>
        <translation>trop de parenthèses</translation>
    </message>
    <message>
        <source>too many results files of this name</source>
        <translation>trop de fichiers de résultats de ce nom</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>outil</translation>
    </message>
    <message>
        <source>topic %1</source>
        <translation>sujet %1</translation>
    </message>
    <message>
        <source>topic %1, message %2</source>
        <translation>sujet %1, message %2</translation>
    </message>
    <message>
        <source>topics</source>
        <translation>sujets</translation>
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
        <source>trajectories</source>
        <translation>trajectoires</translation>
    </message>
    <message>
        <source>trajectory %1</source>
        <translation>trajectoire %1</translation>
    </message>
    <message>
        <source>trajectory '%1'</source>
        <translation>trajectoire '%1'</translation>
    </message>
    <message>
        <source>trajectory '%1' is not read: %2</source>
        <translation>la trajectoire '%1' n'est pas lue : %2</translation>
    </message>
    <message>
        <source>transfer: an exercise that the trainee did not practise</source>
        <translation>transfer : un exercice que l'apprenant n'a pas pratiqué</translation>
    </message>
    <message>
        <source>triangle %1 of %2</source>
        <translation>triangle %1 sur %2</translation>
    </message>
    <message>
        <source>triangles as in AP242</source>
        <translation>des triangles selon AP242</translation>
    </message>
    <message>
        <source>triangles that share an edge with more than two faces, or are flipped</source>
        <translation>triangles à une arête de plus de deux faces, ou retournés</translation>
    </message>
    <message>
        <source>trimmed</source>
        <translation>rogné</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>true, false, or a number</source>
        <translation>true, false ou un nombre</translation>
    </message>
    <message>
        <source>true, or false for a motion that has only joints</source>
        <translation>true, ou false pour un mouvement d'axes</translation>
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
        <source>trunk, feet or pelvis</source>
        <translation>trunk, feet ou pelvis</translation>
    </message>
    <message>
        <source>trunk, feet, pelvis, seat or none</source>
        <translation>trunk, feet, pelvis, seat ou none</translation>
    </message>
    <message>
        <source>turn on</source>
        <translation>mettre en marche</translation>
    </message>
    <message>
        <source>turns is not a whole number</source>
        <translation>turns n'est pas un nombre entier</translation>
    </message>
    <message>
        <source>two columns '%1'</source>
        <translation>deux colonnes '%1'</translation>
    </message>
    <message>
        <source>two different parts</source>
        <translation>deux pièces</translation>
    </message>
    <message>
        <source>two documents, or one with --since-import</source>
        <translation>deux documents, ou un seul avec --since-import</translation>
    </message>
    <message>
        <source>two entities</source>
        <translation>deux entités</translation>
    </message>
    <message>
        <source>two joints that turn in a fixed ratio</source>
        <translation>deux articulations qui tournent dans un rapport fixe</translation>
    </message>
    <message>
        <source>two numbers</source>
        <translation>deux nombres</translation>
    </message>
    <message>
        <source>two numbers or two texts</source>
        <translation>deux nombres ou deux textes</translation>
    </message>
    <message>
        <source>two numbers, or no limits</source>
        <translation>deux nombres, ou aucun</translation>
    </message>
    <message>
        <source>two or more</source>
        <translation>deux ou plus</translation>
    </message>
    <message>
        <source>two points of the same dimension</source>
        <translation>deux points</translation>
    </message>
    <message>
        <source>two positions</source>
        <translation>deux positions</translation>
    </message>
    <message>
        <source>two root links, '%1' (%2) and '%3'</source>
        <translation>deux segments racines, '%1' (%2) et '%3'</translation>
    </message>
    <message>
        <source>undefined substitution argument %1</source>
        <translation>argument de substitution %1 non défini</translation>
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
        <source>unexpected error: %1</source>
        <translation>erreur inattendue : %1</translation>
    </message>
    <message>
        <source>unique names</source>
        <translation>des noms tous différents</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>unité</translation>
    </message>
    <message>
        <source>unlimited</source>
        <translation>illimitée</translation>
    </message>
    <message>
        <source>up</source>
        <translation>haut</translation>
    </message>
    <message>
        <source>usb </source>
        <translation>usb </translation>
    </message>
    <message>
        <source>valid SDF</source>
        <translation>du SDF valide</translation>
    </message>
    <message>
        <source>valid curves and surfaces</source>
        <translation>des courbes et des surfaces valides</translation>
    </message>
    <message>
        <source>valid poses, finite numbers</source>
        <translation>des poses valides, des nombres finis</translation>
    </message>
    <message>
        <source>values above 0</source>
        <translation>des valeurs positives</translation>
    </message>
    <message>
        <source>variant %1</source>
        <translation>variante %1</translation>
    </message>
    <message>
        <source>variant %1 is also in %2</source>
        <translation>la variante %1 est aussi dans %2</translation>
    </message>
    <message>
        <source>vary '%1'</source>
        <translation>vary « %1 »</translation>
    </message>
    <message>
        <source>version %1</source>
        <translation>version %1</translation>
    </message>
    <message>
        <source>vertex %1 of %2</source>
        <translation>sommet %1 sur %2</translation>
    </message>
    <message>
        <source>vertex index %1</source>
        <translation>indice de sommet %1</translation>
    </message>
    <message>
        <source>vertex number %1</source>
        <translation>numéro de sommet %1</translation>
    </message>
    <message>
        <source>vertex numbers from 0 to %1</source>
        <translation>des numéros de sommets de 0 à %1</translation>
    </message>
    <message>
        <source>w, x, y, z with length 1</source>
        <translation>w, x, y, z de norme 1</translation>
    </message>
    <message>
        <source>weight of '%1'</source>
        <translation>poids de « %1 »</translation>
    </message>
    <message>
        <source>well-formed XML</source>
        <translation>du XML bien formé</translation>
    </message>
    <message>
        <source>what = &quot;%1&quot;</source>
        <translation>what = &quot;%1&quot;</translation>
    </message>
    <message>
        <source>what the motion moves</source>
        <translation>ce que le mouvement déplace</translation>
    </message>
    <message>
        <source>what was packed</source>
        <translation>ce qui a été archivé</translation>
    </message>
    <message>
        <source>where it is held</source>
        <translation>là où elle est tenue</translation>
    </message>
    <message>
        <source>whole seconds and nanoseconds</source>
        <translation>des secondes et nanosecondes entières</translation>
    </message>
    <message>
        <source>whole, left_hand, right_hand, both_hands, head or self_origin</source>
        <translation>whole, left_hand, right_hand, both_hands, head ou self_origin</translation>
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
        <source>with this file, the pack is larger than 2 GB</source>
        <translation>avec lui, l'archive dépasse 2 Go</translation>
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
        <source>writing</source>
        <translation>écriture</translation>
    </message>
    <message>
        <source>x, y and z</source>
        <translation>x, y et z</translation>
    </message>
    <message>
        <source>x, y or z</source>
        <translation>x, y ou z</translation>
    </message>
    <message>
        <source>x, y or z: the plane's normal</source>
        <translation>x, y ou z : la normale du plan</translation>
    </message>
    <message>
        <source>x, y, z</source>
        <translation>x, y, z</translation>
    </message>
    <message>
        <source>x, y, z, -x, -y or -z</source>
        <translation>x, y, z, -x, -y ou -z</translation>
    </message>
    <message>
        <source>x,y,z,qw,qx,qy,qz</source>
        <translation>x,y,z,qw,qx,qy,qz</translation>
    </message>
    <message>
        <source>x,y,z,qw,qx,qy,qz: metres and a quaternion of length 1</source>
        <translation>x,y,z,qw,qx,qy,qz : mètres et un quaternion de longueur 1</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>your own measures</source>
        <translation>mesures propres</translation>
    </message>
    <message>
        <source>zero-area triangles, left out in a workcell</source>
        <translation>triangles d'aire nulle, laissés de côté dans une cellule</translation>
    </message>
    <message>
        <source>zfill(%1)</source>
        <translation>zfill(%1)</translation>
    </message>
    <message>
        <source>zstd, lz4 or none</source>
        <translation>zstd, lz4 ou aucune</translation>
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
        <source>%1 fields</source>
        <translation>%1 champs</translation>
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
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>%1 x %2 pixels</source>
        <translation>%1 x %2 pixels</translation>
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
        <source>.pdf, .html, .csv or .json</source>
        <translation>.pdf, .html, .csv ou .json</translation>
    </message>
    <message>
        <source>0 to 120 per minute</source>
        <translation>0 à 120 par minute</translation>
    </message>
    <message>
        <source>0 to 180 degrees</source>
        <translation>0 à 180 degrés</translation>
    </message>
    <message>
        <source>0 to 2 m</source>
        <translation>0 à 2 m</translation>
    </message>
    <message>
        <source>0 to 200 kg</source>
        <translation>0 à 200 kg</translation>
    </message>
    <message>
        <source>0 to 24 hours</source>
        <translation>0 à 24 heures</translation>
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
        <source>Assess the task with another method, such as RULA, REBA or EN 1005-2.</source>
        <translation>Évaluez la tâche avec une autre méthode, par exemple RULA, REBA ou EN 1005-2.</translation>
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
        <source>Change that task first.</source>
        <translation>Modifiez d'abord cette tâche.</translation>
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
        <source>Spread the tasks over the day.</source>
        <translation>Répartissez les tâches sur la journée.</translation>
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
        <source>The equation covers shifts of up to 8 h.</source>
        <translation>L'équation couvre des postes de 8 h au plus.</translation>
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
        <source>a PNG file</source>
        <translation>un fichier PNG</translation>
    </message>
    <message>
        <source>a column limit_n in newtons</source>
        <translation>une colonne limit_n en newtons</translation>
    </message>
    <message>
        <source>a force above 0, at most 5000 N</source>
        <translation>une force supérieure à 0 et d'au plus 5000 N</translation>
    </message>
    <message>
        <source>a force in newtons</source>
        <translation>une force en newtons</translation>
    </message>
    <message>
        <source>a motion</source>
        <translation>un mouvement</translation>
    </message>
    <message>
        <source>a report that can be rendered</source>
        <translation>un rapport qui peut être dessiné</translation>
    </message>
    <message>
        <source>a smooth two-handed lift, standing</source>
        <translation>un levage régulier à deux mains, debout</translation>
    </message>
    <message>
        <source>a task whose recommended weight limit is 0</source>
        <translation>une tâche dont le poids limite recommandé est 0</translation>
    </message>
    <message>
        <source>a value for this field of the task data</source>
        <translation>une valeur des données de la tâche</translation>
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
        <source>all tasks together have more lifts per minute than the table covers</source>
        <translation>en tout, plus de levages par minute que la table n'en couvre</translation>
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
        <source>at least one lifting task</source>
        <translation>au moins une tâche de levage</translation>
    </message>
    <message>
        <source>at least one limit after the header line</source>
        <translation>au moins une limite après la ligne d'en-tête</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>au plus %1</translation>
    </message>
    <message>
        <source>at most 15 per minute, fewer in longer shifts</source>
        <translation>15 par minute au plus, moins pour un poste plus long</translation>
    </message>
    <message>
        <source>at most 8192 pixels in width and height</source>
        <translation>au plus 8192 pixels en largeur et en hauteur</translation>
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
        <source>each column once</source>
        <translation>chaque colonne une seule fois</translation>
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
        <source>frames</source>
        <translation>images</translation>
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
        <source>good, fair or poor: the equation has no other classes</source>
        <translation>bonne, moyenne ou mauvaise : l'équation n'en connaît pas d'autre</translation>
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
        <source>it cannot be read as a picture</source>
        <translation>il ne peut pas être lu comme une image</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>c'est vide</translation>
    </message>
    <message>
        <source>it is missing</source>
        <translation>absent</translation>
    </message>
    <message>
        <source>it is there twice</source>
        <translation>présent deux fois</translation>
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
        <source>left, right or any</source>
        <translation>left, right ou any</translation>
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
        <source>limit_n, and optionally hand, height_from_m ...</source>
        <translation>limit_n et, au choix, hand, height_from_m ...</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>ligne %1</translation>
    </message>
    <message>
        <source>line %1, %2</source>
        <translation>ligne %1, %2</translation>
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
        <source>metres, 0 or more</source>
        <translation>des mètres, 0 ou plus</translation>
    </message>
    <message>
        <source>mid range</source>
        <translation>mi-course</translation>
    </message>
    <message>
        <source>more than height_from_m</source>
        <translation>plus que height_from_m</translation>
    </message>
    <message>
        <source>more than reach_from_m</source>
        <translation>plus que reach_from_m</translation>
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
        <source>no column has this name</source>
        <translation>il n'y a pas de colonne de ce nom</translation>
    </message>
    <message>
        <source>no extension</source>
        <translation>pas d'extension</translation>
    </message>
    <message>
        <source>no header line</source>
        <translation>pas de ligne d'en-tête</translation>
    </message>
    <message>
        <source>no line of values</source>
        <translation>aucune ligne de valeurs</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
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
        <source>task %1</source>
        <translation>tâche %1</translation>
    </message>
    <message>
        <source>task %1, %2</source>
        <translation>tâche %1, %2</translation>
    </message>
    <message>
        <source>tasks</source>
        <translation>tâches</translation>
    </message>
    <message>
        <source>tasks with a limit above 0</source>
        <translation>des tâches dont la limite est supérieure à 0</translation>
    </message>
    <message>
        <source>the end of the range is below its start</source>
        <translation>la fin précède le début</translation>
    </message>
    <message>
        <source>the extension %1</source>
        <translation>l'extension %1</translation>
    </message>
    <message>
        <source>the lifting equation is not valid for this</source>
        <translation>l'équation de levage ne s'applique pas à ce cas</translation>
    </message>
    <message>
        <source>too many rows</source>
        <translation>trop de lignes</translation>
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
        <source>unacceptable</source>
        <translation>inacceptable</translation>
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
