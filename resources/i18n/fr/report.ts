<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR" sourcelanguage="en">
<context>
    <name>page</name>
    <message>
        <source>Boresight calibration report</source>
        <translation>Rapport d&apos;étalonnage des angles de visée</translation>
    </message>
    <message>
        <source>NOT CALIBRATED</source>
        <translation>NON ÉTALONNÉ</translation>
    </message>
    <message>
        <source>CALIBRATED WITH SERIOUS WARNINGS</source>
        <translation>ÉTALONNÉ, AVEC DES AVERTISSEMENTS GRAVES</translation>
    </message>
    <message>
        <source>CALIBRATED, WITH REMARKS</source>
        <translation>ÉTALONNÉ, AVEC DES REMARQUES</translation>
    </message>
    <message>
        <source>CALIBRATED</source>
        <translation>ÉTALONNÉ</translation>
    </message>
    <message>
        <source>Made {when} by {program}</source>
        <translation>Établi le {when} par {program}</translation>
    </message>
    <message>
        <source>Page {page} of {pages}</source>
        <translation>Page {page} sur {pages}</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Avertissements</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Table des matières</translation>
    </message>
    <message>
        <source>Surveyor</source>
        <translation>Hydrographe</translation>
    </message>
    <message>
        <source>Company</source>
        <translation>Entreprise</translation>
    </message>
    <message>
        <source>Place and date</source>
        <translation>Lieu et date</translation>
    </message>
    <message>
        <source>Signature</source>
        <translation>Signature</translation>
    </message>
    <message>
        <source>Numbers are written with a decimal point, as other programs take them, except in warnings.</source>
        <translation>Les nombres sont écrits avec le point décimal, comme il faut les saisir dans les autres logiciels, sauf dans les avertissements.</translation>
    </message>
    <message>
        <source>1 text of this report stands in English: its translation is not known.</source>
        <translation>1 texte de ce rapport est resté en anglais : sa traduction n&apos;est pas connue.</translation>
    </message>
    <message>
        <source>{count:n} texts of this report stand in English: their translation is not known.</source>
        <translation>{count} textes de ce rapport sont restés en anglais : leur traduction n&apos;est pas connue.</translation>
    </message>
    <message>
        <source>Boresight and its uncertainty</source>
        <translation>Angles de visée et leur incertitude</translation>
    </message>
    <message>
        <source>Targets and residuals</source>
        <translation>Cibles et résidus</translation>
    </message>
    <message>
        <source>Quality of the sightings</source>
        <translation>Qualité des observations</translation>
    </message>
    <message>
        <source>Reliability of the sightings</source>
        <translation>Fiabilité des observations</translation>
    </message>
    <message>
        <source>Cross-checks</source>
        <translation>Vérifications croisées</translation>
    </message>
    <message>
        <source>Validation</source>
        <translation>Validation</translation>
    </message>
    <message>
        <source>Site and lines</source>
        <translation>Site et lignes</translation>
    </message>
    <message>
        <source>Settings and input files</source>
        <translation>Réglages et fichiers d&apos;entrée</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Images</translation>
    </message>
</context>
<context>
    <name>words</name>
    <message>
        <source>roll</source>
        <translation>roulis</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>tangage</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>lacet</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Roulis</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Tangage</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>Lacet</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Cap</translation>
    </message>
    <message>
        <source>North</source>
        <translation>Nord</translation>
    </message>
    <message>
        <source>West</source>
        <translation>Ouest</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>lever arm X</source>
        <translation>bras de levier X</translation>
    </message>
    <message>
        <source>lever arm Y</source>
        <translation>bras de levier Y</translation>
    </message>
    <message>
        <source>lever arm Z</source>
        <translation>bras de levier Z</translation>
    </message>
    <message>
        <source>range offset</source>
        <translation>décalage de distance</translation>
    </message>
    <message>
        <source>scan-angle offset</source>
        <translation>décalage d&apos;angle de balayage</translation>
    </message>
    <message>
        <source>latency</source>
        <translation>latence</translation>
    </message>
    <message>
        <source>Lever arm X</source>
        <translation>Bras de levier X</translation>
    </message>
    <message>
        <source>Lever arm Y</source>
        <translation>Bras de levier Y</translation>
    </message>
    <message>
        <source>Lever arm Z</source>
        <translation>Bras de levier Z</translation>
    </message>
    <message>
        <source>Range offset</source>
        <translation>Décalage de distance</translation>
    </message>
    <message>
        <source>Scan-angle offset</source>
        <translation>Décalage d&apos;angle de balayage</translation>
    </message>
    <message>
        <source>Latency</source>
        <translation>Latence</translation>
    </message>
    <message>
        <source>the lever arm&apos;s X</source>
        <translation>la composante X du bras de levier</translation>
    </message>
    <message>
        <source>the lever arm&apos;s Y</source>
        <translation>la composante Y du bras de levier</translation>
    </message>
    <message>
        <source>the lever arm&apos;s Z</source>
        <translation>la composante Z du bras de levier</translation>
    </message>
    <message>
        <source>the range offset</source>
        <translation>le décalage de distance</translation>
    </message>
    <message>
        <source>the scan-angle offset</source>
        <translation>le décalage d&apos;angle de balayage</translation>
    </message>
    <message>
        <source>the latency</source>
        <translation>la latence</translation>
    </message>
    <message>
        <source>{n:n} deg</source>
        <translation>{n}°</translation>
    </message>
    <message>
        <source>{n:n} mm</source>
        <translation>{n} mm</translation>
    </message>
    <message>
        <source>{n:n} cm</source>
        <translation>{n} cm</translation>
    </message>
    <message>
        <source>{n:n} m</source>
        <translation>{n} m</translation>
    </message>
    <message>
        <source>{n:n} ms</source>
        <translation>{n} ms</translation>
    </message>
    <message>
        <source>{n:n} s</source>
        <translation>{n} s</translation>
    </message>
    <message>
        <source>below 0.1</source>
        <translation>moins de 0.1</translation>
    </message>
    <message>
        <source>below 0.1 mm</source>
        <translation>moins de 0.1 mm</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>0.001 deg</source>
        <translation>0.001°</translation>
    </message>
    <message>
        <source>target</source>
        <translation>cible</translation>
    </message>
    <message>
        <source>validation</source>
        <translation>validation</translation>
    </message>
    <message>
        <source>target, left out</source>
        <translation>cible, écartée</translation>
    </message>
    <message>
        <source>validation, left out</source>
        <translation>validation, écarté</translation>
    </message>
    <message>
        <source>validation plane</source>
        <translation>plan de validation</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>plan</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>sphère</translation>
    </message>
    <message>
        <source>sphere, radius {radius:n} mm</source>
        <translation>sphère, rayon de {radius} mm</translation>
    </message>
    <message>
        <source>{some:n} of {all:n}</source>
        <translation>{some} sur {all}</translation>
    </message>
    <message>
        <source>{n:n} more</source>
        <translation>{n} autres</translation>
    </message>
    <message>
        <source>1 more</source>
        <translation>1 autre</translation>
    </message>
    <message>
        <source>1 target</source>
        <translation>1 cible</translation>
    </message>
    <message>
        <source>{n:n} targets</source>
        <translation>{n} cibles</translation>
    </message>
    <message>
        <source>1 sighting</source>
        <translation>1 observation</translation>
    </message>
    <message>
        <source>{n:n} sightings</source>
        <translation>{n} observations</translation>
    </message>
    <message>
        <source>1 line</source>
        <translation>1 ligne</translation>
    </message>
    <message>
        <source>{n:n} lines</source>
        <translation>{n} lignes</translation>
    </message>
    <message>
        <source>1 stray point</source>
        <translation>1 point aberrant</translation>
    </message>
    <message>
        <source>{n:n} stray points</source>
        <translation>{n} points aberrants</translation>
    </message>
    <message>
        <source>line {line:name}</source>
        <translation>la ligne {line}</translation>
    </message>
    <message>
        <source>lines {lines:list}</source>
        <translation>les lignes {lines}</translation>
    </message>
    <message>
        <source>{target:name} on line {line:name}</source>
        <translation>{target} sur la ligne {line}</translation>
    </message>
    <message>
        <source>{a:name} / {b:name}</source>
        <translation>{a} / {b}</translation>
    </message>
    <message>
        <source>{plane:name}: {pairs:list}</source>
        <translation>{plane} : {pairs}</translation>
    </message>
    <message>
        <source>before</source>
        <translation>avant</translation>
    </message>
    <message>
        <source>after</source>
        <translation>après</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>height</source>
        <translation>la hauteur</translation>
    </message>
    <message>
        <source>range</source>
        <translation>la distance au scanneur</translation>
    </message>
    <message>
        <source>agrees</source>
        <translation>concorde</translation>
    </message>
    <message>
        <source>disagrees</source>
        <translation>en désaccord</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>écartée</translation>
    </message>
    <message>
        <source>not checked</source>
        <translation>non contrôlée</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>sans réponse</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>acceptées</translation>
    </message>
</context>
<context>
    <name>heads</name>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Prior
(deg)</source>
        <translation>A priori
(°)</translation>
    </message>
    <message>
        <source>Estimated
(deg)</source>
        <translation>Estimé
(°)</translation>
    </message>
    <message>
        <source>1 sigma
(deg)</source>
        <translation>Écart-type
(°)</translation>
    </message>
    <message>
        <source>95 % interval
(deg)</source>
        <translation>Intervalle
à 95 % (°)</translation>
    </message>
    <message>
        <source>Truth
(deg)</source>
        <translation>Vrai
(°)</translation>
    </message>
    <message>
        <source>Error
(deg)</source>
        <translation>Erreur
(°)</translation>
    </message>
    <message>
        <source>Roll
(deg)</source>
        <translation>Roulis
(°)</translation>
    </message>
    <message>
        <source>Pitch
(deg)</source>
        <translation>Tangage
(°)</translation>
    </message>
    <message>
        <source>Yaw
(deg)</source>
        <translation>Lacet
(°)</translation>
    </message>
    <message>
        <source>Roll over
its sigma</source>
        <translation>Roulis /
écart-type</translation>
    </message>
    <message>
        <source>Pitch over
its sigma</source>
        <translation>Tangage /
écart-type</translation>
    </message>
    <message>
        <source>Yaw over
its sigma</source>
        <translation>Lacet /
écart-type</translation>
    </message>
    <message>
        <source>North
(mm)</source>
        <translation>Nord
(mm)</translation>
    </message>
    <message>
        <source>West
(mm)</source>
        <translation>Ouest
(mm)</translation>
    </message>
    <message>
        <source>Up
(mm)</source>
        <translation>Haut
(mm)</translation>
    </message>
    <message>
        <source>Heading
(deg)</source>
        <translation>Cap
(°)</translation>
    </message>
    <message>
        <source>North
(m)</source>
        <translation>Nord
(m)</translation>
    </message>
    <message>
        <source>West
(m)</source>
        <translation>Ouest
(m)</translation>
    </message>
    <message>
        <source>Up
(m)</source>
        <translation>Haut
(m)</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rôle</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Threshold
(mm)</source>
        <translation>Seuil
(mm)</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Lignes</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Cible</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Sightings</source>
        <translation>Observations</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>RMS
before (mm)</source>
        <translation>RMS avant
(mm)</translation>
    </message>
    <message>
        <source>RMS
after (mm)</source>
        <translation>RMS après
(mm)</translation>
    </message>
    <message>
        <source>Mean
after (mm)</source>
        <translation>Moyenne
après (mm)</translation>
    </message>
    <message>
        <source>Noise
factor</source>
        <translation>Facteur
de bruit</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Usage</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Octets</translation>
    </message>
    <message>
        <source>SHA-256</source>
        <translation>SHA-256</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Grandeur</translation>
    </message>
    <message>
        <source>Prior</source>
        <translation>A priori</translation>
    </message>
    <message>
        <source>Prior
1 sigma</source>
        <translation>Écart-type
a priori</translation>
    </message>
    <message>
        <source>Estimated</source>
        <translation>Estimé</translation>
    </message>
    <message>
        <source>1 sigma</source>
        <translation>Écart-type</translation>
    </message>
    <message>
        <source>Change over
its sigma</source>
        <translation>Variation /
écart-type</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>Constat</translation>
    </message>
    <message>
        <source>at {distance:n} m</source>
        <translation>à {distance} m</translation>
    </message>
    <message>
        <source>Shift
(mm)</source>
        <translation>Écart
(mm)</translation>
    </message>
    <message>
        <source>w</source>
        <translation>w</translation>
    </message>
    <message>
        <source>Detectable
(mm)</source>
        <translation>Décelable
(mm)</translation>
    </message>
    <message>
        <source>Effect, roll
(deg)</source>
        <translation>Effet, roulis
(°)</translation>
    </message>
    <message>
        <source>Redundancy</source>
        <translation>Redondance</translation>
    </message>
    <message>
        <source>Largest w</source>
        <translation>Plus grand w</translation>
    </message>
    <message>
        <source>Its time (s)</source>
        <translation>Temps (s)</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Partie</translation>
    </message>
    <message>
        <source>RMS
(mm)</source>
        <translation>RMS
(mm)</translation>
    </message>
    <message>
        <source>Range
(m)</source>
        <translation>Distance
(m)</translation>
    </message>
    <message>
        <source>Points
per m²</source>
        <translation>Points
par m²</translation>
    </message>
    <message>
        <source>Incidence
(deg)</source>
        <translation>Incidence
(°)</translation>
    </message>
    <message>
        <source>Covered
(%)</source>
        <translation>Couvert
(%)</translation>
    </message>
    <message>
        <source>Shown
(%)</source>
        <translation>Montré
(%)</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualité</translation>
    </message>
    <message>
        <source>Errors of</source>
        <translation>Erreurs de</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Facteur</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>Intervalle à 95 %</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Médiane</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>68 %</source>
        <translation>68 %</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>99 %</source>
        <translation>99 %</translation>
    </message>
    <message>
        <source>Robust
sigma</source>
        <translation>Écart-type
robuste</translation>
    </message>
    <message>
        <source>Outliers</source>
        <translation>Aberrants</translation>
    </message>
    <message>
        <source>Reciprocal</source>
        <translation>Réciproque</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Endroits</translation>
    </message>
    <message>
        <source>{name}
before</source>
        <translation>{name}
avant</translation>
    </message>
    <message>
        <source>{name}
after</source>
        <translation>{name}
après</translation>
    </message>
    <message>
        <source>95 % of
a place</source>
        <translation>95 % d&apos;un
endroit</translation>
    </message>
    <message>
        <source>Differ
from 0</source>
        <translation>Différents
de 0</translation>
    </message>
    <message>
        <source>Offset
(mm)</source>
        <translation>Décalage
(mm)</translation>
    </message>
    <message>
        <source>Turn, level
axis (deg)</source>
        <translation>Rot., axe
horiz. (°)</translation>
    </message>
    <message>
        <source>Upright
axis (deg)</source>
        <translation>Axe
vert. (°)</translation>
    </message>
</context>
<context>
    <name>summary</name>
    <message>
        <source>Boresight</source>
        <translation>Angles de visée (boresight)</translation>
    </message>
    <message>
        <source>From {points:n} points of {targets} in {sightings} on {lines}: RMS distance to the targets&apos; surfaces {before:n} mm before, {after:n} mm after.</source>
        <translation>À partir de {points} points de {targets}, en {sightings} sur {lines} : distance RMS aux surfaces des cibles de {before} mm avant et de {after} mm après l&apos;étalonnage. Une observation est une cible observée sur une ligne.</translation>
    </message>
    <message>
        <source>The boresight goes with these values, estimated with it: {values:list}.</source>
        <translation>Les angles de visée vont avec ces valeurs, estimées en même temps : {values}.</translation>
    </message>
    <message>
        <source>{parameter} {value:n} m (1 sigma {sigma:n} m)</source>
        <translation>{parameter} {value} m (1 sigma : {sigma} m)</translation>
    </message>
    <message>
        <source>{parameter} {value:n} deg (1 sigma {sigma:n} deg)</source>
        <translation>{parameter} {value}° (1 sigma : {sigma}°)</translation>
    </message>
    <message>
        <source>{parameter} {value:n} ms (1 sigma {sigma:n} ms)</source>
        <translation>{parameter} {value} ms (1 sigma : {sigma} ms)</translation>
    </message>
    <message>
        <source>Validation: distances between lines on planes not used in the adjustment (mm)</source>
        <translation>Validation : distances entre lignes sur des plans non utilisés dans la compensation (mm)</translation>
    </message>
    <message>
        <source>Local frame: north, west, up. Body frame: forward, left, up. Roll is positive with the left side up, pitch positive with the bow down, yaw positive clockwise seen from above. The boresight turns LiDAR axes into body axes: R = Rz(−yaw)·Ry(pitch)·Rx(roll). Other programs use other signs and orders: convert before typing these angles into one.</source>
        <translation>Repère local : nord, ouest, haut. Repère du navire : avant, gauche (bâbord), haut. Le roulis est positif quand bâbord monte, le tangage est positif quand l&apos;étrave descend (piqué), le lacet est positif dans le sens horaire vu d&apos;en haut. Les angles de visée font passer des axes du LiDAR à ceux du navire : R = Rz(−lacet)·​Ry(tangage)·​Rx(roulis). D&apos;autres logiciels ont d&apos;autres signes et un autre ordre : convertissez ces angles avant de les y saisir.</translation>
    </message>
</context>
<context>
    <name>targets</name>
    <message>
        <source>Targets and validation planes as picked (seed in the local frame)</source>
        <translation>Cibles et plans de validation tels que désignés (point initial dans le repère local)</translation>
    </message>
    <message>
        <source>Not found:</source>
        <translation>Non trouvés :</translation>
    </message>
    <message>
        <source>{target:name} on {line:name}: {reason}</source>
        <translation>{target} sur {line} — {reason}</translation>
    </message>
    <message>
        <source>No target has been picked yet.</source>
        <translation>Aucune cible n&apos;a encore été désignée.</translation>
    </message>
    <message>
        <source>Fit of each target, all lines together, to one surface</source>
        <translation>Ajustement de chaque cible, toutes lignes réunies, à une seule surface</translation>
    </message>
    <message>
        <source>Fit of each sighting to its target&apos;s surface</source>
        <translation>Ajustement de chaque observation à la surface de sa cible</translation>
    </message>
    <message>
        <source>RMS of each sighting, before and after.</source>
        <translation>RMS de chaque observation, avant et après.</translation>
    </message>
    <message>
        <source>RMS and mean are distances from the surface that all lines have in common. After the adjustment they still hold the POS error of each sighting, which no boresight removes. The noise factor is the LiDAR noise found in the residuals, with POS errors taken off, over the stated one; where it is above 1 the sigmas of the angles are computed with it.</source>
        <translation>RMS et moyenne sont des distances à la surface commune à toutes les lignes. Après la compensation, elles contiennent encore l&apos;erreur du POS de chaque observation, qu&apos;aucun angle de visée n&apos;enlève. Le facteur de bruit est le bruit du LiDAR trouvé dans les résidus, erreurs du POS retirées, rapporté au bruit déclaré ; là où il dépasse 1, les écarts-types des angles en tiennent compte.</translation>
    </message>
    <message>
        <source>RMS and mean are distances from the surface that all lines have in common. After the adjustment they still hold the POS error of each sighting, which no boresight removes.</source>
        <translation>RMS et moyenne sont des distances à la surface commune à toutes les lignes. Après la compensation, elles contiennent encore l&apos;erreur du POS de chaque observation, qu&apos;aucun angle de visée n&apos;enlève.</translation>
    </message>
    <message>
        <source>Plan of the site, local frame.</source>
        <translation>Plan du site, repère local.</translation>
    </message>
</context>
<context>
    <name>boresight</name>
    <message>
        <source>No boresight has been estimated yet.</source>
        <translation>Les angles de visée n&apos;ont pas encore été estimés.</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajustement</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Itérations</translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation>Degrés de liberté</translation>
    </message>
    <message>
        <source>Variance factor</source>
        <translation>Facteur de variance</translation>
    </message>
    <message>
        <source>Chi-square test at 95 %</source>
        <translation>Test du khi-deux à 95 %</translation>
    </message>
    <message>
        <source>RMS before</source>
        <translation>RMS avant</translation>
    </message>
    <message>
        <source>RMS after</source>
        <translation>RMS après</translation>
    </message>
    <message>
        <source>Model of the POS errors</source>
        <translation>Modèle des erreurs du POS</translation>
    </message>
    <message>
        <source>{points:n}; {strays} stood out from the surface and were kept out of averages</source>
        <translation>{points} ; hors de la surface et tenus hors des moyennes : {strays}</translation>
    </message>
    <message>
        <source>{factor:n}, from the stated sigmas</source>
        <translation>{factor}, d&apos;après les écarts-types déclarés</translation>
    </message>
    <message>
        <source>{factor:n}, from the stated sigmas times the variance components applied</source>
        <translation>{factor}, d&apos;après les écarts-types déclarés multipliés par les composantes de variance appliquées</translation>
    </message>
    <message>
        <source>{factor:n}, from the stated sigmas, before any noise was taken from the residuals</source>
        <translation>{factor}, d&apos;après les écarts-types déclarés, avant que du bruit ne soit tiré des résidus</translation>
    </message>
    <message>
        <source>{factor:n}, from the stated sigmas times the variance components applied, before any noise was taken from the residuals</source>
        <translation>{factor}, d&apos;après les écarts-types déclarés multipliés par les composantes de variance appliquées, avant que du bruit ne soit tiré des résidus</translation>
    </message>
    <message>
        <source>statistic {value:n}</source>
        <translation>statistique {value}</translation>
    </message>
    <message>
        <source>statistic {value:n}, bounds {lower:n} to {upper:n}</source>
        <translation>statistique {value}, bornes de {lower} à {upper}</translation>
    </message>
    <message>
        <source>{rms:n} mm; POS errors not removed</source>
        <translation>{rms} mm ; erreurs du POS non retirées</translation>
    </message>
    <message>
        <source>Not tested: there are no more points than unknowns.</source>
        <translation>Non testé : il n&apos;y a pas plus de points que d&apos;inconnues.</translation>
    </message>
    <message>
        <source>Passed: the residuals are as large as the stated sigmas let one expect.</source>
        <translation>Réussi : les résidus ont la grandeur que laissent attendre les écarts-types déclarés.</translation>
    </message>
    <message>
        <source>Failed: the residuals are larger than the stated sigmas allow.</source>
        <translation>Échoué : les résidus sont plus grands que ne l&apos;admettent les écarts-types déclarés.</translation>
    </message>
    <message>
        <source>A LiDAR sigma stated too small, a rough target or stray points do that.</source>
        <translation>Un écart-type du LiDAR déclaré trop petit, une cible rugueuse ou des points aberrants en sont la cause habituelle.</translation>
    </message>
    <message>
        <source>The sigmas of the angles are computed with the noise found in the residuals.</source>
        <translation>Les écarts-types des angles sont calculés avec le bruit trouvé dans les résidus.</translation>
    </message>
    <message>
        <source>Either those are too small, or a target is not one plane on all lines; the sigmas of the angles are then too small as well.</source>
        <translation>Soit ceux-ci sont trop petits, soit une cible n&apos;est pas un seul et même plan sur toutes les lignes ; les écarts-types des angles sont alors trop petits aussi.</translation>
    </message>
    <message>
        <source>Failed: the residuals are smaller than the stated sigmas let one expect. The LiDAR or POS sigmas are stated too large, and so, where nothing else is in doubt, are those of the angles.</source>
        <translation>Échoué : les résidus sont plus petits que ne le laissent attendre les écarts-types déclarés. Les écarts-types du LiDAR ou du POS sont déclarés trop grands et, si rien d&apos;autre n&apos;est en doute, ceux des angles le sont aussi.</translation>
    </message>
    <message>
        <source>Estimated besides the boresight</source>
        <translation>Estimé en plus des angles de visée</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>non déclaré</translation>
    </message>
    <message>
        <source>held</source>
        <translation>fixé</translation>
    </message>
    <message>
        <source>not seen</source>
        <translation>non vu</translation>
    </message>
    <message>
        <source>not tested (uncorrelated POS errors)</source>
        <translation>non testé (erreurs du POS non corrélées)</translation>
    </message>
    <message>
        <source>significant</source>
        <translation>significatif</translation>
    </message>
    <message>
        <source>not significant</source>
        <translation>non significatif</translation>
    </message>
    <message>
        <source>A change earns its place where it exceeds {limit:n} of its sigmas, which chance does one time in twenty. The boresight of this report goes with the estimated values; with the prior ones it would be another.</source>
        <translation>Une variation est justifiée si elle dépasse {limit} fois son écart-type, ce que le hasard fait une fois sur vingt. Les angles de visée de ce rapport vont avec les valeurs estimées ; avec les valeurs a priori, ils seraient autres.</translation>
    </message>
    <message>
        <source>Correlations</source>
        <translation>Corrélations</translation>
    </message>
    <message>
        <source>Correlations of all estimated values.</source>
        <translation>Corrélations de toutes les valeurs estimées.</translation>
    </message>
    <message>
        <source>What the lines see:</source>
        <translation>Ce que voient les lignes :</translation>
    </message>
    <message>
        <source>Condition number of the angles&apos; normal matrix: {number} (1 would mean that all directions are known alike).</source>
        <translation>Conditionnement de la matrice normale des angles : {number} (1 signifierait que toutes les directions sont également connues).</translation>
    </message>
    <message>
        <source>1 sigma of the angles with one line omitted</source>
        <translation>Écart-type des angles sans l&apos;une des lignes</translation>
    </message>
    <message>
        <source>All lines</source>
        <translation>Toutes les lignes</translation>
    </message>
    <message>
        <source>Without {line:name}</source>
        <translation>Sans {line}</translation>
    </message>
    <message>
        <source>Displacement of a point by 1 sigma of the boresight (cm)</source>
        <translation>Déplacement d&apos;un point pour un écart-type des angles de visée (cm)</translation>
    </message>
    <message>
        <source>All three together, in the direction where they show most</source>
        <translation>Les trois ensemble, dans la direction où ils se voient le plus</translation>
    </message>
</context>
<context>
    <name>observability</name>
    <message>
        <source>The weakest direction is {weakest}, known to {worse:n} deg; the strongest is {strongest}, known to {better:n} deg (1 sigma).</source>
        <translation>La direction la moins bien déterminée est celle du {weakest}, connue à {worse}° ; la mieux déterminée est celle du {strongest}, connue à {better}° (1 sigma).</translation>
    </message>
    <message>
        <source>{a} together with {b}</source>
        <translation>{a} combiné au {b}</translation>
    </message>
    <message>
        <source>{a} together with {b} and {c}</source>
        <translation>{a} combiné au {b} et au {c}</translation>
    </message>
    <message>
        <source>Roll is seen mainly by {lines}: without {line:name} its sigma would be {then:n} instead of {now:n} deg.</source>
        <translation>Le roulis est vu surtout par {lines} : sans {line}, son écart-type serait de {then}° au lieu de {now}°.</translation>
    </message>
    <message>
        <source>Pitch is seen mainly by {lines}: without {line:name} its sigma would be {then:n} instead of {now:n} deg.</source>
        <translation>Le tangage est vu surtout par {lines} : sans {line}, son écart-type serait de {then}° au lieu de {now}°.</translation>
    </message>
    <message>
        <source>Yaw is seen mainly by {lines}: without {line:name} its sigma would be {then:n} instead of {now:n} deg.</source>
        <translation>Le lacet est vu surtout par {lines} : sans {line}, son écart-type serait de {then}° au lieu de {now}°.</translation>
    </message>
    <message>
        <source>Roll does not depend on any single line.</source>
        <translation>Le roulis ne dépend d&apos;aucune ligne en particulier.</translation>
    </message>
    <message>
        <source>Pitch does not depend on any single line.</source>
        <translation>Le tangage ne dépend d&apos;aucune ligne en particulier.</translation>
    </message>
    <message>
        <source>Yaw does not depend on any single line.</source>
        <translation>Le lacet ne dépend d&apos;aucune ligne en particulier.</translation>
    </message>
    <message>
        <source>{target} is the only target: no other shows whether it is bent or moved. Add one of another inclination.</source>
        <translation>{target} est la seule cible : aucune autre ne montre si elle est déformée ou a bougé. Ajoutez-en une d&apos;une autre inclinaison.</translation>
    </message>
    <message>
        <source>{target} is the only target: no other shows whether it is out of shape or moved. Add another.</source>
        <translation>{target} est la seule cible : aucune autre ne montre si elle est déformée ou a bougé. Ajoutez-en une autre.</translation>
    </message>
    <message>
        <source>All targets face the same way: only the headings of the lines tell the angles apart. Add a target of another inclination.</source>
        <translation>Toutes les cibles font face au même côté : seuls les caps des lignes permettent de distinguer les angles. Ajoutez une cible d&apos;une autre inclinaison.</translation>
    </message>
    <message>
        <source>These lines and targets do not see {what}: {why}; its stated sigma goes into those of the angles.</source>
        <translation>Ces lignes et ces cibles ne voient pas {what} : {why} ; son écart-type déclaré entre dans ceux des angles.</translation>
    </message>
    <message>
        <source>These lines and targets do not see {what}: {why}; it is held.</source>
        <translation>Ces lignes et ces cibles ne voient pas {what} : {why} ; la valeur est fixée.</translation>
    </message>
    <message>
        <source>it turns the points about the scanner&apos;s axis, as the boresight does</source>
        <translation>son effet tourne les points autour de l&apos;axe du scanneur, comme le font les angles de visée</translation>
    </message>
    <message>
        <source>on level passes it lifts the points of every line alike</source>
        <translation>sur des passages de niveau, son effet soulève de la même façon les points de toutes les lignes</translation>
    </message>
    <message>
        <source>what it does to the points cannot be told from {other} or the place of the targets</source>
        <translation>son effet sur les points ne se distingue pas de celui d&apos;une autre grandeur ({other}) ou de la position des cibles</translation>
    </message>
    <message>
        <source>Thesis mode estimates the boresight alone: {what} would come out wrong, with a sigma far too small. It is held; choose the correlated model for it.</source>
        <translation>Le mode de la thèse n&apos;estime que les angles de visée : {what} aurait une valeur fausse, avec un écart-type bien trop petit. La valeur est fixée ; choisissez le modèle corrélé pour l&apos;estimer.</translation>
    </message>
    <message>
        <source>All sightings are on line {line}: a surface seen once fits any boresight. Add lines in other directions over the same targets.</source>
        <translation>Toutes les observations sont sur la ligne {line} : une surface vue une seule fois convient à n&apos;importe quels angles de visée. Ajoutez des lignes dans d&apos;autres directions devant les mêmes cibles.</translation>
    </message>
    <message>
        <source>These lines and targets do not determine the boresight, mainly not {what}. Add {target}, or lines in other directions: a vertical target shows roll on lines along it, pitch and yaw on lines at 45 deg to it.</source>
        <translation>Ces lignes et ces cibles ne déterminent pas les angles de visée, surtout pas le {what}. Ajoutez {target} ou des lignes dans d&apos;autres directions : une cible verticale montre le roulis sur les lignes qui la longent, le tangage et le lacet sur les lignes à 45° de celle-ci.</translation>
    </message>
    <message>
        <source>These lines and targets do not determine the boresight, mainly not {what}: {why:list}. Add {target}, or lines in other directions: a vertical target shows roll on lines along it, pitch and yaw on lines at 45 deg to it.</source>
        <translation>Ces lignes et ces cibles ne déterminent pas les angles de visée, surtout pas le {what} : {why}. Ajoutez {target} ou des lignes dans d&apos;autres directions : une cible verticale montre le roulis sur les lignes qui la longent, le tangage et le lacet sur les lignes à 45° de celle-ci.</translation>
    </message>
    <message>
        <source>all lines run parallel</source>
        <translation>toutes les lignes sont parallèles</translation>
    </message>
    <message>
        <source>all targets face the same way</source>
        <translation>toutes les cibles font face au même côté</translation>
    </message>
    <message>
        <source>{target:name} is the only target</source>
        <translation>{target} est la seule cible</translation>
    </message>
    <message>
        <source>another target</source>
        <translation>une autre cible</translation>
    </message>
    <message>
        <source>a target of another inclination</source>
        <translation>une cible d&apos;une autre inclinaison</translation>
    </message>
    <message>
        <source>{which}: only the headings of the lines would tell the angles apart. Add a target of another inclination, or a sphere; where there is none, tick &quot;Accept targets that all face one way&quot; under Advanced (--accept-one-facing at the command line).</source>
        <translation>{which} : seuls les caps des lignes permettraient de distinguer les angles. Ajoutez une cible d&apos;une autre inclinaison, ou une sphère ; s&apos;il n&apos;y en a pas, cochez « Accepter une orientation unique » sous « Avancé » (--accept-one-facing en ligne de commande).</translation>
    </message>
    <message>
        <source>{target:name} is the only target, a plane</source>
        <translation>{target} est la seule cible, un plan</translation>
    </message>
    <message>
        <source>All targets are planes that face the same way</source>
        <translation>Toutes les cibles sont des plans qui font face au même côté</translation>
    </message>
    <message>
        <source>No target is left on two lines.</source>
        <translation>Il ne reste aucune cible vue sur deux lignes.</translation>
    </message>
    <message>
        <source>All targets left face the same way.</source>
        <translation>Toutes les cibles restantes font face au même côté.</translation>
    </message>
    <message>
        <source>The adjustment ran away from any answer; check that each target is the same surface on every line, and the prior boresight.</source>
        <translation>La compensation diverge ; vérifiez que chaque cible est la même surface sur toutes les lignes, ainsi que les angles de visée a priori.</translation>
    </message>
    <message>
        <source>The adjustment did not settle in {n:n} iterations (last change {turn:n} deg of the angles, {move:n} m of the rest); check that each target is the same surface on every line, and the prior boresight.</source>
        <translation>La compensation ne s&apos;est pas stabilisée en {n} itérations (dernière variation : {turn}° pour les angles, {move} m pour le reste) ; vérifiez que chaque cible est la même surface sur toutes les lignes, ainsi que les angles de visée a priori.</translation>
    </message>
</context>
<context>
    <name>checks</name>
    <message>
        <source>Sightings are not tested by the model used here, that has no error in common to a sighting&apos;s points.</source>
        <translation>Le modèle employé ici ne teste pas les observations : il n&apos;a pas d&apos;erreur commune aux points d&apos;une observation.</translation>
    </message>
    <message>
        <source>Sightings are not tested by the model used here, with the surface sigma held at zero.</source>
        <translation>Le modèle employé ici ne teste pas les observations : l&apos;écart-type des surfaces est fixé à zéro.</translation>
    </message>
    <message>
        <source>Each sighting is compared with what all others say of it. Shift: how far it lies off along the surface&apos;s normal. w: the shift over its sigma; beyond {critical:n} the sighting disagrees (1 % chance that any of {count:n} does so without a fault). Detectable: the smallest shift that the test finds 4 times in 5. Effect: what a shift of that size, not found, does to the angles.</source>
        <translation>Chaque observation est comparée à ce que toutes les autres disent d&apos;elle. Écart : de combien elle est décalée le long de la normale de la surface. w : l&apos;écart rapporté à son écart-type ; au-delà de {critical}, l&apos;observation est en désaccord (1 % de chances que l&apos;une des {count} le soit sans qu&apos;il y ait de faute). Décelable : le plus petit écart que le test trouve 4 fois sur 5. Effet : ce qu&apos;un écart de cette taille, non trouvé, fait aux angles.</translation>
    </message>
    <message>
        <source>Agreement of the sightings</source>
        <translation>Concordance des observations</translation>
    </message>
    <message>
        <source>{target:name} on line {line:name} lies off what all others say; it is left out: the answer would be the same without it.</source>
        <translation>{target} sur la ligne {line} s&apos;écarte de ce que disent toutes les autres vues ; elle est écartée : sans elle, la réponse serait la même.</translation>
    </message>
    <message>
        <source>{target:name} on line {line:name} disagrees but takes part: with too few other sightings of the target, or without a loss, none is left out.</source>
        <translation>{target} sur la ligne {line} est en désaccord mais prend part au calcul : avec trop peu d&apos;autres observations de la cible, ou sans fonction de perte, aucune n&apos;est écartée.</translation>
    </message>
    <message>
        <source>No other data check {sightings:list}.</source>
        <translation>Aucune autre donnée ne contrôle {sightings}.</translation>
    </message>
    <message>
        <source>Single points are tested alike. Redundancy: how far the other data check each point, from 0 (not at all) to 1. Strays: points farther off than 3.29 of their sigmas, which one in a thousand exceeds by chance. Largest w: that of the point farthest off, by its sigma, and the time by which it is found in the line; averaged points have the mean of their times.</source>
        <translation>Les points sont testés de même, un à un. Redondance : à quel degré les autres données contrôlent chaque point, de 0 (pas du tout) à 1. Aberrants : points à plus de 3.29 fois leur écart-type, ce qu&apos;un point sur mille dépasse par hasard. Plus grand w : celui du point le plus écarté, rapporté à son écart-type, avec le temps qui permet de le retrouver dans la ligne ; les points moyennés ont la moyenne de leurs temps.</translation>
    </message>
    <message>
        <source>Tests of single points</source>
        <translation>Tests des points un à un</translation>
    </message>
    <message>
        <source>Estimated POS error in the middle of each sighting</source>
        <translation>Erreur du POS estimée au milieu de chaque observation</translation>
    </message>
    <message>
        <source>Given 1 σ</source>
        <translation>1 σ donné</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>moyenne</translation>
    </message>
    <message>
        <source>Estimated POS error of each sighting with its 2 sigma (bar); grey: the prior 2 sigma. Errors beyond the grey are red: the POS was worse than stated, or something else is taken for its error.</source>
        <translation>Erreur du POS estimée pour chaque observation, avec ses 2 sigma (barre) ; en gris : les 2 sigma a priori. Les erreurs au-delà du gris sont en rouge : le POS était moins bon que déclaré, ou autre chose est pris pour son erreur.</translation>
    </message>
    <message>
        <source>No part of the data has been adjusted by itself.</source>
        <translation>Aucune partie des données n&apos;a été compensée séparément.</translation>
    </message>
    <message>
        <source>The adjustment is repeated without each line, without each target, and with each half of the lines in the order they were sailed. The spread is the 1 sigma of the angles that the answers without one line, or one target, give by themselves (jackknife); it relies on no stated sigma.</source>
        <translation>La compensation est répétée sans chacune des lignes, sans chacune des cibles et avec chaque moitié des lignes, dans l&apos;ordre où elles ont été parcourues. La dispersion est l&apos;écart-type des angles que donnent d&apos;elles-mêmes les réponses sans une ligne, ou sans une cible (jackknife) ; elle ne repose sur aucun écart-type déclaré.</translation>
    </message>
    <message>
        <source>The spread with one line left out needs three of them, and an answer without each.</source>
        <translation>La dispersion sans une ligne demande trois lignes au moins et une réponse sans chacune.</translation>
    </message>
    <message>
        <source>The spread with one target left out needs three of them, and an answer without each.</source>
        <translation>La dispersion sans une cible demande trois cibles au moins et une réponse sans chacune.</translation>
    </message>
    <message>
        <source>The spread with one line or one target left out needs three of them, and an answer without each.</source>
        <translation>La dispersion sans une ligne ou sans une cible en demande trois au moins et une réponse sans chacune.</translation>
    </message>
    <message>
        <source>Over its sigma: the difference over the standard deviation it should have. Beyond 3 the part disagrees with the whole, or one half with the other, by more than chance explains.</source>
        <translation>« / écart-type » : la différence rapportée à l&apos;écart-type qu&apos;elle devrait avoir. Au-delà de 3, la partie est en désaccord avec l&apos;ensemble, ou une moitié avec l&apos;autre, plus que le hasard ne l&apos;explique.</translation>
    </message>
    <message>
        <source>Without an answer:</source>
        <translation>Sans réponse :</translation>
    </message>
    <message>
        <source>1 sigma of the angles, formal and by the spread of the parts</source>
        <translation>Écart-type des angles, formel et d&apos;après la dispersion des parties</translation>
    </message>
    <message>
        <source>Formal</source>
        <translation>Formel</translation>
    </message>
    <message>
        <source>Spread, one line left out</source>
        <translation>Dispersion, une ligne écartée</translation>
    </message>
    <message>
        <source>Spread, one target left out</source>
        <translation>Dispersion, une cible écartée</translation>
    </message>
    <message>
        <source>Answers of parts of the data, as differences from the whole</source>
        <translation>Réponses de parties des données, en différences par rapport à l&apos;ensemble</translation>
    </message>
    <message>
        <source>Without line {line:name}</source>
        <translation>Sans la ligne {line}</translation>
    </message>
    <message>
        <source>Without target {target:name}</source>
        <translation>Sans la cible {target}</translation>
    </message>
    <message>
        <source>First minus second half</source>
        <translation>Première moitié moins seconde</translation>
    </message>
    <message>
        <source>First half alone</source>
        <translation>Première moitié seule</translation>
    </message>
    <message>
        <source>Second half alone</source>
        <translation>Seconde moitié seule</translation>
    </message>
    <message>
        <source>without line {line:name}</source>
        <translation>sans la ligne {line}</translation>
    </message>
    <message>
        <source>without target {target:name}</source>
        <translation>sans la cible {target}</translation>
    </message>
    <message>
        <source>first minus second half</source>
        <translation>première moitié moins seconde</translation>
    </message>
    <message>
        <source>first half alone</source>
        <translation>première moitié seule</translation>
    </message>
    <message>
        <source>second half alone</source>
        <translation>seconde moitié seule</translation>
    </message>
    <message>
        <source>Without line {line:name}: {reason}</source>
        <translation>Sans la ligne {line} — {reason}</translation>
    </message>
    <message>
        <source>Without target {target:name}: {reason}</source>
        <translation>Sans la cible {target} — {reason}</translation>
    </message>
    <message>
        <source>First half alone: {reason}</source>
        <translation>Première moitié seule — {reason}</translation>
    </message>
    <message>
        <source>Second half alone: {reason}</source>
        <translation>Seconde moitié seule — {reason}</translation>
    </message>
</context>
<context>
    <name>quality</name>
    <message>
        <source>Quality of each sighting</source>
        <translation>Qualité de chaque observation</translation>
    </message>
    <message>
        <source>RMS about the sighting&apos;s own surface; incidence counts from its normal.</source>
        <translation>RMS par rapport à la surface propre de l&apos;observation ; l&apos;incidence se compte depuis sa normale.</translation>
    </message>
    <message>
        <source>Shown is its size by what the other lines show of it.</source>
        <translation>« Montré » : sa taille par rapport à ce qu&apos;en montrent les autres lignes.</translation>
    </message>
    <message>
        <source>What an error of the rough boresight can explain does not count in RMS, curvature and flatness: it bends what is seen from a moving vessel.</source>
        <translation>Ce qu&apos;une erreur des angles de visée approchés peut expliquer ne compte ni dans la RMS, ni dans la courbure, ni dans la planéité : elle déforme ce qui est vu d&apos;un navire en mouvement.</translation>
    </message>
    <message>
        <source>Its points were edited by hand.</source>
        <translation>Ses points ont été modifiés à la main.</translation>
    </message>
    <message>
        <source>Good.</source>
        <translation>Bonne.</translation>
    </message>
    <message>
        <source>Doubtful.</source>
        <translation>Douteuse.</translation>
    </message>
    <message>
        <source>Poor.</source>
        <translation>Mauvaise.</translation>
    </message>
    <message>
        <source>It has only {points:n} points.</source>
        <translation>Elle n&apos;a que {points} points.</translation>
    </message>
    <message>
        <source>It has only 1 points.</source>
        <translation>Elle n&apos;a que 1 point.</translation>
    </message>
    <message>
        <source>Its RMS of {rms:n} mm is {times:n} times the noise: it is rough or not flat.</source>
        <translation>Sa RMS de {rms} mm vaut {times} fois le bruit : la surface est rugueuse ou n&apos;est pas plane.</translation>
    </message>
    <message>
        <source>Its RMS of {rms:n} mm is {times:n} times the noise, {own:n} times without what the rough boresight explains: it is rough or not flat.</source>
        <translation>Sa RMS de {rms} mm vaut {times} fois le bruit, {own} fois sans ce qu&apos;expliquent les angles de visée approchés : la surface est rugueuse ou n&apos;est pas plane.</translation>
    </message>
    <message>
        <source>Its RMS of {rms:n} mm is {times:n} times the noise: it is rough or not flat, and more of it lies beyond the threshold of {threshold:n} mm.</source>
        <translation>Sa RMS de {rms} mm vaut {times} fois le bruit : la surface est rugueuse ou n&apos;est pas plane, et il y en a davantage au-delà du seuil de {threshold} mm.</translation>
    </message>
    <message>
        <source>Its RMS of {rms:n} mm is {times:n} times the noise, {own:n} times without what the rough boresight explains: it is rough or not flat, and more of it lies beyond the threshold of {threshold:n} mm.</source>
        <translation>Sa RMS de {rms} mm vaut {times} fois le bruit, {own} fois sans ce qu&apos;expliquent les angles de visée approchés : la surface est rugueuse ou n&apos;est pas plane, et il y en a davantage au-delà du seuil de {threshold} mm.</translation>
    </message>
    <message>
        <source>It is curved: {sagitta:n} mm over its extent.</source>
        <translation>La surface est courbe : {sagitta} mm sur son étendue.</translation>
    </message>
    <message>
        <source>It is not flat: it departs by {off:n} mm (RMS).</source>
        <translation>La surface n&apos;est pas plane : elle s&apos;en écarte de {off} mm (RMS).</translation>
    </message>
    <message>
        <source>The beams meet it at {angle:n} deg from its normal.</source>
        <translation>Les faisceaux la touchent à {angle}° de sa normale.</translation>
    </message>
    <message>
        <source>Points cover only {share:n} % of its outline.</source>
        <translation>Les points ne couvrent que {share} % de son contour.</translation>
    </message>
    <message>
        <source>Only {share:n} % of its surface is seen.</source>
        <translation>On ne voit que {share} % de sa surface.</translation>
    </message>
    <message>
        <source>It shows {share:n} % of what the other lines show: {sides:list}.</source>
        <translation>Elle montre {share} % de ce que montrent les autres lignes : {sides}.</translation>
    </message>
    <message>
        <source>{here:n} of {there:n} m wide</source>
        <translation>{here} sur {there} m de large</translation>
    </message>
    <message>
        <source>{here:n} of {there:n} m high</source>
        <translation>{here} sur {there} m de haut</translation>
    </message>
    <message>
        <source>It shows more than any other line: {sides:list}.</source>
        <translation>Elle montre plus que toute autre ligne : {sides}.</translation>
    </message>
    <message>
        <source>{n:n} m wide</source>
        <translation>{n} m de large</translation>
    </message>
    <message>
        <source>{n:n} m high</source>
        <translation>{n} m de haut</translation>
    </message>
    <message>
        <source>{n:n} m there</source>
        <translation>{n} m sur les autres</translation>
    </message>
    <message>
        <source>It is {is:n} m wide, {off:n} m more than the {should:n} m expected.</source>
        <translation>Elle fait {is} m de large, soit {off} m de plus que les {should} m attendus.</translation>
    </message>
    <message>
        <source>It is {is:n} m wide, {off:n} m less than the {should:n} m expected.</source>
        <translation>Elle fait {is} m de large, soit {off} m de moins que les {should} m attendus.</translation>
    </message>
    <message>
        <source>It is {is:n} m high, {off:n} m more than the {should:n} m expected.</source>
        <translation>Elle fait {is} m de haut, soit {off} m de plus que les {should} m attendus.</translation>
    </message>
    <message>
        <source>It is {is:n} m high, {off:n} m less than the {should:n} m expected.</source>
        <translation>Elle fait {is} m de haut, soit {off} m de moins que les {should} m attendus.</translation>
    </message>
    <message>
        <source>It is inclined by {is:n} deg, {off:n} deg more than the {should:n} deg expected.</source>
        <translation>Elle est inclinée de {is}°, soit {off}° de plus que les {should}° attendus.</translation>
    </message>
    <message>
        <source>It is inclined by {is:n} deg, {off:n} deg less than the {should:n} deg expected.</source>
        <translation>Elle est inclinée de {is}°, soit {off}° de moins que les {should}° attendus.</translation>
    </message>
</context>
<context>
    <name>settings</name>
    <message>
        <source>System and points</source>
        <translation>Système et points</translation>
    </message>
    <message>
        <source>Stochastic model</source>
        <translation>Modèle stochastique</translation>
    </message>
    <message>
        <source>Input assumptions:</source>
        <translation>Hypothèses de lecture :</translation>
    </message>
    <message>
        <source>Lever arm, forward, left, up</source>
        <translation>Bras de levier, avant, gauche, haut</translation>
    </message>
    <message>
        <source>Prior lever arm, forward, left, up</source>
        <translation>Bras de levier a priori, avant, gauche, haut</translation>
    </message>
    <message>
        <source>{x:n}, {y:n}, {z:n} m</source>
        <translation>{x}, {y}, {z} m</translation>
    </message>
    <message>
        <source>{x:n}, {y:n}, {z:n} deg</source>
        <translation>{x}, {y}, {z}°</translation>
    </message>
    <message>
        <source>Origin of the local frame</source>
        <translation>Origine du repère local</translation>
    </message>
    <message>
        <source>mean of the trajectory</source>
        <translation>moyenne de la trajectoire</translation>
    </message>
    <message>
        <source>latitude {latitude:n} deg, longitude {longitude:n} deg, {height:n} m</source>
        <translation>latitude {latitude}°, longitude {longitude}°, {height} m</translation>
    </message>
    <message>
        <source>Lever arm X, as stated</source>
        <translation>Bras de levier X, tel que déclaré</translation>
    </message>
    <message>
        <source>Range offset, as stated</source>
        <translation>Décalage de distance déclaré</translation>
    </message>
    <message>
        <source>Scan-angle offset, as stated</source>
        <translation>Décalage d&apos;angle de balayage déclaré</translation>
    </message>
    <message>
        <source>Latency, as stated</source>
        <translation>Latence déclarée</translation>
    </message>
    <message>
        <source>Asked to be estimated</source>
        <translation>À estimer, à la demande</translation>
    </message>
    <message>
        <source>the boresight; {parameters:list}</source>
        <translation>les angles de visée ; {parameters}</translation>
    </message>
    <message>
        <source>Targets that all face one way</source>
        <translation>Cibles faisant toutes face au même côté</translation>
    </message>
    <message>
        <source>Subsampling</source>
        <translation>Sous-échantillonnage</translation>
    </message>
    <message>
        <source>none: all points take part</source>
        <translation>aucun : tous les points prennent part au calcul</translation>
    </message>
    <message>
        <source>averaged: neighbours on a plane within a square of {side:n} m make one point; points of spheres stay as they are</source>
        <translation>par moyenne : les voisins sur un plan, dans un carré de {side} m, font un seul point ; les points des sphères restent tels quels</translation>
    </message>
    <message>
        <source>selected: of neighbours within {side:n} m one is kept</source>
        <translation>par choix : parmi les voisins à moins de {side} m, un seul est gardé</translation>
    </message>
    <message>
        <source>POS errors</source>
        <translation>Erreurs du POS</translation>
    </message>
    <message>
        <source>correlated. {words}</source>
        <translation>Corrélées. {words}</translation>
    </message>
    <message>
        <source>independent. {words}</source>
        <translation>Indépendantes. {words}</translation>
    </message>
    <message>
        <source>Position sigma, north, east, down</source>
        <translation>Écart-type de la position, nord, est, bas</translation>
    </message>
    <message>
        <source>Attitude sigma, roll, pitch, heading</source>
        <translation>Écart-type de l&apos;attitude, roulis, tangage, cap</translation>
    </message>
    <message>
        <source>from the trajectory accuracy file</source>
        <translation>du fichier de précision de la trajectoire</translation>
    </message>
    <message>
        <source>Correlation times, position, attitude</source>
        <translation>Temps de corrélation, position, attitude</translation>
    </message>
    <message>
        <source>{position:n} s, {attitude:n} s: how long a POS error lasts. Take those of the processing report where it states them; too short a time is safer than too long a one.</source>
        <translation>{position} s, {attitude} s : combien de temps dure une erreur du POS. Prenez ceux du rapport de traitement s&apos;il les donne ; un temps trop court est plus sûr qu&apos;un temps trop long.</translation>
    </message>
    <message>
        <source>LiDAR noise, 1 sigma</source>
        <translation>Bruit du LiDAR, 1 sigma</translation>
    </message>
    <message>
        <source>LiDAR noise found</source>
        <translation>Bruit du LiDAR trouvé</translation>
    </message>
    <message>
        <source>Surface sigma</source>
        <translation>Écart-type des surfaces</translation>
    </message>
    <message>
        <source>Stray points</source>
        <translation>Points aberrants</translation>
    </message>
    <message>
        <source>loss: none. {words}</source>
        <translation>Fonction de perte : aucune. {words}</translation>
    </message>
    <message>
        <source>loss: huber. {words}</source>
        <translation>Fonction de perte : Huber. {words}</translation>
    </message>
    <message>
        <source>loss: tukey. {words}</source>
        <translation>Fonction de perte : Tukey. {words}</translation>
    </message>
    <message>
        <source>All points of one sighting share the errors of position and attitude they were placed with, and sightings close in time share part of them (first-order Gauss-Markov process).</source>
        <translation>Tous les points d&apos;une observation partagent les erreurs de position et d&apos;attitude avec lesquelles ils ont été placés, et les observations proches dans le temps en partagent une part (processus de Gauss-Markov du premier ordre).</translation>
    </message>
    <message>
        <source>Every point has errors of position and attitude of its own, independent of all others.</source>
        <translation>Chaque point a ses propres erreurs de position et d&apos;attitude, indépendantes de toutes les autres.</translation>
    </message>
    <message>
        <source>All points have the same say, strays too.</source>
        <translation>Tous les points ont le même poids, les aberrants aussi.</translation>
    </message>
    <message>
        <source>Points beyond 1.3 standard deviations have less say, strays little.</source>
        <translation>Les points au-delà de 1.3 écart-type ont moins de poids, les aberrants en ont peu.</translation>
    </message>
    <message>
        <source>The farther off its surface a point lies, the less say it has; beyond 4.7 standard deviations it has none.</source>
        <translation>Plus un point est loin de sa surface, moins il a de poids ; au-delà de 4.7 écarts-types, il n&apos;en a aucun.</translation>
    </message>
    <message>
        <source>range {range:n} mm, direction of the beam {angle:n} deg</source>
        <translation>distance {range} mm, direction du faisceau {angle}°</translation>
    </message>
    <message>
        <source>x {x:n} mm, y {y:n} mm, z {z:n} mm</source>
        <translation>x {x} mm, y {y} mm, z {z} mm</translation>
    </message>
    <message>
        <source>{sigma:n} mm on each axis</source>
        <translation>{sigma} mm sur chaque axe</translation>
    </message>
    <message>
        <source>not above the stated LiDAR noise on any target</source>
        <translation>ne dépasse sur aucune cible le bruit déclaré du LiDAR</translation>
    </message>
    <message>
        <source>not above the sigma found by the variance components on any target</source>
        <translation>ne dépasse sur aucune cible l&apos;écart-type trouvé par les composantes de variance</translation>
    </message>
    <message>
        <source>in the residuals {found:list} the stated LiDAR noise; the sigmas of the angles are computed with it</source>
        <translation>dans les résidus, {found} le bruit déclaré du LiDAR ; les écarts-types des angles en tiennent compte</translation>
    </message>
    <message>
        <source>in the residuals {found:list} the sigma found by the variance components; the sigmas of the angles are computed with it</source>
        <translation>dans les résidus, {found} l&apos;écart-type trouvé par les composantes de variance ; les écarts-types des angles en tiennent compte</translation>
    </message>
    <message>
        <source>{n:n} times ({target})</source>
        <translation>{n} fois ({target})</translation>
    </message>
    <message>
        <source>to be found from the data: how far a sighting as a whole may lie off the shape that all lines have in common</source>
        <translation>à trouver d&apos;après les données : de combien une observation, dans son ensemble, peut s&apos;écarter de la forme commune à toutes les lignes</translation>
    </message>
    <message>
        <source>none: each sighting is held to the shape that all lines have in common</source>
        <translation>aucun : chaque observation est tenue à la forme commune à toutes les lignes</translation>
    </message>
    <message>
        <source>{sigmas}, found from the data: how far a sighting as a whole may lie off the shape that all lines have in common</source>
        <translation>{sigmas}, d&apos;après les données : de combien une observation, dans son ensemble, peut s&apos;écarter de la forme commune à toutes les lignes</translation>
    </message>
    <message>
        <source>{sigmas}, as typed: how far a sighting as a whole may lie off the shape that all lines have in common</source>
        <translation>{sigmas}, valeur saisie : de combien une observation, dans son ensemble, peut s&apos;écarter de la forme commune à toutes les lignes</translation>
    </message>
    <message>
        <source>offsets {offset} mm, tilts {tilt} mm</source>
        <translation>décalages {offset} mm, inclinaisons {tilt} mm</translation>
    </message>
    <message>
        <source>Variance components: the sigmas by the data, over the stated ones</source>
        <translation>Composantes de variance : les écarts-types d&apos;après les données, rapportés aux déclarés</translation>
    </message>
    <message>
        <source>From the residuals and the estimated POS errors by restricted likelihood. A sigma is raised where the data say more, and lowered only where the whole interval says less; what is not applied is used as stated. With few sightings the data say little of the POS: a wide interval means that the stated sigma may be as good as the one found.</source>
        <translation>D&apos;après les résidus et les erreurs du POS estimées, par vraisemblance restreinte. Un écart-type est augmenté là où les données en demandent plus, et diminué seulement si tout l&apos;intervalle en demande moins ; ce qui n&apos;est pas appliqué reste tel que déclaré. Avec peu d&apos;observations, les données disent peu de chose du POS : un intervalle large signifie que l&apos;écart-type déclaré peut être aussi bon que celui trouvé.</translation>
    </message>
    <message>
        <source>{lower:n} to {upper:n}</source>
        <translation>{lower} à {upper}</translation>
    </message>
    <message>
        <source>LiDAR</source>
        <translation>LiDAR</translation>
    </message>
    <message>
        <source>POS position</source>
        <translation>position du POS</translation>
    </message>
    <message>
        <source>POS attitude</source>
        <translation>attitude du POS</translation>
    </message>
    <message>
        <source>applied: larger than stated</source>
        <translation>appliqué : plus grand que déclaré</translation>
    </message>
    <message>
        <source>applied: smaller than stated</source>
        <translation>appliqué : plus petit que déclaré</translation>
    </message>
    <message>
        <source>not applied: the data do not tell</source>
        <translation>non appliqué : les données ne le disent pas</translation>
    </message>
    <message>
        <source>not applied: as stated, within the interval</source>
        <translation>non appliqué : comme déclaré, aux limites de l&apos;intervalle près</translation>
    </message>
    <message>
        <source>not applied: too little, or seen too weakly, to change what is stated</source>
        <translation>non appliqué : trop faible, ou trop mal vu, pour changer la valeur déclarée</translation>
    </message>
    <message>
        <source>Input files</source>
        <translation>Fichiers d&apos;entrée</translation>
    </message>
    <message>
        <source>Trajectory</source>
        <translation>Trajectoire</translation>
    </message>
    <message>
        <source>Trajectory accuracy</source>
        <translation>Précision de la trajectoire</translation>
    </message>
    <message>
        <source>Line {line:name}</source>
        <translation>Ligne {line}</translation>
    </message>
    <message>
        <source>not readable</source>
        <translation>illisible</translation>
    </message>
</context>
<context>
    <name>validation</name>
    <message>
        <source>No plane outside the adjustment has been compared between the lines.</source>
        <translation>Aucun plan étranger à la compensation n&apos;a été comparé entre les lignes.</translation>
    </message>
    <message>
        <source>Distances from each point of one line to the surface of the other ({models:list}), both directions, only where both lines saw the plane, before and after the calibration. The histograms and the totals are of {sources:list}; the same points stand in both states. What remains after the calibration is the POS error of each line, which no boresight removes.</source>
        <translation>Distances de chaque point d&apos;une ligne à la surface de l&apos;autre ({models}), dans les deux sens, seulement là où les deux lignes ont vu le plan, avant et après l&apos;étalonnage. Les histogrammes et les totaux portent sur {sources} ; les deux états ont les mêmes points. Ce qui reste après l&apos;étalonnage est l&apos;erreur du POS de chaque ligne, qu&apos;aucun angle de visée n&apos;enlève.</translation>
    </message>
    <message>
        <source>reciprocal pairs</source>
        <translation>les paires réciproques</translation>
    </message>
    <message>
        <source>all pairs</source>
        <translation>toutes les paires</translation>
    </message>
    <message>
        <source>reciprocal pairs, {model}</source>
        <translation>paires réciproques, {model}</translation>
    </message>
    <message>
        <source>all pairs, {model}</source>
        <translation>toutes les paires, {model}</translation>
    </message>
    <message>
        <source>nearest point</source>
        <translation>point le plus proche</translation>
    </message>
    <message>
        <source>local plane through {n:n} points</source>
        <translation>plan local par {n} points</translation>
    </message>
    <message>
        <source>local quadric through {n:n} points</source>
        <translation>quadrique locale par {n} points</translation>
    </message>
    <message>
        <source>local plane through the points within {radius:n} m</source>
        <translation>plan local par les points à moins de {radius} m</translation>
    </message>
    <message>
        <source>local quadric through the points within {radius:n} m</source>
        <translation>quadrique locale par les points à moins de {radius} m</translation>
    </message>
    <message>
        <source>Distances between lines on each plane (mm)</source>
        <translation>Distances entre lignes sur chaque plan (mm)</translation>
    </message>
    <message>
        <source>Robust sigma: 1.4826 times the median absolute deviation from the median. Outliers: distances more than three of these above the median; they stay in all other figures.</source>
        <translation>Écart-type robuste : 1.4826 fois la médiane des écarts absolus à la médiane. Aberrants : distances supérieures à la médiane de plus de trois fois celui-ci ; elles restent dans tous les autres chiffres.</translation>
    </message>
    <message>
        <source>{plane}: distances between lines before and after the calibration.</source>
        <translation>{plane} : distances entre lignes, avant et après l&apos;étalonnage.</translation>
    </message>
    <message>
        <source>{plane}: median and 95th percentile of the distances against {words:list}.</source>
        <translation>{plane} : médiane et 95e centile des distances selon {words}.</translation>
    </message>
    <message>
        <source>Every pair of lines (mm)</source>
        <translation>Toutes les paires de lignes (mm)</translation>
    </message>
    <message>
        <source>Signed distances along the normal, reciprocal pairs (mm)</source>
        <translation>Distances signées le long de la normale, paires réciproques (mm)</translation>
    </message>
    <message>
        <source>How far the first line lies off the second, positive towards the vessel: means within cylinders along the local normal (M3C2), so that the noise of single points averages out. The interval is that of one place by the scatter of its points; the last columns tell at how many places the lines differ from each other beyond it.</source>
        <translation>De combien la première ligne s&apos;écarte de la seconde, positif vers le navire : moyennes dans des cylindres le long de la normale locale (M3C2), où le bruit des points se compense. L&apos;intervalle est celui d&apos;un endroit, d&apos;après la dispersion de ses points ; les dernières colonnes disent à combien d&apos;endroits les lignes diffèrent entre elles de plus que cela.</translation>
    </message>
    <message>
        <source>Planes of the two lines against each other, reciprocal pairs</source>
        <translation>Plans des deux lignes l&apos;un par rapport à l&apos;autre, paires réciproques</translation>
    </message>
    <message>
        <source>The plane through the first line&apos;s points against that through the second&apos;s, with 95 % intervals by the scatter of the points. Offsets are positive where the first line is nearer to the vessel; turns where its upper edge (level axis), or its right edge as seen from the vessel (upright axis), comes nearer.</source>
        <translation>Le plan par les points de la première ligne, par rapport au plan par ceux de la seconde, avec des intervalles à 95 % d&apos;après la dispersion des points. Les écarts sont positifs là où la première ligne est plus près du navire ; les rotations, là où son bord supérieur (axe horizontal) ou son bord droit vu du navire (axe montant) s&apos;en rapproche.</translation>
    </message>
    <message>
        <source>Not compared, for want of a part seen by both lines:</source>
        <translation>Non comparées, faute d&apos;une partie vue par les deux lignes :</translation>
    </message>
    <message>
        <source>The validation plane {plane} is seen on one line only ({line}), with at least {n:n} points; a comparison needs two lines. Pick it in another line or choose another plane.</source>
        <translation>Le plan de validation {plane} n&apos;est vu que sur une ligne ({line}) avec au moins {n} points ; une comparaison demande deux lignes. Désignez-le sur une autre ligne ou choisissez un autre plan.</translation>
    </message>
    <message>
        <source>The validation plane {plane} is seen on no line, with at least {n:n} points; a comparison needs two lines. Pick it in another line or choose another plane.</source>
        <translation>Le plan de validation {plane} n&apos;est vu sur aucune ligne avec au moins {n} points ; une comparaison demande deux lignes. Désignez-le sur une autre ligne ou choisissez un autre plan.</translation>
    </message>
    <message>
        <source>No two lines overlap on the validation plane {plane}, before and after, in at least {n:n} points; choose a larger plane or pick it again.</source>
        <translation>Sur le plan de validation {plane}, il n&apos;y a pas deux lignes qui se recouvrent, avant et après, en au moins {n} points ; choisissez un plan plus grand ou désignez-le de nouveau.</translation>
    </message>
</context>
<context>
    <name>figures</name>
    <message>
        <source>Correlation</source>
        <translation>Corrélation</translation>
    </message>
    <message>
        <source>West (m)</source>
        <translation>Ouest (m)</translation>
    </message>
    <message>
        <source>North (m)</source>
        <translation>Nord (m)</translation>
    </message>
    <message>
        <source>RMS distance to the target&apos;s surface (mm)</source>
        <translation>Distance RMS à la surface de la cible (mm)</translation>
    </message>
    <message>
        <source>Distance between lines (mm); the last bin holds all beyond</source>
        <translation>Distance entre lignes (mm) ; la dernière classe contient le reste</translation>
    </message>
    <message>
        <source>{state}: n {n:n}
median {median:n}, RMS {rms:n}, 95 % {p95:n} mm</source>
        <translation>{state} : n {n}
médiane {median}, RMS {rms}, 95 % {p95} mm</translation>
    </message>
    <message>
        <source>Enlarged (mm)</source>
        <translation>Agrandi (mm)</translation>
    </message>
    <message>
        <source>Share of the points
(% per mm)</source>
        <translation>Part des points
(% par mm)</translation>
    </message>
    <message>
        <source>Height (m)</source>
        <translation>Hauteur (m)</translation>
    </message>
    <message>
        <source>Range (m)</source>
        <translation>Distance au scanneur (m)</translation>
    </message>
    <message>
        <source>Distance (mm)</source>
        <translation>Distance (mm)</translation>
    </message>
    <message>
        <source>Made by an earlier version: validate again</source>
        <translation>Fait par une version antérieure : validez de nouveau</translation>
    </message>
    <message>
        <source>median before</source>
        <translation>médiane avant</translation>
    </message>
    <message>
        <source>median after</source>
        <translation>médiane après</translation>
    </message>
    <message>
        <source>95 % before</source>
        <translation>95 % avant</translation>
    </message>
    <message>
        <source>95 % after</source>
        <translation>95 % après</translation>
    </message>
</context>
<context>
    <name>cautions</name>
    <message>
        <source>Not calibrated: no boresight has been estimated. The angles in this report are the prior ones, with nothing known about their uncertainty.</source>
        <translation>Non étalonné : les angles de visée n&apos;ont pas été estimés. Ceux de ce rapport sont les angles a priori, dont l&apos;incertitude est inconnue.</translation>
    </message>
    <message>
        <source>The true value lies outside the 95 % interval of {angles:list}.</source>
        <translation>La valeur vraie est hors de l&apos;intervalle à 95 % pour : {angles}.</translation>
    </message>
    <message>
        <source>{reason} Do not estimate it.</source>
        <translation>{reason} Ne l&apos;estimez pas.</translation>
    </message>
    <message>
        <source>{parameter} does not earn its place: its change of {change} is within what chance explains. Hold it at the stated value.</source>
        <translation>{parameter} : son estimation n&apos;est pas justifiée, car sa variation de {change} reste dans ce que le hasard explique. Gardez la valeur déclarée.</translation>
    </message>
    <message>
        <source>The chi-square test failed: the residuals are larger than the stated sigmas allow, and the sigmas of the angles are too small.</source>
        <translation>Le test du khi-deux a échoué : les résidus sont plus grands que ne l&apos;admettent les écarts-types déclarés, et les écarts-types des angles sont trop petits.</translation>
    </message>
    <message>
        <source>The sigmas of the angles are computed with the noise found.</source>
        <translation>Les écarts-types des angles sont calculés avec le bruit trouvé.</translation>
    </message>
    <message>
        <source>Correct the stated ones, or look for stray points.</source>
        <translation>Corrigez les écarts-types déclarés, ou cherchez des points aberrants.</translation>
    </message>
    <message>
        <source>The chi-square test failed: the residuals are smaller than the stated sigmas let one expect. Where nothing else is in doubt, the sigmas of the angles are on the large side.</source>
        <translation>Le test du khi-deux a échoué : les résidus sont plus petits que ne le laissent attendre les écarts-types déclarés. Si rien d&apos;autre n&apos;est en doute, les écarts-types des angles sont plutôt trop grands.</translation>
    </message>
    <message>
        <source>Target {name} is left out.</source>
        <translation>La cible {name} est écartée.</translation>
    </message>
    <message>
        <source>Validation plane {name} is left out.</source>
        <translation>Le plan de validation {name} est écarté.</translation>
    </message>
    <message>
        <source>Target {name} is left out on {lines:list}.</source>
        <translation>La cible {name} est écartée sur {lines}.</translation>
    </message>
    <message>
        <source>Validation plane {name} is left out on {lines:list}.</source>
        <translation>Le plan de validation {name} est écarté sur {lines}.</translation>
    </message>
    <message>
        <source>Target {name} is used on one line only ({line}) of {total:n}: it says nothing about the boresight.</source>
        <translation>La cible {name} n&apos;est utilisée que sur une ligne ({line}) sur {total} : elle ne dit rien des angles de visée.</translation>
    </message>
    <message>
        <source>Target {name} is used on no line of {total:n}: it says nothing about the boresight.</source>
        <translation>La cible {name} n&apos;est utilisée sur aucune ligne (sur {total}) : elle ne dit rien des angles de visée.</translation>
    </message>
    <message>
        <source>Validation plane {name} is used on one line only ({line}) of {total:n}: it cannot be compared.</source>
        <translation>Le plan de validation {name} n&apos;est utilisé que sur une ligne ({line}) sur {total} : il ne peut être comparé.</translation>
    </message>
    <message>
        <source>Validation plane {name} is used on no line of {total:n}: it cannot be compared.</source>
        <translation>Le plan de validation {name} n&apos;est utilisé sur aucune ligne (sur {total}) : il ne peut être comparé.</translation>
    </message>
    <message>
        <source>Target {name} is used on {seen:n} of {total:n} lines only ({lines:list}).</source>
        <translation>La cible {name} n&apos;est utilisée que sur {seen} lignes sur {total} ({lines}).</translation>
    </message>
    <message>
        <source>Validation plane {name} is used on {seen:n} of {total:n} lines only ({lines:list}).</source>
        <translation>Le plan de validation {name} n&apos;est utilisé que sur {seen} lignes sur {total} ({lines}).</translation>
    </message>
    <message>
        <source>Target {name} was not found on {lines:list}; the reasons stand in the section on targets.</source>
        <translation>La cible {name} n&apos;a pas été trouvée sur {lines} ; les raisons sont dans la section sur les cibles.</translation>
    </message>
    <message>
        <source>Validation plane {name} was not found on {lines:list}; the reasons stand in the section on targets.</source>
        <translation>Le plan de validation {name} n&apos;a pas été trouvé sur {lines} ; les raisons sont dans la section sur les cibles.</translation>
    </message>
    <message>
        <source>Validation planes {names:list} were not found on {lines:list}; the reasons stand in the section on targets.</source>
        <translation>Les plans de validation {names} n&apos;ont pas été trouvés sur {lines} ; les raisons sont dans la section sur les cibles.</translation>
    </message>
    <message>
        <source>Not validated: no plane outside the adjustment has been compared between the lines.</source>
        <translation>Non validé : aucun plan étranger à la compensation n&apos;a été comparé entre les lignes.</translation>
    </message>
    <message>
        <source>Of {used:n} sightings used, poor: {poor:n}, doubtful: {doubtful:n}. The worst, {target:name} on {line:name}: {reasons} See the section on the quality of the sightings.</source>
        <translation>Sur {used} observations utilisées, mauvaises : {poor}, douteuses : {doubtful}. La pire, {target} sur {line} : {reasons} Voir la section sur la qualité des observations.</translation>
    </message>
    <message>
        <source>On validation plane {plane} the lines lie farther apart after the calibration (RMS {after:n} mm) than before ({before:n} mm).</source>
        <translation>Sur le plan de validation {plane}, les lignes sont plus éloignées après l&apos;étalonnage (RMS {after} mm) qu&apos;avant ({before} mm).</translation>
    </message>
</context>
<context>
    <name>doubts</name>
    <message>
        <source>Thesis mode: every point is taken to have a POS error of its own, while in truth neighbouring points share theirs. The sigmas of the angles are several times too small; choose the correlated model for sigmas to rely on.</source>
        <translation>Mode de la thèse : chaque point est censé avoir sa propre erreur du POS, alors qu&apos;en vérité les points voisins partagent la leur. Les écarts-types des angles sont plusieurs fois trop petits ; choisissez le modèle corrélé pour des écarts-types fiables.</translation>
    </message>
    <message>
        <source>{n:n} m larger</source>
        <translation>plus grande de {n} m</translation>
    </message>
    <message>
        <source>{n:n} m smaller</source>
        <translation>plus petite de {n} m</translation>
    </message>
    <message>
        <source>{n:n} deg larger</source>
        <translation>plus grande de {n}°</translation>
    </message>
    <message>
        <source>{n:n} deg smaller</source>
        <translation>plus petite de {n}°</translation>
    </message>
    <message>
        <source>{n:n} ms larger</source>
        <translation>plus grande de {n} ms</translation>
    </message>
    <message>
        <source>{n:n} ms smaller</source>
        <translation>plus petite de {n} ms</translation>
    </message>
    <message>
        <source>{angle} by {n:n} deg ({sigmas:n} of its sigmas)</source>
        <translation>le {angle} de {n}° ({sigmas} fois son écart-type)</translation>
    </message>
    <message>
        <source>From line to line the targets seem to lie {off:n} mm (1 sigma) off their common shape, beyond what the stated sigmas explain; the chi-square test allows for it.</source>
        <translation>D&apos;une ligne à l&apos;autre, les cibles semblent s&apos;écarter de {off} mm (1 sigma) de leur forme commune, plus que ne l&apos;expliquent les écarts-types déclarés ; le test du khi-deux en tient compte.</translation>
    </message>
    <message>
        <source>From line to line the targets seem to lie {off:n} mm (1 sigma) off their common shape, displaced rather than bent or turned ({sigmas}), beyond what the stated sigmas explain; the chi-square test allows for it.</source>
        <translation>D&apos;une ligne à l&apos;autre, les cibles semblent s&apos;écarter de {off} mm (1 sigma) de leur forme commune, déplacées plutôt que déformées ou tournées ({sigmas}), plus que ne l&apos;expliquent les écarts-types déclarés ; le test du khi-deux en tient compte.</translation>
    </message>
    <message>
        <source>{angle} to {n:n} deg</source>
        <translation>{angle} à {n}°</translation>
    </message>
    <message>
        <source>What these lines and targets do not see goes into it: {parameters:list}. Know it better, or hold it.</source>
        <translation>Ce que ces lignes et ces cibles ne voient pas y contribue : {parameters}. Il faut mieux connaître ces valeurs, ou les fixer.</translation>
    </message>
    <message>
        <source>Add targets of other inclinations, or lines in other directions.</source>
        <translation>Ajoutez des cibles d&apos;autres inclinaisons ou des lignes dans d&apos;autres directions.</translation>
    </message>
    <message>
        <source>Add a target of another inclination.</source>
        <translation>Ajoutez une cible d&apos;une autre inclinaison.</translation>
    </message>
    <message>
        <source>{target} is the only target: the headings of the lines alone tell the angles apart, and nothing shows whether it is bent or moved.</source>
        <translation>{target} est la seule cible : seuls les caps des lignes permettent de distinguer les angles, et rien ne montre si elle est déformée ou a bougé.</translation>
    </message>
    <message>
        <source>All targets face the same way: the headings of the lines alone tell the angles apart.</source>
        <translation>Toutes les cibles font face au même côté : seuls les caps des lignes permettent de distinguer les angles.</translation>
    </message>
    <message>
        <source>a target of another inclination or lines in other directions would help</source>
        <translation>une cible d&apos;une autre inclinaison ou des lignes dans d&apos;autres directions aideraient</translation>
    </message>
    <message>
        <source>state how well the prior value is known, or hold it</source>
        <translation>déclarez avec quelle précision la valeur a priori est connue, ou fixez-la</translation>
    </message>
    <message>
        <source>The surface sigma is held at 0, so no sighting is tested against the others; take it from the data to have them tested.</source>
        <translation>L&apos;écart-type des surfaces est fixé à 0 : aucune observation n&apos;est testée par rapport aux autres ; tirez-le des données pour qu&apos;elles le soient.</translation>
    </message>
    <message>
        <source>Left out of the answer, because the other sightings contradict it: {sightings:list}. Look at the points and the trajectory there.</source>
        <translation>Écartée de la réponse, parce que les autres observations la contredisent : {sightings}. Examinez-y les points et la trajectoire.</translation>
    </message>
    <message>
        <source>Left out of the answer, because the other sightings contradict them: {sightings:list}. Look at the points and the trajectory there.</source>
        <translation>Écartées de la réponse, parce que les autres observations les contredisent : {sightings}. Examinez-y les points et la trajectoire.</translation>
    </message>
    <message>
        <source>Line {line} fits another boresight than the other lines (roll {roll:n} deg, pitch {pitch:n} deg and yaw {yaw:n} deg): it may be of a second scanner, or the mounting moved. Calibrate it apart from the others, or exclude it.</source>
        <translation>La ligne {line} demande d&apos;autres angles de visée que les autres lignes (roulis {roll}°, tangage {pitch}° et lacet {yaw}°) : elle peut provenir d&apos;un second scanner, ou le montage a bougé. Calibrez-la séparément ou excluez-la.</translation>
    </message>
    <message>
        <source>The point times of line {line} are {n:n} ms late. Check the time base and the time shift of the line, or exclude it.</source>
        <translation>Les temps des points de la ligne {line} sont en retard de {n} ms. Vérifiez la base de temps et le décalage de la ligne, ou excluez-la.</translation>
    </message>
    <message>
        <source>The point times of line {line} are {n:n} ms early. Check the time base and the time shift of the line, or exclude it.</source>
        <translation>Les temps des points de la ligne {line} sont en avance de {n} ms. Vérifiez la base de temps et le décalage de la ligne, ou excluez-la.</translation>
    </message>
    <message>
        <source>The position on line {line} is off by {n:n} mm. Look at the trajectory there, or exclude the line.</source>
        <translation>La position sur la ligne {line} est décalée de {n} mm. Examinez-y la trajectoire ou excluez la ligne.</translation>
    </message>
    <message>
        <source>The residuals contradict the model, and the likeliest cause is {cause}. Look at the points and the trajectory there.</source>
        <translation>Les résidus contredisent le modèle, et la cause la plus probable est la suivante : {cause}. Examinez-y les points et la trajectoire.</translation>
    </message>
    <message>
        <source>The residuals contradict the model. These causes explain them about equally well, the first one best: {causes:list}. Check each of them.</source>
        <translation>Les résidus contredisent le modèle. Ces causes les expliquent à peu près aussi bien, la première le mieux : {causes}. Vérifiez chacune d&apos;elles.</translation>
    </message>
    <message>
        <source>The residuals contradict the model, which is explained by {known}: see the warning about it. Correct the data first.</source>
        <translation>Les résidus contredisent le modèle, ce qu&apos;explique la cause suivante : {known} (voir son avertissement). Corrigez d&apos;abord les données.</translation>
    </message>
    <message>
        <source>The residuals contradict the model, which is explained by {known}: see the warning about it. Without it they would be explained by: {causes:list}. Correct the data first.</source>
        <translation>Les résidus contredisent le modèle, ce qu&apos;explique la cause suivante : {known} (voir son avertissement). Sans elle, ils s&apos;expliqueraient par : {causes}. Corrigez d&apos;abord les données.</translation>
    </message>
    <message>
        <source>lever arm {axis:kept} {n:n} m larger</source>
        <translation>bras de levier {axis} plus grand de {n} m</translation>
    </message>
    <message>
        <source>lever arm {axis:kept} {n:n} m smaller</source>
        <translation>bras de levier {axis} plus petit de {n} m</translation>
    </message>
    <message>
        <source>range offset {n:n} m larger</source>
        <translation>décalage de distance plus grand de {n} m</translation>
    </message>
    <message>
        <source>range offset {n:n} m smaller</source>
        <translation>décalage de distance plus petit de {n} m</translation>
    </message>
    <message>
        <source>scan-angle offset {n:n} deg larger</source>
        <translation>décalage de l&apos;angle de balayage plus grand de {n}°</translation>
    </message>
    <message>
        <source>scan-angle offset {n:n} deg smaller</source>
        <translation>décalage de l&apos;angle de balayage plus petit de {n}°</translation>
    </message>
    <message>
        <source>latency {n:n} ms larger</source>
        <translation>latence plus grande de {n} ms</translation>
    </message>
    <message>
        <source>latency {n:n} ms smaller</source>
        <translation>latence plus petite de {n} ms</translation>
    </message>
    <message>
        <source>another boresight of line {line}</source>
        <translation>autres angles de visée de la ligne {line}</translation>
    </message>
    <message>
        <source>point times of line {line:name} {n:n} ms early</source>
        <translation>temps des points de la ligne {line} en avance de {n} ms</translation>
    </message>
    <message>
        <source>point times of line {line:name} {n:n} ms late</source>
        <translation>temps des points de la ligne {line} en retard de {n} ms</translation>
    </message>
    <message>
        <source>position on line {line} off by {n:n} mm</source>
        <translation>position sur la ligne {line} décalée de {n} mm</translation>
    </message>
    <message>
        <source>target {target:kept} off by {n:n} mm on line {line:kept}</source>
        <translation>cible {target} décalée de {n} mm sur la ligne {line}</translation>
    </message>
    <message>
        <source>another surface under {target} on line {line}</source>
        <translation>une autre surface à la place de {target} sur la ligne {line}</translation>
    </message>
    <message>
        <source>points of several scanners in one line</source>
        <translation>points de plusieurs scanners dans une même ligne</translation>
    </message>
    <message>
        <source>points of several sources in one line</source>
        <translation>points de plusieurs sources dans une même ligne</translation>
    </message>
    <message>
        <source>lines with points of the same time</source>
        <translation>des lignes ayant des points du même temps</translation>
    </message>
    <message>
        <source>coarse point times</source>
        <translation>temps des points trop grossiers</translation>
    </message>
    <message>
        <source>an offset of the heights</source>
        <translation>un décalage des hauteurs</translation>
    </message>
    <message>
        <source>an offset of the point times</source>
        <translation>un décalage des temps des points</translation>
    </message>
    <message>
        <source>another lever arm behind the cloud</source>
        <translation>un autre bras de levier à l&apos;origine du nuage</translation>
    </message>
    <message>
        <source>a wrong sign of the attitude</source>
        <translation>un signe d&apos;attitude faux</translation>
    </message>
    <message>
        <source>Every target is off on line {line}: the position may have jumped there, targets are mixed up, or a stated value of the mounting is wrong.</source>
        <translation>Toutes les cibles sont décalées sur la ligne {line} : la position peut y avoir sauté, des cibles peuvent être confondues, ou une valeur déclarée du montage est fausse.</translation>
    </message>
    <message>
        <source>Every target is off on lines {lines:list}: the position may have jumped there, targets are mixed up, or a stated value of the mounting is wrong.</source>
        <translation>Toutes les cibles sont décalées sur les lignes {lines} : la position peut y avoir sauté, des cibles peuvent être confondues, ou une valeur déclarée du montage est fausse.</translation>
    </message>
    <message>
        <source>{target:name} on line {line:name} (off by {off:n} mm, w {w:n})</source>
        <translation>{target} sur la ligne {line} (écart de {off} mm, w {w})</translation>
    </message>
    <message>
        <source>{strays} of {points:n}, where chance explains about {chance:n}; most on {target:name} on line {line:name} ({here:n} of {of:n}).</source>
        <translation>{strays} sur {points}, alors que le hasard en explique environ {chance} ; surtout sur {target}, ligne {line} ({here} sur {of}).</translation>
    </message>
    <message>
        <source>The points of {target} are {times:n} times the LiDAR noise off their surface and count for little: is it the same surface on every line?</source>
        <translation>Les points de {target} s&apos;écartent de leur surface de {times} fois le bruit du LiDAR et comptent peu : est-ce la même surface sur toutes les lignes ?</translation>
    </message>
    <message>
        <source>The points of {targets:list} are up to {times:n} times the LiDAR noise off their surface and count for little: are they the same surfaces on every line?</source>
        <translation>Les points de {targets} s&apos;écartent de leur surface jusqu&apos;à {times} fois le bruit du LiDAR et comptent peu : est-ce que ce sont les mêmes surfaces sur toutes les lignes ?</translation>
    </message>
    <message>
        <source>Residuals larger than the LiDAR noise, or correlated over the surface, on {targets:list}: in effect {times:n} times the given noise.</source>
        <translation>Résidus plus grands que le bruit du LiDAR, ou corrélés sur la surface, pour {targets} : soit {times} fois le bruit donné.</translation>
    </message>
    <message>
        <source>Residuals larger than the LiDAR noise, or correlated over the surface, on {targets:list}: in effect up to {times:n} times the given noise.</source>
        <translation>Résidus plus grands que le bruit du LiDAR, ou corrélés sur la surface, pour {targets} : soit jusqu&apos;à {times} fois le bruit donné.</translation>
    </message>
    <message>
        <source>The targets are probably not flat, and these lines are too few to detect what that does to the angles: they may be off by more than their sigmas.</source>
        <translation>Les cibles ne sont probablement pas planes, et ces lignes sont trop peu nombreuses pour déceler l&apos;effet sur les angles : ils peuvent être faux de plus que leurs écarts-types.</translation>
    </message>
    <message>
        <source>Add lines, or use flat targets.</source>
        <translation>Ajoutez des lignes, ou utilisez des cibles planes.</translation>
    </message>
    <message>
        <source>Parts of the data disagree by more than chance explains: {parts:list}.</source>
        <translation>Des parties des données sont en désaccord, plus que le hasard ne l&apos;explique : {parts}.</translation>
    </message>
    <message>
        <source>{part} ({angle} {difference:n} deg, {sigmas:n} of its sigmas)</source>
        <translation>{part} ({angle} {difference}°, {sigmas} fois son écart-type)</translation>
    </message>
    <message>
        <source>With the stated correlation times of the POS errors ({a:n} s for position, {b:n} s for attitude) the residuals are too large for the chi-square test. With {c:n} s and {d:n} s they pass it, and the standard deviations are computed with these.</source>
        <translation>Avec les temps de corrélation indiqués des erreurs du POS ({a} s pour la position, {b} s pour l&apos;attitude), les résidus sont trop grands pour le test du khi-deux. Avec {c} s et {d} s, ils le passent, et les écarts-types sont calculés avec ces valeurs.</translation>
    </message>
    <message>
        <source>{target:name} on line {line:name} ({angles:list})</source>
        <translation>{target} sur la ligne {line} ({angles})</translation>
    </message>
    <message>
        <source>The angles depend on one sighting, of which an error cannot be detected: {carried:list}. Add targets or lines.</source>
        <translation>Les angles dépendent d&apos;une seule observation de cible, dont une erreur ne peut pas être détectée : {carried}. Ajoutez des cibles ou des lignes.</translation>
    </message>
    <message>
        <source>All targets lie within {n:n} % of their distance from the scanner, so that an error of a line cannot be detected. Add targets at other places.</source>
        <translation>Toutes les cibles se trouvent à moins de {n} % de leur distance au scanneur, si bien qu&apos;une erreur d&apos;une ligne ne peut pas être détectée. Ajoutez des cibles à d&apos;autres endroits.</translation>
    </message>
    <message>
        <source>any of the targets {targets:list}</source>
        <translation>l&apos;une des cibles {targets}</translation>
    </message>
    <message>
        <source>target {target:name}</source>
        <translation>la cible {target}</translation>
    </message>
    <message>
        <source>any of the lines {lines:list}</source>
        <translation>l&apos;une des lignes {lines}</translation>
    </message>
    <message>
        <source>Excluded, because no point of them agrees with the other targets and lines: {named:list}. Pick them again, or remove them.</source>
        <translation>Exclues, car aucun de leurs points ne concorde avec les autres cibles et lignes : {named}. Désignez-les de nouveau, ou supprimez-les.</translation>
    </message>
    <message>
        <source>The scene does not offer targets that check each other. Use the targetless method, which adjusts many small surfaces, or put up boards.</source>
        <translation>La scène n’offre pas de cibles qui se contrôlent mutuellement. Utilisez la méthode sans cible, qui compense de nombreuses petites surfaces, ou installez des panneaux.</translation>
    </message>
    <message>
        <source>The residuals contradict the model. There are too few lines to tell the cause; possible causes: {phrases:list}. Add lines.</source>
        <translation>Les résidus contredisent le modèle. Il y a trop peu de lignes pour en déterminer la cause ; causes possibles : {phrases}. Ajoutez des lignes.</translation>
    </message>
    <message>
        <source>The residuals contradict the model, and the likeliest cause is that target {target:kept} is not one flat surface for all lines. Exclude it, or pick a smaller part of it.</source>
        <translation>Les résidus contredisent le modèle ; la cause la plus probable est que la cible {target} n’est pas une même surface plane pour toutes les lignes. Excluez-la, ou désignez-en une partie plus petite.</translation>
    </message>
    <message>
        <source>Lines show different parts of a surface that is not shown to be flat, so only the common part is used: {named:list}. Pick smaller targets.</source>
        <translation>Les lignes montrent différentes parties d’une surface dont la planéité n’est pas démontrée ; seule la partie commune est utilisée : {named}. Désignez des cibles plus petites.</translation>
    </message>
    <message>
        <source>{share:n} % of the points of {target:kept}</source>
        <translation>{share} % des points de {target}</translation>
    </message>
    <message>
        <source>Excluded, because lines show different parts of it and it is not shown to be flat: {named:list}. Pick a part that two lines show.</source>
        <translation>Exclue, car les lignes en montrent différentes parties et sa planéité n’est pas démontrée : {named}. Désignez une partie que deux lignes montrent.</translation>
    </message>
    <message>
        <source>target {target:kept} not one flat surface</source>
        <translation>cible {target} qui n’est pas une même surface plane</translation>
    </message>
    <message>
        <source>Without {what} the angles are not determined, so that its errors cannot be detected. Add targets.</source>
        <translation>Sans {what}, les angles ne sont pas déterminés : ses erreurs ne peuvent donc pas être détectées. Ajoutez des cibles.</translation>
    </message>
    <message>
        <source>Without {what} the angles are not determined, so that its errors cannot be detected. Add lines.</source>
        <translation>Sans {what}, les angles ne sont pas déterminés : ses erreurs ne peuvent donc pas être détectées. Ajoutez des lignes.</translation>
    </message>
    <message>
        <source>The radius of {target:name} differs from line to line, from {a:n} to {b:n} mm, and no single error explains it. Check the attitude signs, the latency and the points of the target.</source>
        <translation>Le rayon de {target} diffère d&apos;une ligne à l&apos;autre, de {a} à {b} mm, et aucune erreur isolée ne l&apos;explique. Vérifiez les signes de l&apos;attitude, la latence et les points de la cible.</translation>
    </message>
    <message>
        <source>The radius of {target:name} differs from line to line, from {a:n} to {b:n} mm. They agree with the sign of roll turned: check the sign convention of the file.</source>
        <translation>Le rayon de {target} diffère d&apos;une ligne à l&apos;autre, de {a} à {b} mm. Ils concordent en inversant le signe du roulis : vérifiez la convention de signe du fichier.</translation>
    </message>
    <message>
        <source>The radius of {target:name} differs from line to line, from {a:n} to {b:n} mm. They agree with the sign of pitch turned: check the sign convention of the file.</source>
        <translation>Le rayon de {target} diffère d&apos;une ligne à l&apos;autre, de {a} à {b} mm. Ils concordent en inversant le signe du tangage : vérifiez la convention de signe du fichier.</translation>
    </message>
    <message>
        <source>The radius of {target:name} differs from line to line, from {a:n} to {b:n} mm. They agree with the signs of roll and pitch turned: check the sign convention of the file.</source>
        <translation>Le rayon de {target} diffère d&apos;une ligne à l&apos;autre, de {a} à {b} mm. Ils concordent en inversant les signes du roulis et du tangage : vérifiez la convention de signe du fichier.</translation>
    </message>
    <message>
        <source>The radius of {target:name} differs from line to line, from {a:n} to {b:n} mm. They agree with latency {v:n} ms larger: measure it again.</source>
        <translation>Le rayon de {target} diffère d&apos;une ligne à l&apos;autre, de {a} à {b} mm. Ils concordent avec une latence de {v} ms de plus : mesurez-la de nouveau.</translation>
    </message>
    <message>
        <source>The radius of {target:name} differs from line to line, from {a:n} to {b:n} mm. They agree with range offset {v:n} m larger: measure it again.</source>
        <translation>Le rayon de {target} diffère d&apos;une ligne à l&apos;autre, de {a} à {b} mm. Ils concordent avec un décalage de distance de {v} m de plus : mesurez-le de nouveau.</translation>
    </message>
    <message>
        <source>The radius of {target:name} differs from line to line, from {a:n} to {b:n} mm. They agree with latency {v:n} ms smaller: measure it again.</source>
        <translation>Le rayon de {target} diffère d&apos;une ligne à l&apos;autre, de {a} à {b} mm. Ils concordent avec une latence de {v} ms de moins : mesurez-la de nouveau.</translation>
    </message>
    <message>
        <source>The radius of {target:name} differs from line to line, from {a:n} to {b:n} mm. They agree with range offset {v:n} m smaller: measure it again.</source>
        <translation>Le rayon de {target} diffère d&apos;une ligne à l&apos;autre, de {a} à {b} mm. Ils concordent avec un décalage de distance de {v} m de moins : mesurez-le de nouveau.</translation>
    </message>
    <message>
        <source>Parts of the data scatter by more than the model of errors predicts. The standard deviations are raised: {raised:list}.</source>
        <translation>Des parties des données se dispersent plus que ne le prévoit le modèle d&apos;erreurs. Les écarts-types sont agrandis : {raised}.</translation>
    </message>
    <message>
        <source>{angle} from {before:n} to {after:n} deg</source>
        <translation>{angle} de {before} à {after} deg</translation>
    </message>
    <message>
        <source>Excluded, because only one line shows them: {targets:list}. Seed them on other lines, or remove them.</source>
        <translation>Exclues, car une seule ligne les montre : {targets}. Placez des points initiaux sur d&apos;autres lignes, ou supprimez-les.</translation>
    </message>
    <message>
        <source>Targets have points in common: {pairs:list}. These points count twice, and the sigmas of the angles come out too small; leave one of the two out.</source>
        <translation>Des cibles ont des points en commun : {pairs}. Ces points comptent deux fois, et les écarts-types des angles sont trop petits ; écartez l&apos;une des deux.</translation>
    </message>
    <message>
        <source>Targets have points in common: {pairs:list}. These points count twice, and the sigmas of the angles come out too small; leave one of each two out.</source>
        <translation>Des cibles ont des points en commun : {pairs}. Ces points comptent deux fois, et les écarts-types des angles sont trop petits ; écartez l&apos;une des deux de chaque paire.</translation>
    </message>
    <message>
        <source>A validation plane has points in common with a target: {pairs:list}. It is no independent check of the angles; leave one of the two out.</source>
        <translation>Un plan de validation a des points en commun avec une cible : {pairs}. Ce n&apos;est pas un contrôle indépendant des angles ; écartez l&apos;un des deux.</translation>
    </message>
    <message>
        <source>Validation planes have points in common with targets: {pairs:list}. They are no independent check of the angles; leave one of each two out.</source>
        <translation>Des plans de validation ont des points en commun avec des cibles : {pairs}. Ce n&apos;est pas un contrôle indépendant des angles ; écartez l&apos;un des deux de chaque paire.</translation>
    </message>
    <message>
        <source>{one:name} with {other:name} ({share:n} % on {line:name})</source>
        <translation>{one} avec {other} ({share} % sur {line})</translation>
    </message>
</context>
<context>
    <name>advice</name>
    <message>
        <source>A further line headed {heading:n} deg, with the middle of the targets {metres:n} m to port, would bring the sigma of {angle} from {now:n} to {then:n} deg.</source>
        <translation>Une ligne de plus au cap {heading}°, avec le milieu des cibles à {metres} m sur bâbord, ramènerait l&apos;écart-type du {angle} de {now}° à {then}°.</translation>
    </message>
    <message>
        <source>A further line headed {heading:n} deg, with the middle of the targets {metres:n} m to starboard, would bring the sigma of {angle} from {now:n} to {then:n} deg.</source>
        <translation>Une ligne de plus au cap {heading}°, avec le milieu des cibles à {metres} m sur tribord, ramènerait l&apos;écart-type du {angle} de {now}° à {then}°.</translation>
    </message>
    <message>
        <source>A further line headed {heading:n} deg ({off:n} deg off the face of {target}), with the middle of the targets {metres:n} m to port, would bring the sigma of {angle} from {now:n} to {then:n} deg.</source>
        <translation>Une ligne de plus au cap {heading}° (à {off}° de la face de {target}), avec le milieu des cibles à {metres} m sur bâbord, ramènerait l&apos;écart-type du {angle} de {now}° à {then}°.</translation>
    </message>
    <message>
        <source>A further line headed {heading:n} deg ({off:n} deg off the face of {target}), with the middle of the targets {metres:n} m to starboard, would bring the sigma of {angle} from {now:n} to {then:n} deg.</source>
        <translation>Une ligne de plus au cap {heading}° (à {off}° de la face de {target}), avec le milieu des cibles à {metres} m sur tribord, ramènerait l&apos;écart-type du {angle} de {now}° à {then}°.</translation>
    </message>
    <message>
        <source>No single further line past these targets, {metres:n} m from their middle, would bring the sigma of {angle} from {now:n} below {limit:n} deg; targets elsewhere, or the survey repeated later, when the POS error is another one, would.</source>
        <translation>Aucune ligne de plus devant ces cibles, à {metres} m de leur milieu, ne ramènerait l&apos;écart-type du {angle} de {now}° à moins de {limit}° ; des cibles ailleurs le feraient, ou le levé répété plus tard, quand l&apos;erreur du POS est autre.</translation>
    </message>
    <message>
        <source>The sigma of {angle} is mostly that of the stated {parameters:list}, and no further line lowers it.</source>
        <translation>L&apos;écart-type du {angle} vient surtout de celui de la valeur déclarée ({parameters}), et aucune ligne de plus ne le diminue.</translation>
    </message>
</context>
<context>
    <name>missing</name>
    <message>
        <source>no plane at the seed</source>
        <translation>aucun plan au point initial</translation>
    </message>
    <message>
        <source>The line has only {points:n} points within {reach:n} m of the seed.</source>
        <translation>La ligne n&apos;a que {points} points à moins de {reach} m du point initial.</translation>
    </message>
    <message>
        <source>The line has no points within {reach:n} m of the seed.</source>
        <translation>La ligne n&apos;a aucun point à moins de {reach} m du point initial.</translation>
    </message>
    <message>
        <source>The points found are part of a surface that crosses the target.</source>
        <translation>Les points trouvés font partie d’une surface qui coupe la cible.</translation>
    </message>
    <message>
        <source>The sphere found is {apart:n} m from where the other lines show the target; {allowed:n} m are possible.</source>
        <translation>La sphère trouvée est à {apart} m de l’endroit où les autres lignes montrent la cible ; {allowed} m sont possibles.</translation>
    </message>
    <message>
        <source>The plane found is inclined by {tilt:n} deg to the target on the other lines and lies {offset:n} m before or behind it: it is another surface.</source>
        <translation>Le plan trouvé est incliné de {tilt} deg par rapport à la cible sur les autres lignes et se trouve à {offset} m devant ou derrière elle : c’est une autre surface.</translation>
    </message>
    <message>
        <source>The plane found is {apart:n} m beside the target on the other lines; {allowed:n} m are possible. It is another surface.</source>
        <translation>Le plan trouvé est à {apart} m à côté de la cible sur les autres lignes ; {allowed} m sont possibles. C’est une autre surface.</translation>
    </message>
    <message>
        <source>Only {overlap:n} % of the plane found lies where the other lines show the target: it is another surface.</source>
        <translation>Seuls {overlap} % du plan trouvé se trouvent là où les autres lignes montrent la cible : c’est une autre surface.</translation>
    </message>
    <message>
        <source>The plane found covers only {share:n} % of the target&apos;s outline.</source>
        <translation>Le plan trouvé ne couvre que {share} % du contour de la cible.</translation>
    </message>
    <message>
        <source>The plane found is {times:n} times as large as the target.</source>
        <translation>Le plan trouvé est {times} fois plus grand que la cible.</translation>
    </message>
    <message>
        <source>Two planes {apart:n} m apart resemble the target equally; set a seed of its own for this line.</source>
        <translation>Deux plans distants de {apart} m ressemblent également à la cible ; placez un point initial propre à cette ligne.</translation>
    </message>
    <message>
        <source>Two spheres {apart:n} m apart resemble the target equally; set a seed of its own for this line.</source>
        <translation>Deux sphères distantes de {apart} m ressemblent également à la cible ; placez un point initial propre à cette ligne.</translation>
    </message>
    <message>
        <source>The seed must be three numbers: north, west and up, in metres.</source>
        <translation>Le point initial doit être trois nombres : nord, ouest et haut, en mètres.</translation>
    </message>
    <message>
        <source>Only {points:n} points lie within {radius:n} m of {place}, fewer than the {least:n} a target needs; move the seed or enlarge the radius.</source>
        <translation>Il n&apos;y a que {points} points à moins de {radius} m de {place}, moins que les {least} qu&apos;il faut à une cible ; déplacez le point initial ou agrandissez le rayon.</translation>
    </message>
    <message>
        <source>No points lie within {radius:n} m of {place}.</source>
        <translation>Il n&apos;y a aucun point à moins de {radius} m de {place}.</translation>
    </message>
    <message>
        <source>No points lie within {radius:n} m of {place}; the nearest is {distance:n} m away.</source>
        <translation>Il n&apos;y a aucun point à moins de {radius} m de {place} ; le plus proche est à {distance} m.</translation>
    </message>
    <message>
        <source>No plane within {threshold:n} m holds the points around {place}.</source>
        <translation>Aucun plan ne tient, à {threshold} m près, les points autour de {place}.</translation>
    </message>
    <message>
        <source>The flat patch around {place} has only {points:n} points, fewer than {least:n}; a wider threshold than {threshold:n} m may help.</source>
        <translation>La surface plane autour de {place} n&apos;a que {points} points, moins de {least} ; un seuil plus large que {threshold} m peut aider.</translation>
    </message>
    <message>
        <source>A plane needs at least three points, here there are {points:n}.</source>
        <translation>Un plan demande au moins trois points ; ici, il y en a {points}.</translation>
    </message>
    <message>
        <source>A sphere cannot have a radius of {radius} m.</source>
        <translation>Une sphère ne peut avoir un rayon de {radius} m.</translation>
    </message>
    <message>
        <source>A sphere needs at least four points, here there are {points:n}.</source>
        <translation>Une sphère demande au moins quatre points ; ici, il y en a {points}.</translation>
    </message>
    <message>
        <source>The points show too little of a curve for their noise to tell the radius of a sphere; give the radius, or take more of the surface.</source>
        <translation>Les points montrent trop peu de courbure, vu leur bruit, pour donner le rayon d&apos;une sphère ; indiquez le rayon, ou prenez une plus grande part de la surface.</translation>
    </message>
    <message>
        <source>The points are too small a part of a sphere of this radius to tell where its centre lies; take more of the surface.</source>
        <translation>Les points sont une trop petite part d&apos;une sphère de ce rayon pour en situer le centre ; prenez une plus grande part de la surface.</translation>
    </message>
    <message>
        <source>The points are too flat to tell on which side of them the centre of the sphere lies; take more of the surface.</source>
        <translation>Les points sont trop plats pour dire de quel côté est le centre de la sphère ; prenez une plus grande part de la surface.</translation>
    </message>
    <message>
        <source>Only {points:n} points lie within {reach:n} m of {place}, where a sphere {sought} would be, fewer than the {least:n} a target needs; set the seed on the ball.</source>
        <translation>Il n&apos;y a que {points} points à moins de {reach} m de {place}, là où serait une sphère {sought}, moins que les {least} qu&apos;il faut à une cible ; placez le point initial sur la sphère.</translation>
    </message>
    <message>
        <source>No sphere {sought} holds the points around {place} within {threshold:n} m.</source>
        <translation>Aucune sphère {sought} ne tient, à {threshold} m près, les points autour de {place}.</translation>
    </message>
    <message>
        <source>of radius {radius:n} m</source>
        <translation>de rayon {radius} m</translation>
    </message>
    <message>
        <source>of a radius from {least:n} to {most:n} m</source>
        <translation>d&apos;un rayon de {least} à {most} m</translation>
    </message>
    <message>
        <source>The sphere around {place} has only {points:n} points, fewer than {least:n}; a wider threshold than {threshold:n} m may help.</source>
        <translation>La sphère autour de {place} n&apos;a que {points} points, moins de {least} ; un seuil plus large que {threshold} m peut aider.</translation>
    </message>
    <message>
        <source>The surface around {place} is round with a radius of {radius:n} m, but a sphere {sought} was sought.</source>
        <translation>La surface autour de {place} est ronde, d&apos;un rayon de {radius} m, mais une sphère {sought} était cherchée.</translation>
    </message>
    <message>
        <source>The nearest sphere lies {distance:n} m from {place}; set the seed on the ball.</source>
        <translation>La sphère la plus proche est à {distance} m de {place} ; placez le point initial sur la sphère.</translation>
    </message>
    <message>
        <source>A sphere {sought} around {place} touches {points:n} points, but the surface goes on beside it with {more:n} more: it is no ball, or one of another radius or with more noise than the threshold allows.</source>
        <translation>Une sphère {sought} autour de {place} touche {points} points, mais la surface se poursuit à côté avec {more} autres : ce n&apos;est pas une sphère, ou elle a un autre rayon ou plus de bruit que le seuil n&apos;en admet.</translation>
    </message>
    <message>
        <source>The points around {place} show {share:n} % of a sphere&apos;s surface, too little to call it a ball; at least {least:n} % are needed.</source>
        <translation>Les points autour de {place} montrent {share} % de la surface d&apos;une sphère, trop peu pour y voir une sphère ; il en faut au moins {least} %.</translation>
    </message>
    <message>
        <source>The surface around {place} is flat rather than a ball.</source>
        <translation>La surface autour de {place} est plane et non une sphère.</translation>
    </message>
    <message>
        <source>The sphere found has a radius of {radius:n} m, but in the line clicked it has {other:n} m.</source>
        <translation>La sphère trouvée a un rayon de {radius} m, mais de {other} m dans la ligne cliquée.</translation>
    </message>
</context>
<context>
    <name>notes</name>
    <message>
        <source>{name:name}: {what}</source>
        <translation>{name} : {what}</translation>
    </message>
    <message>
        <source>SBET times and point times share one time base</source>
        <translation>les temps du SBET et ceux des points ont la même base de temps</translation>
    </message>
    <message>
        <source>SBET times and point times share one time base once the shifts are added</source>
        <translation>les temps du SBET et ceux des points ont la même base de temps une fois les décalages ajoutés</translation>
    </message>
    <message>
        <source>SBET after Applanix: North-East-Down, roll positive starboard down, pitch positive bow up (its sign is turned here), true heading = platform heading - wander angle</source>
        <translation>SBET selon Applanix : nord-est-bas, roulis positif quand tribord descend, tangage positif quand l&apos;étrave monte (son signe est inversé ici), cap vrai = cap de la plateforme − angle de dérive (wander)</translation>
    </message>
    <message>
        <source>LAS coordinates are metres in the LiDAR frame</source>
        <translation>les coordonnées LAS sont en mètres dans le repère du LiDAR</translation>
    </message>
    <message>
        <source>LAS gps_time is the point time</source>
        <translation>le champ gps_time du LAS est le temps du point</translation>
    </message>
    <message>
        <source>text coordinates are metres in the LiDAR frame</source>
        <translation>les coordonnées du texte sont en mètres dans le repère du LiDAR</translation>
    </message>
    <message>
        <source>points are in the LiDAR frame</source>
        <translation>les points sont dans le repère du LiDAR</translation>
    </message>
    <message>
        <source>{file:name} is {format}</source>
        <translation>{file} est lu comme {format}</translation>
    </message>
    <message>
        <source>LAS or LAZ</source>
        <translation>LAS ou LAZ</translation>
    </message>
    <message>
        <source>E57</source>
        <translation>E57</translation>
    </message>
    <message>
        <source>PLY</source>
        <translation>PLY</translation>
    </message>
    <message>
        <source>PCD</source>
        <translation>PCD</translation>
    </message>
    <message>
        <source>CIDCO binary (22 columns)</source>
        <translation>binaire du CIDCO (22 colonnes)</translation>
    </message>
    <message>
        <source>Target (CSV)</source>
        <translation>cible (CSV)</translation>
    </message>
    <message>
        <source>Plane file (25 columns)</source>
        <translation>fichier de plans (25 colonnes)</translation>
    </message>
    <message>
        <source>Text (CSV, also .gz)</source>
        <translation>texte (CSV, aussi .gz)</translation>
    </message>
    <message>
        <source>The header gives no unit for {column:kept}; {unit} are taken.</source>
        <translation>L&apos;en-tête ne donne pas d&apos;unité pour {column} ; unité prise : {unit}.</translation>
    </message>
    <message>
        <source>The header gives no unit for {column:kept}; that of the coordinate system is taken, for heights without one metres.</source>
        <translation>L&apos;en-tête ne donne pas d&apos;unité pour {column} ; celle du système de coordonnées est prise, et le mètre pour des hauteurs qui n&apos;en ont pas.</translation>
    </message>
    <message>
        <source>{line:name} was imported again: {reason}</source>
        <translation>{line} a été importée de nouveau : {reason}</translation>
    </message>
    <message>
        <source>{line:name}: {what:list} changed since it was imported</source>
        <translation>{line} : changement depuis l&apos;importation ({what})</translation>
    </message>
    <message>
        <source>{path:kept}: this part of the imported line {line} is missing</source>
        <translation>{path} : cette partie de la ligne importée {line} manque</translation>
    </message>
    <message>
        <source>{path:kept}: this part of the imported line {line} has {some:n} of {all:n} bytes</source>
        <translation>{path} : cette partie de la ligne importée {line} a {some} octets sur {all}</translation>
    </message>
    <message>
        <source>how its file is read</source>
        <translation>la façon de lire son fichier</translation>
    </message>
    <message>
        <source>the names of its columns</source>
        <translation>les noms de ses colonnes</translation>
    </message>
    <message>
        <source>the trajectory, its origin or its longest gap</source>
        <translation>la trajectoire, son origine ou sa plus longue lacune</translation>
    </message>
    <message>
        <source>times are shifted by {shift:n} s</source>
        <translation>les temps sont décalés de {shift} s</translation>
    </message>
    <message>
        <source>POS accuracies are the typed ones, the same at all times</source>
        <translation>les précisions du POS sont celles qui ont été saisies, les mêmes à tout moment</translation>
    </message>
    <message>
        <source>it covers {start:n} to {end:n} s, not the whole trajectory ({first:n} to {last:n} s); beyond, its first and last values are taken</source>
        <translation>il couvre {start} à {end} s et non toute la trajectoire ({first} à {last} s) ; au-delà, ses première et dernière valeurs sont prises</translation>
    </message>
    <message>
        <source>{what:list}, of {all:n}, are left out</source>
        <translation>{what}, sur {all}, sont laissés de côté</translation>
    </message>
    <message>
        <source>{n:n} points outside the trajectory&apos;s time</source>
        <translation>{n} points hors du temps de la trajectoire</translation>
    </message>
    <message>
        <source>{n:n} points in a gap of the trajectory longer than {gap:n} s</source>
        <translation>{n} points dans une lacune de la trajectoire de plus de {gap} s</translation>
    </message>
    <message>
        <source>{n:n} points where the trajectory&apos;s pitch is beyond 80 deg</source>
        <translation>{n} points où le tangage de la trajectoire dépasse 80°</translation>
    </message>
    <message>
        <source>{n:n} points outside the trajectory&apos;s time, or in a gap of it longer than {gap:n} s, are left out</source>
        <translation>{n} points hors du temps de la trajectoire, ou dans une lacune de celle-ci de plus de {gap} s, sont laissés de côté</translation>
    </message>
    <message>
        <source>with {shift:n} s added, {share:n} % of its points lie inside: where the scanner wrote {own} and the trajectory is in {other}, import it again with --time-shift {value:kept}</source>
        <translation>avec {shift} s ajoutées, {share} % de ses points sont à l&apos;intérieur : si le scanneur a écrit des {own} et que la trajectoire est en {other}, importez-le de nouveau avec --time-shift {value}</translation>
    </message>
    <message>
        <source>its times restart within it: import it again with --line-option {option:kept}</source>
        <translation>ses temps recommencent en cours de route : importez-le de nouveau avec --line-option {option}</translation>
    </message>
    <message>
        <source>not counted on, {share:n} % of its points lie inside: where the trajectory&apos;s times restart too, import it again with --line-option {option:kept}</source>
        <translation>sans report, {share} % de ses points sont à l&apos;intérieur : si les temps de la trajectoire recommencent aussi, importez-le de nouveau avec --line-option {option}</translation>
    </message>
    <message>
        <source>{path:kept} is not there; {line} is used as it was imported from it before</source>
        <translation>{path} est introuvable ; {line} est utilisée telle qu&apos;elle en avait été importée</translation>
    </message>
    <message>
        <source>the points were made with this trajectory, lever arm and boresight, and were not adjusted afterwards</source>
        <translation>les points ont été faits avec cette trajectoire, ce bras de levier et ces angles de visée et n&apos;ont pas été ajustés ensuite</translation>
    </message>
    <message>
        <source>coordinate system {name:kept}</source>
        <translation>système de coordonnées {name}</translation>
    </message>
    <message>
        <source>the coordinate system names no heights: taken above the ellipsoid</source>
        <translation>le système de coordonnées ne nomme pas de hauteurs : prises au-dessus de l&apos;ellipsoïde</translation>
    </message>
    <message>
        <source>heights in {unit}</source>
        <translation>hauteurs en {unit}</translation>
    </message>
    <message>
        <source>heights in {unit}, as the horizontal coordinates</source>
        <translation>hauteurs en {unit}, comme les coordonnées horizontales</translation>
    </message>
    <message>
        <source>trajectory in {datum:kept}, not shifted to another datum</source>
        <translation>trajectoire en {datum}, sans passage à un autre référentiel</translation>
    </message>
    <message>
        <source>trajectory in {datum:kept}, points shifted there from {other:kept}</source>
        <translation>trajectoire en {datum}, points ramenés à ce référentiel depuis {other}</translation>
    </message>
    <message>
        <source>waveforms are not read; the points and what they say of their waveforms are</source>
        <translation>les formes d&apos;onde ne sont pas lues ; les points et ce qu&apos;ils en disent le sont</translation>
    </message>
    <message>
        <source>waveforms are not read; the points and what they say of their waveforms are, and of that LAZ with several scanner channels may give back another size, place and direction</source>
        <translation>les formes d&apos;onde ne sont pas lues ; les points et ce qu&apos;ils en disent le sont, mais un LAZ à plusieurs canaux de scanneur peut en rendre une autre taille, une autre place et une autre direction</translation>
    </message>
    <message>
        <source>SBET: true heading is the platform heading less the wander angle</source>
        <translation>SBET : le cap vrai est le cap de la plateforme moins l&apos;angle de dérive (wander)</translation>
    </message>
    <message>
        <source>SBET: true heading is the platform heading as it is</source>
        <translation>SBET : le cap vrai est le cap de la plateforme tel quel</translation>
    </message>
    <message>
        <source>roll is positive starboard down</source>
        <translation>le roulis est positif quand tribord descend</translation>
    </message>
    <message>
        <source>roll is positive port down (its sign is turned here)</source>
        <translation>le roulis est positif quand bâbord descend (son signe est inversé ici)</translation>
    </message>
    <message>
        <source>pitch is positive bow down</source>
        <translation>le tangage est positif quand l&apos;étrave descend</translation>
    </message>
    <message>
        <source>pitch is positive bow up (its sign is turned here)</source>
        <translation>le tangage est positif quand l&apos;étrave monte (son signe est inversé ici)</translation>
    </message>
    <message>
        <source>velocities are taken in the axes that fit the positions best</source>
        <translation>les vitesses sont prises dans les axes qui correspondent le mieux aux positions</translation>
    </message>
    <message>
        <source>the axes of the velocities are {axes}</source>
        <translation>axes des vitesses : {axes}</translation>
    </message>
    <message>
        <source>x along the wander azimuth, y to its left, z up</source>
        <translation>x le long de l&apos;azimut de dérive (wander), y à sa gauche, z vers le haut</translation>
    </message>
    <message>
        <source>x along the wander azimuth, y to its right, z down</source>
        <translation>x le long de l&apos;azimut de dérive (wander), y à sa droite, z vers le bas</translation>
    </message>
    <message>
        <source>north, east, down</source>
        <translation>nord, est, bas</translation>
    </message>
    <message>
        <source>east, north, up</source>
        <translation>est, nord, haut</translation>
    </message>
    <message>
        <source>north, west, up</source>
        <translation>nord, ouest, haut</translation>
    </message>
    <message>
        <source>north, east, up</source>
        <translation>nord, est, haut</translation>
    </message>
    <message>
        <source>times are {base}</source>
        <translation>temps : {base}</translation>
    </message>
    <message>
        <source>GPS seconds of the week</source>
        <translation>secondes GPS de la semaine</translation>
    </message>
    <message>
        <source>GPS seconds of the day</source>
        <translation>secondes GPS du jour</translation>
    </message>
    <message>
        <source>UTC seconds of the day</source>
        <translation>secondes UTC du jour</translation>
    </message>
    <message>
        <source>UTC seconds of the week</source>
        <translation>secondes UTC de la semaine</translation>
    </message>
    <message>
        <source>adjusted standard GPS time (minus 1e9)</source>
        <translation>temps GPS standard ajusté (moins 1e9)</translation>
    </message>
    <message>
        <source>GPS seconds since 1980-01-06</source>
        <translation>secondes GPS depuis le 1980-01-06</translation>
    </message>
    <message>
        <source>UTC seconds since 1970-01-01</source>
        <translation>secondes UTC depuis le 1970-01-01</translation>
    </message>
    <message>
        <source>angles are in {unit}, positions are {order}, numbers are {bytes}</source>
        <translation>angles en {unit}, positions : {order}, nombres : {bytes}</translation>
    </message>
    <message>
        <source>latitude before longitude</source>
        <translation>latitude avant longitude</translation>
    </message>
    <message>
        <source>longitude before latitude</source>
        <translation>longitude avant latitude</translation>
    </message>
    <message>
        <source>little-endian</source>
        <translation>petit-boutistes (little-endian)</translation>
    </message>
    <message>
        <source>big-endian</source>
        <translation>gros-boutistes (big-endian)</translation>
    </message>
    <message>
        <source>heights are above the ellipsoid; the datum is not stated in the file</source>
        <translation>les hauteurs sont au-dessus de l&apos;ellipsoïde ; le fichier ne dit pas le référentiel</translation>
    </message>
    <message>
        <source>times start again at midnight or at the end of the week and are counted on from there</source>
        <translation>les temps recommencent à minuit ou à la fin de la semaine et sont comptés à la suite</translation>
    </message>
    <message>
        <source>times start again 1 time (midnight or end of the week) and are counted on from there</source>
        <translation>les temps recommencent une fois (minuit ou fin de la semaine) et sont comptés à la suite</translation>
    </message>
    <message>
        <source>times start again {n:n} times (midnight or end of the week) and are counted on from there</source>
        <translation>les temps recommencent {n} fois (minuit ou fin de la semaine) et sont comptés à la suite</translation>
    </message>
    <message>
        <source>heading is clockwise from true north</source>
        <translation>le cap est compté dans le sens horaire depuis le nord vrai</translation>
    </message>
    <message>
        <source>heading is clockwise from grid north (the meridian convergence is added here)</source>
        <translation>le cap est compté dans le sens horaire depuis le nord de la grille (la convergence des méridiens est ajoutée ici)</translation>
    </message>
    <message>
        <source>eastings and northings are in {crs:kept}; latitude and longitude are on its own datum</source>
        <translation>les coordonnées est et nord sont en {crs} ; latitude et longitude sont dans son propre référentiel</translation>
    </message>
    <message>
        <source>heights are above sea level and taken as if above the ellipsoid: absolute heights are off by the geoid height</source>
        <translation>les hauteurs sont au-dessus du niveau de la mer et prises comme si elles l&apos;étaient de l&apos;ellipsoïde : les hauteurs absolues sont fausses de la hauteur du géoïde</translation>
    </message>
    <message>
        <source>date and time of day are UTC</source>
        <translation>date et heure sont en UTC</translation>
    </message>
    <message>
        <source>date and time of day are GPS</source>
        <translation>date et heure sont en temps GPS</translation>
    </message>
    <message>
        <source>Exail text: columns and units by the header</source>
        <translation>texte Exail : colonnes et unités d&apos;après l&apos;en-tête</translation>
    </message>
    <message>
        <source>POSPac text: columns and units by the header</source>
        <translation>texte POSPac : colonnes et unités d&apos;après l&apos;en-tête</translation>
    </message>
    <message>
        <source>text with the columns {columns:kept}</source>
        <translation>texte aux colonnes {columns}</translation>
    </message>
    <message>
        <source>column {column:kept} is in {unit}</source>
        <translation>la colonne {column} est en {unit}</translation>
    </message>
    <message>
        <source>{unit}, as in the coordinate system (the file names no unit)</source>
        <translation>{unit}, comme dans le système de coordonnées (le fichier ne nomme pas d&apos;unité)</translation>
    </message>
    <message>
        <source>{unit}, the feet of the coordinate system</source>
        <translation>{unit}, les pieds du système de coordonnées</translation>
    </message>
    <message>
        <source>metres (no unit is stated)</source>
        <translation>mètres (aucune unité n&apos;est indiquée)</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>mètres</translation>
    </message>
    <message>
        <source>metre</source>
        <translation>mètres</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>millimètres</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>centimètres</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>pieds</translation>
    </message>
    <message>
        <source>foot</source>
        <translation>pieds</translation>
    </message>
    <message>
        <source>millimetre</source>
        <translation>millimètres</translation>
    </message>
    <message>
        <source>US survey feet</source>
        <translation>pieds d&apos;arpentage américains</translation>
    </message>
    <message>
        <source>feet of 0.3048 m</source>
        <translation>pieds de 0.3048 m</translation>
    </message>
    <message>
        <source>US survey foot</source>
        <translation>pieds d&apos;arpentage américains</translation>
    </message>
    <message>
        <source>radians</source>
        <translation>radians</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>degrés</translation>
    </message>
    <message>
        <source>degrees, minutes and seconds</source>
        <translation>degrés, minutes et secondes</translation>
    </message>
    <message>
        <source>arc minutes</source>
        <translation>minutes d&apos;arc</translation>
    </message>
    <message>
        <source>CIDCO states: positions are metres north, west, up about {origin:kept} (deg, deg, m)</source>
        <translation>états du CIDCO : positions en mètres nord, ouest, haut autour de {origin} (°, °, m)</translation>
    </message>
    <message>
        <source>roll is positive starboard down, pitch positive bow down, heading clockwise from the north of that frame, radians</source>
        <translation>roulis positif quand tribord descend, tangage positif quand l&apos;étrave descend, cap dans le sens horaire depuis le nord de ce repère, en radians</translation>
    </message>
    <message>
        <source>times count as those of the points</source>
        <translation>les temps comptent comme ceux des points</translation>
    </message>
</context>
<context>
    <name>identity</name>
    <message>
        <source>Details of the survey</source>
        <translation>Renseignements sur le levé</translation>
    </message>
    <message>
        <source>Vessel</source>
        <translation>Navire</translation>
    </message>
    <message>
        <source>Site</source>
        <translation>Site</translation>
    </message>
    <message>
        <source>Scanner</source>
        <translation>Scanneur</translation>
    </message>
    <message>
        <source>Scanner serial number</source>
        <translation>Numéro de série du scanneur</translation>
    </message>
    <message>
        <source>INS/GNSS</source>
        <translation>INS/GNSS</translation>
    </message>
    <message>
        <source>INS/GNSS serial number</source>
        <translation>Numéro de série de l&apos;INS/GNSS</translation>
    </message>
    <message>
        <source>Survey dates</source>
        <translation>Dates du levé</translation>
    </message>
    <message>
        <source>Origin of the lever arm</source>
        <translation>Provenance du bras de levier</translation>
    </message>
    <message>
        <source>The lines placed with the prior boresight</source>
        <translation>Les lignes placées avec les angles de visée a priori</translation>
    </message>
    <message>
        <source>The lines placed with the estimated boresight</source>
        <translation>Les lignes placées avec les angles de visée estimés</translation>
    </message>
</context>
<context>
    <name>standards</name>
    <message>
        <source>Uncertainty in standard terms</source>
        <translation>Incertitudes au sens des normes</translation>
    </message>
    <message>
        <source>Uncertainty in the wording of IHO S-44: contribution of the boresight alone, 95 %</source>
        <translation>Incertitude dans les termes de la S-44 de l&apos;OHI : part des seuls angles de visée, à 95 %</translation>
    </message>
    <message>
        <source>Distance
(m)</source>
        <translation>Distance
(m)</translation>
    </message>
    <message>
        <source>THU
(cm)</source>
        <translation>THU
(cm)</translation>
    </message>
    <message>
        <source>TVU
(cm)</source>
        <translation>TVU
(cm)</translation>
    </message>
    <message>
        <source>Total horizontal and vertical uncertainty (THU, TVU) as IHO S-44, edition 6.1.0, states them, at 95 % confidence: 2.45 standard deviations along the longest axis of the horizontal error ellipse, 1.96 standard deviations of the height. Given is what the uncertainty of the boresight adds to a point at that distance from the scanner, for the beam where it shows most and a level vessel. It is not the total of a survey, to which position, attitude, range, lever arm and the reduction of heights add; the orders of the standard limit the total and are not compared.</source>
        <translation>Incertitudes horizontale et verticale totales (THU, TVU) telles que les définit la S-44 de l&apos;OHI, édition 6.1.0, au niveau de confiance de 95 % : 2.45 écarts-types le long du grand axe de l&apos;ellipse d&apos;erreur horizontale, 1.96 écart-type de la hauteur. Est donné ce que l&apos;incertitude des angles de visée ajoute à un point à cette distance du scanneur, pour le faisceau où elle se voit le plus et un navire à l&apos;horizontale. Ce n&apos;est pas le total d&apos;un levé, auquel s&apos;ajoutent position, attitude, distance, bras de levier et réduction des hauteurs ; les ordres de la norme limitent le total et ne sont pas comparés.</translation>
    </message>
    <message>
        <source>Swath overlap difference (RMSDn, along the surface&apos;s normal)</source>
        <translation>Différence entre bandes en recouvrement (RMSDn, le long de la normale de la surface)</translation>
    </message>
    <message>
        <source>Pairs of
lines</source>
        <translation>Paires de
lignes</translation>
    </message>
    <message>
        <source>RMSDn before
(mm)</source>
        <translation>RMSDn avant
(mm)</translation>
    </message>
    <message>
        <source>RMSDn after
(mm)</source>
        <translation>RMSDn après
(mm)</translation>
    </message>
    <message>
        <source>All {n:n} planes</source>
        <translation>Les {n} plans</translation>
    </message>
    <message>
        <source>All 1 plane</source>
        <translation>Le seul plan</translation>
    </message>
    <message>
        <source>After the swath overlap difference of the USGS Lidar Base Specification (2024 rev. A), the root mean square of the differences in height of overlapping swaths (RMSDz) on open ground. The validation planes stand upright or lean, so the differences are taken along their normal: between the means of both lines within cylinders, at places of either, for every pair of lines that overlaps. The noise of single points averages out; what remains after the calibration is the POS error of each line. The quality levels of the specification hold for heights on the ground and are not compared.</source>
        <translation>D&apos;après la différence entre bandes en recouvrement de la Lidar Base Specification de l&apos;USGS (2024 rév. A), la moyenne quadratique des différences de hauteur entre bandes en recouvrement (RMSDz) sur terrain découvert. Les plans de validation sont verticaux ou inclinés : les différences sont donc prises le long de leur normale, entre les moyennes des deux lignes dans des cylindres, en des endroits de l&apos;une et de l&apos;autre, pour chaque paire de lignes en recouvrement. Le bruit des points se compense ; ce qui reste après l&apos;étalonnage est l&apos;erreur du POS de chaque ligne. Les niveaux de qualité de la spécification valent pour des hauteurs au sol et ne sont pas comparés.</translation>
    </message>
</context>
<context>
    <name>conventions</name>
    <message>
        <source>Values for other programs</source>
        <translation>Valeurs pour d&apos;autres logiciels</translation>
    </message>
    <message>
        <source>Boresight for {name:kept}: convention {status}</source>
        <translation>Angles de visée pour {name} : convention {status}</translation>
    </message>
    <message>
        <source>Boresight for This program (iXblue): convention verified</source>
        <translation>Angles de visée pour ce programme (iXblue) : convention vérifiée</translation>
    </message>
    <message>
        <source>Boresight for Phoenix SpatialExplorer 6 and later: convention {status}</source>
        <translation>Angles de visée pour Phoenix SpatialExplorer 6 et suivants : convention {status}</translation>
    </message>
    <message>
        <source>Boresight for Phoenix SpatialExplorer 1 to 5: convention {status}</source>
        <translation>Angles de visée pour Phoenix SpatialExplorer 1 à 5 : convention {status}</translation>
    </message>
    <message>
        <source>Convention of Phoenix SpatialExplorer 6 and later</source>
        <translation>Convention de Phoenix SpatialExplorer 6 et suivants</translation>
    </message>
    <message>
        <source>Convention of Phoenix SpatialExplorer 1 to 5</source>
        <translation>Convention de Phoenix SpatialExplorer 1 à 5</translation>
    </message>
    <message>
        <source>Convention of Applanix POS MV, LVX, POSPac</source>
        <translation>Convention d&apos;Applanix POS MV, LVX, POSPac</translation>
    </message>
    <message>
        <source>Convention of OPALS StripAdjust</source>
        <translation>Convention d&apos;OPALS StripAdjust</translation>
    </message>
    <message>
        <source>Convention of {name:kept}</source>
        <translation>Convention de {name}</translation>
    </message>
    <message>
        <source>Convention of This program (iXblue)</source>
        <translation>Convention de ce programme (iXblue)</translation>
    </message>
    <message>
        <source>verified</source>
        <translation>vérifiée</translation>
    </message>
    <message>
        <source>partly verified</source>
        <translation>partiellement vérifiée</translation>
    </message>
    <message>
        <source>NOT VERIFIED</source>
        <translation>NON VÉRIFIÉE</translation>
    </message>
    <message>
        <source>Value
(deg)</source>
        <translation>Valeur
(°)</translation>
    </message>
    <message>
        <source>Sign</source>
        <translation>Signe</translation>
    </message>
    <message>
        <source>positive left side up</source>
        <translation>positif quand bâbord monte</translation>
    </message>
    <message>
        <source>positive port side up</source>
        <translation>positif quand bâbord monte</translation>
    </message>
    <message>
        <source>positive starboard side down</source>
        <translation>positif quand tribord descend</translation>
    </message>
    <message>
        <source>positive bow down</source>
        <translation>positif quand l&apos;étrave descend</translation>
    </message>
    <message>
        <source>positive bow up</source>
        <translation>positif quand l&apos;étrave monte</translation>
    </message>
    <message>
        <source>positive clockwise seen from above</source>
        <translation>positif dans le sens horaire vu d&apos;en haut</translation>
    </message>
    <message>
        <source>positive counter-clockwise seen from above</source>
        <translation>positif dans le sens antihoraire vu d&apos;en haut</translation>
    </message>
    <message>
        <source>right-handed</source>
        <translation>sens direct</translation>
    </message>
    <message>
        <source>right-handed, {meaning}</source>
        <translation>sens direct, {meaning}</translation>
    </message>
    <message>
        <source>How well this is known</source>
        <translation>Certitude de la convention</translation>
    </message>
    <message>
        <source>{status}; source: {source}</source>
        <translation>{status} ; source : {source}</translation>
    </message>
    <message>
        <source>proved on real vessel data</source>
        <translation>prouvée sur des données réelles d&apos;un navire</translation>
    </message>
    <message>
        <source>POS MV and LVX manuals (Tait-Bryan sequence, mounting angles with examples)</source>
        <translation>manuels POS MV et LVX (séquence de Tait-Bryan, angles de montage avec exemples)</translation>
    </message>
    <message>
        <source>Qinsy manual, sign conventions</source>
        <translation>manuel de Qinsy, conventions de signes</translation>
    </message>
    <message>
        <source>Kluster&apos;s code (rotations, orientation)</source>
        <translation>code de Kluster (rotations, orientation)</translation>
    </message>
    <message>
        <source>NovAtel application notes on rotations (intrinsic Z, X, Y; right-handed)</source>
        <translation>notes d&apos;application de NovAtel sur les rotations (intrinsèques Z, X, Y ; sens direct)</translation>
    </message>
    <message>
        <source>StripAdjust documentation (body axes, mounting permutation, degrees)</source>
        <translation>documentation de StripAdjust (axes du corps, permutation de montage, degrés)</translation>
    </message>
    <message>
        <source>PDAL&apos;s code (georeference filter, coordinate_system NED)</source>
        <translation>code de PDAL (filtre georeference, coordinate_system NED)</translation>
    </message>
    <message>
        <source>StripAlign manual, for the columns of the trajectory only</source>
        <translation>manuel de StripAlign, pour les seules colonnes de la trajectoire</translation>
    </message>
    <message>
        <source>TerraScan user guide, scanner systems (lever arm axes)</source>
        <translation>guide de TerraScan, systèmes de scanneur (axes du bras de levier)</translation>
    </message>
    <message>
        <source>Phoenix LiDAR user manual (turns about fixed IMU X, Y, Z in that order)</source>
        <translation>manuel de Phoenix LiDAR (rotations autour des axes fixes X, Y, Z de l&apos;IMU, dans cet ordre)</translation>
    </message>
    <message>
        <source>Phoenix LiDAR user manual (vehicle frame X right, Y up, Z rear)</source>
        <translation>manuel de Phoenix LiDAR (repère du véhicule : X à droite, Y en haut, Z à l&apos;arrière)</translation>
    </message>
    <message>
        <source>secondary descriptions of the offsets</source>
        <translation>descriptions de seconde main des décalages</translation>
    </message>
    <message>
        <source>nothing public was found</source>
        <translation>rien de public n&apos;a été trouvé</translation>
    </message>
    <message>
        <source>Assumed</source>
        <translation>Supposé</translation>
    </message>
    <message>
        <source>The signs are those of the manual; the order of the rotations was not found and is taken as heading, pitch, roll, and offsets as X starboard, Y forward, Z up.</source>
        <translation>Les signes sont ceux du manuel ; l&apos;ordre des rotations n&apos;a pas été trouvé et est pris comme cap, tangage, roulis, et les décalages comme X tribord, Y avant, Z haut.</translation>
    </message>
    <message>
        <source>Axes, order and signs are those of the application note, which states them for the turn from vehicle to IMU; the scanner is taken in the place of the IMU. SPAN on OEM7 states the vehicle rotation (RBV) the other way, from the IMU to the vehicle.</source>
        <translation>Axes, ordre et signes sont ceux de la note d&apos;application, qui les donne pour la rotation du véhicule à l&apos;IMU ; le scanneur est pris à la place de l&apos;IMU. SPAN sur OEM7 donne la rotation du véhicule (RBV) dans l&apos;autre sens, de l&apos;IMU au véhicule.</translation>
    </message>
    <message>
        <source>The order is taken as yaw, pitch, roll and the signs as right-handed, applied after the mounting; neither was checked.</source>
        <translation>L&apos;ordre est pris comme lacet, tangage, roulis et les signes comme directs, appliqués après le montage ; ni l&apos;un ni les autres n&apos;ont été vérifiés.</translation>
    </message>
    <message>
        <source>How boresight angles are stated was not found; they are taken as the NED attitude of the trajectory: yaw, pitch, roll about Z down, Y starboard, X forward. The ENU default is not offered.</source>
        <translation>La façon d&apos;indiquer les angles de visée n&apos;a pas été trouvée ; ils sont pris comme l&apos;attitude NED de la trajectoire : lacet, tangage, roulis autour de Z bas, Y tribord, X avant. La valeur par défaut ENU n&apos;est pas offerte.</translation>
    </message>
    <message>
        <source>Only the axes of the lever arm are documented; the angles are taken as heading, pitch, roll, with roll positive starboard side down, pitch bow up, heading clockwise.</source>
        <translation>Seuls les axes du bras de levier sont documentés ; les angles sont pris comme cap, tangage, roulis, le roulis étant positif quand tribord descend, le tangage quand l&apos;étrave monte, le cap dans le sens horaire.</translation>
    </message>
    <message>
        <source>Order and signs are those of the manual, but the axes depend on the IMU: state where its X, Y and Z point on the vessel.</source>
        <translation>Ordre et signes sont ceux du manuel, mais les axes dépendent de l&apos;IMU : indiquez vers où pointent ses axes X, Y et Z sur le navire.</translation>
    </message>
    <message>
        <source>Nothing was stated, so they are taken as {axes}.</source>
        <translation>Rien n&apos;a été indiqué : ils sont pris comme {axes}.</translation>
    </message>
    <message>
        <source>Axes were stated that are not those of its documentation.</source>
        <translation>Des axes ont été indiqués qui ne sont pas ceux de sa documentation.</translation>
    </message>
    <message>
        <source>The axes are those of the manual; the order of the turns is that of version 6 and was not found for these versions.</source>
        <translation>Les axes sont ceux du manuel ; l&apos;ordre des rotations est celui de la version 6 et n&apos;a pas été trouvé pour ces versions.</translation>
    </message>
    <message>
        <source>Roll is taken as positive starboard side down, pitch as positive bow up and the order as yaw, pitch, roll; none of it was found. The axes X starboard, Y forward, Z down are left-handed.</source>
        <translation>Le roulis est pris comme positif quand tribord descend, le tangage comme positif quand l&apos;étrave monte et l&apos;ordre comme lacet, tangage, roulis ; rien de cela n&apos;a été trouvé. Les axes X tribord, Y avant, Z bas forment un repère indirect.</translation>
    </message>
    <message>
        <source>RiPROCESS is not offered as angles, because neither its axes nor their order were found. The matrix is in this program&apos;s frames: scanner to body, X forward, Y port, Z up.</source>
        <translation>Pour RiPROCESS, aucun angle n&apos;est offert, car ni ses axes ni leur ordre n&apos;ont été trouvés. La matrice est dans les repères de ce programme : du scanneur au navire, X avant, Y bâbord, Z haut.</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>taken as a matrix only</source>
        <translation>donnée comme matrice seulement</translation>
    </message>
    <message>
        <source>{first} · {second} · {third}, LiDAR to body</source>
        <translation>{first} · {second} · {third}, du LiDAR au navire</translation>
    </message>
    <message>
        <source>{first} · {second} · {third}, body to LiDAR</source>
        <translation>{first} · {second} · {third}, du navire au LiDAR</translation>
    </message>
    <message>
        <source>Rz(yaw)</source>
        <translation>Rz(lacet)</translation>
    </message>
    <message>
        <source>Rz(−yaw)</source>
        <translation>Rz(−lacet)</translation>
    </message>
    <message>
        <source>Rz(heading)</source>
        <translation>Rz(cap)</translation>
    </message>
    <message>
        <source>Rz(−heading)</source>
        <translation>Rz(−cap)</translation>
    </message>
    <message>
        <source>Ry(pitch)</source>
        <translation>Ry(tangage)</translation>
    </message>
    <message>
        <source>Rx(pitch)</source>
        <translation>Rx(tangage)</translation>
    </message>
    <message>
        <source>Rx(−pitch)</source>
        <translation>Rx(−tangage)</translation>
    </message>
    <message>
        <source>Rx(roll)</source>
        <translation>Rx(roulis)</translation>
    </message>
    <message>
        <source>Ry(roll)</source>
        <translation>Ry(roulis)</translation>
    </message>
    <message>
        <source>Ry(−roll)</source>
        <translation>Ry(−roulis)</translation>
    </message>
    <message>
        <source>Rx(X rotation)</source>
        <translation>Rx(rotation X)</translation>
    </message>
    <message>
        <source>Ry(Y rotation)</source>
        <translation>Ry(rotation Y)</translation>
    </message>
    <message>
        <source>Rz(Z rotation)</source>
        <translation>Rz(rotation Z)</translation>
    </message>
    <message>
        <source>heading</source>
        <translation>cap</translation>
    </message>
    <message>
        <source>X rotation</source>
        <translation>Rotation X</translation>
    </message>
    <message>
        <source>Y rotation</source>
        <translation>Rotation Y</translation>
    </message>
    <message>
        <source>Z rotation</source>
        <translation>Rotation Z</translation>
    </message>
    <message>
        <source>Body axes</source>
        <translation>Axes du navire</translation>
    </message>
    <message>
        <source>Scanner axes</source>
        <translation>Axes du scanneur</translation>
    </message>
    <message>
        <source>X {x}, Y {y}, Z {z}</source>
        <translation>X {x}, Y {y}, Z {z}</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>avant</translation>
    </message>
    <message>
        <source>aft</source>
        <translation>arrière</translation>
    </message>
    <message>
        <source>port</source>
        <translation>bâbord</translation>
    </message>
    <message>
        <source>starboard</source>
        <translation>tribord</translation>
    </message>
    <message>
        <source>up</source>
        <translation>haut</translation>
    </message>
    <message>
        <source>down</source>
        <translation>bas</translation>
    </message>
    <message>
        <source>The scanner&apos;s axes point: {axes}.</source>
        <translation>Les axes du scanneur pointent : {axes}.</translation>
    </message>
    <message>
        <source>The scanner&apos;s axes point: {axes}, off by {off:n} deg at most.</source>
        <translation>Les axes du scanneur pointent : {axes}, à {off} deg près.</translation>
    </message>
    <message>
        <source>The scanner&apos;s axes are named as the body&apos;s: angles of zero mean parallel.</source>
        <translation>Les axes du scanneur portent les noms de ceux du navire : des angles nuls signifient parallèles.</translation>
    </message>
    <message>
        <source>The scanner&apos;s axes stay those of the raw points.</source>
        <translation>Les axes du scanneur restent ceux des points bruts.</translation>
    </message>
    <message>
        <source>An axis permutation (mounting) first lays the raw scanner axes on the body&apos;s; the angles hold the rest.</source>
        <translation>Une permutation d&apos;axes (montage) amène d&apos;abord les axes bruts du scanneur sur ceux du navire ; les angles contiennent le reste.</translation>
    </message>
    <message>
        <source>Mounting here: scanner {axes}.</source>
        <translation>Montage ici : scanneur {axes}.</translation>
    </message>
    <message>
        <source>Lever arm</source>
        <translation>Bras de levier</translation>
    </message>
    <message>
        <source>X {x:n} m, Y {y:n} m, Z {z:n} m: LiDAR optical centre from the POS centre</source>
        <translation>X {x} m, Y {y} m, Z {z} m : centre optique du LiDAR depuis le centre du POS</translation>
    </message>
    <message>
        <source>These angles are right if the assumption above is: prove it on one line over a known surface before use.</source>
        <translation>Ces angles sont justes si la supposition ci-dessus l&apos;est : prouvez-la sur une ligne devant une surface connue avant de les employer.</translation>
    </message>
    <message>
        <source>The {middle} is at {pole:n} deg, where {first} and {last} turn about the same axis: {last_again} is set to zero and {first_again} holds both.</source>
        <translation>{middle} à {pole}° : là, {first} et {last} tournent autour du même axe ; valeur mise à zéro : {last_again}, valeur contenant les deux : {first_again}.</translation>
    </message>
    <message>
        <source>The {middle} is within 10 deg of 90 deg: {first} and {last} change much for a small turn, so type all digits.</source>
        <translation>{middle} à moins de 10° de 90° : {first} et {last} changent beaucoup pour une petite rotation, saisissez donc tous les chiffres.</translation>
    </message>
    <message>
        <source>Sigmas have no meaning there.</source>
        <translation>Les écarts-types n&apos;y ont pas de sens.</translation>
    </message>
    <message>
        <source>The boresight holds together with {offsets:list}: apply that there too.</source>
        <translation>Les angles de visée valent avec {offsets} : appliquez-le là aussi.</translation>
    </message>
    <message>
        <source>range offset {n:n} m</source>
        <translation>un décalage de distance de {n} m</translation>
    </message>
    <message>
        <source>scan-angle offset {n:n} deg</source>
        <translation>un décalage d&apos;angle de balayage de {n}°</translation>
    </message>
    <message>
        <source>latency {n:n} ms</source>
        <translation>une latence de {n} ms</translation>
    </message>
    <message>
        <source>The POS errors were taken as uncorrelated: these sigmas are several times too small.</source>
        <translation>Les erreurs du POS ont été prises comme non corrélées : ces écarts-types sont plusieurs fois trop petits.</translation>
    </message>
    <message>
        <source>Scanner X</source>
        <translation>Scanneur X</translation>
    </message>
    <message>
        <source>Scanner Y</source>
        <translation>Scanneur Y</translation>
    </message>
    <message>
        <source>Scanner Z</source>
        <translation>Scanneur Z</translation>
    </message>
    <message>
        <source>Lever arm (m)</source>
        <translation>Bras de levier (m)</translation>
    </message>
    <message>
        <source>Matrix from scanner to body for {name:kept}</source>
        <translation>Matrice du scanneur au navire pour {name}</translation>
    </message>
    <message>
        <source>Rows: the body&apos;s X {x}, Y {y}, Z {z}, and the last row of any 4x4 matrix. The first three columns of the first three rows are the 3x3 rotation.</source>
        <translation>Rangées : X {x}, Y {y}, Z {z} du navire, et la dernière rangée de toute matrice 4x4. Les trois premières colonnes des trois premières rangées sont la rotation 3x3.</translation>
    </message>
</context>
<context>
    <name>absolute</name>
    <message>
        <source>Absolute check</source>
        <translation>Contrôle absolu</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Référence</translation>
    </message>
    <message>
        <source>Signed distances of the lines from {reference} ({what}, in {system:kept}) along the normal, positive where a line lies nearer to the vessel, at the same places before and after the calibration and no farther than {reach:n} m from it.</source>
        <translation>Distances signées des lignes à {reference} ({what}, en {system}) le long de la normale, positives là où une ligne est plus près du navire, aux mêmes endroits avant et après l&apos;étalonnage et à {reach} m au plus.</translation>
    </message>
    <message>
        <source>Signed distances of the lines from {reference} ({what}, in the local frame) along the normal, positive where a line lies nearer to the vessel, at the same places before and after the calibration and no farther than {reach:n} m from it.</source>
        <translation>Distances signées des lignes à {reference} ({what}, dans le repère local) le long de la normale, positives là où une ligne est plus près du navire, aux mêmes endroits avant et après l&apos;étalonnage et à {reach} m au plus.</translation>
    </message>
    <message>
        <source>static scan</source>
        <translation>balayage statique</translation>
    </message>
    <message>
        <source>surveyed points</source>
        <translation>points levés</translation>
    </message>
    <message>
        <source>Distances of all lines from the reference, before and after.</source>
        <translation>Distances de toutes les lignes à la référence, avant et après.</translation>
    </message>
    <message>
        <source>POS: by the stated accuracies, one error for all that a line saw. Scatter: of the places about the mean of their line, averaged. What the ranges have in common, a range offset for one, is not in the sum.</source>
        <translation>POS : d&apos;après les précisions déclarées, une seule erreur pour tout ce qu&apos;une ligne a vu. Dispersion : celle des endroits autour de la moyenne de leur ligne, moyennée. Ce que les distances mesurées ont en commun, un décalage de distance par exemple, n&apos;est pas dans la somme.</translation>
    </message>
    <message>
        <source>Not compared:</source>
        <translation>Non comparés :</translation>
    </message>
    <message>
        <source>95 % of
the mean</source>
        <translation>95 % de la
moyenne</translation>
    </message>
    <message>
        <source>Mean
differs</source>
        <translation>Moyenne
différente</translation>
    </message>
    <message>
        <source>Distances of the lines from the reference (mm)</source>
        <translation>Distances des lignes à la référence (mm)</translation>
    </message>
    <message>
        <source>all lines</source>
        <translation>toutes les lignes</translation>
    </message>
    <message>
        <source>all lines, along the normal</source>
        <translation>toutes les lignes, le long de la normale</translation>
    </message>
    <message>
        <source>POS
position</source>
        <translation>Position
du POS</translation>
    </message>
    <message>
        <source>POS
attitude</source>
        <translation>Attitude
du POS</translation>
    </message>
    <message>
        <source>Scatter</source>
        <translation>Dispersion</translation>
    </message>
    <message>
        <source>Together</source>
        <translation>Ensemble</translation>
    </message>
    <message>
        <source>RMS
expected</source>
        <translation>RMS
attendue</translation>
    </message>
    <message>
        <source>Share of the RMS
by the reference</source>
        <translation>Part de la RMS due
à la référence</translation>
    </message>
    <message>
        <source>What the mean after may be off by, 1 sigma (mm)</source>
        <translation>Erreur possible de la moyenne après, 1 sigma (mm)</translation>
    </message>
    <message>
        <source>Surveyed points and planes, on the mean of the lines (mm)</source>
        <translation>Points et plans levés, en moyenne des lignes (mm)</translation>
    </message>
    <message>
        <source>Sigma</source>
        <translation>Écart-type</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Après</translation>
    </message>
    <message>
        <source>After over
its sigma</source>
        <translation>Après /
écart-type</translation>
    </message>
    <message>
        <source>Distance from the reference (mm), positive towards the vessel; the end bins hold all beyond</source>
        <translation>Distance à la référence (mm), positive vers le navire ; les classes extrêmes contiennent le reste</translation>
    </message>
    <message>
        <source>After the calibration all lines together lie {off:n} mm nearer to the vessel than the reference on the mean, ± {half:n} mm (95 %): {verdict}.</source>
        <translation>Après l&apos;étalonnage, l&apos;ensemble des lignes est en moyenne {off} mm plus près du navire que la référence, ± {half} mm (95 %) : {verdict}.</translation>
    </message>
    <message>
        <source>After the calibration all lines together lie {off:n} mm farther from the vessel than the reference on the mean, ± {half:n} mm (95 %): {verdict}.</source>
        <translation>Après l&apos;étalonnage, l&apos;ensemble des lignes est en moyenne {off} mm plus loin du navire que la référence, ± {half} mm (95 %) : {verdict}.</translation>
    </message>
    <message>
        <source>Before, they lay {off:n} mm nearer to the vessel than the reference on the mean, ± {half:n} mm (95 %): {verdict}; nothing is known of the uncertainty of the prior boresight, so it is not counted here.</source>
        <translation>Avant, il était {off} mm plus près du navire que la référence, ± {half} mm (95 %) : {verdict} ; rien n&apos;est connu de l&apos;incertitude des angles de visée a priori, elle n&apos;est donc pas comptée ici.</translation>
    </message>
    <message>
        <source>Before, they lay {off:n} mm farther from the vessel than the reference on the mean, ± {half:n} mm (95 %): {verdict}; nothing is known of the uncertainty of the prior boresight, so it is not counted here.</source>
        <translation>Avant, il était {off} mm plus loin du navire que la référence, ± {half} mm (95 %) : {verdict} ; rien n&apos;est connu de l&apos;incertitude des angles de visée a priori, elle n&apos;est donc pas comptée ici.</translation>
    </message>
    <message>
        <source>more than reference, POS and boresight explain</source>
        <translation>plus que n&apos;expliquent la référence, le POS et les angles de visée</translation>
    </message>
    <message>
        <source>no more than reference, POS and boresight explain</source>
        <translation>pas plus que n&apos;expliquent la référence, le POS et les angles de visée</translation>
    </message>
    <message>
        <source>The RMS of all distances is {before:n} mm before and {after:n} mm after. Of the latter the reference&apos;s own uncertainty ({sigma:n} mm) explains {share:n} %; reference, POS and boresight together let one expect {expected:n} mm.</source>
        <translation>La RMS de toutes les distances est de {before} mm avant et de {after} mm après. De cette dernière, l&apos;incertitude propre de la référence ({sigma} mm) explique {share} % ; la référence, le POS et les angles de visée ensemble laissent attendre {expected} mm.</translation>
    </message>
    <message>
        <source>After the calibration no single line is off by more than its own errors explain.</source>
        <translation>Après l&apos;étalonnage, aucune ligne ne s&apos;écarte plus que ne l&apos;expliquent ses propres erreurs.</translation>
    </message>
    <message>
        <source>After the calibration 1 of {all:n} lines is off by more than its own errors explain, positive towards the vessel: {lines:list}.</source>
        <translation>Après l&apos;étalonnage, 1 ligne sur {all} s&apos;écarte plus que ne l&apos;expliquent ses propres erreurs, positif vers le navire : {lines}.</translation>
    </message>
    <message>
        <source>After the calibration the mean of the lines is off surveyed points or planes by more than reference, POS and boresight explain ({some:n} of {all:n}), positive towards the vessel: {points:list}.</source>
        <translation>Après l&apos;étalonnage, la moyenne des lignes s&apos;écarte de points ou plans levés plus que ne l&apos;expliquent référence, POS et angles de visée ({some} sur {all}), positif vers le navire : {points}.</translation>
    </message>
    <message>
        <source>One in twenty is by chance.</source>
        <translation>Un cas sur vingt est dû au hasard.</translation>
    </message>
    <message>
        <source>Against the reference the distances have an RMS of {found:n} mm after the calibration, {times:n} times the {expected:n} mm that reference, POS and boresight let one expect. See the section on the absolute check.</source>
        <translation>Par rapport à la référence, les distances ont une RMS de {found} mm après l&apos;étalonnage, soit {times} fois les {expected} mm auxquels référence, POS et angles de visée laissent s&apos;attendre. Voir la section sur le contrôle absolu.</translation>
    </message>
    <message>
        <source>Checked against {reference:kept}: {said}</source>
        <translation>Contrôle par {reference} : {said}</translation>
    </message>
    <message>
        <source>After the calibration {some:n} of {all:n} lines are off by more than their own errors explain, positive towards the vessel: {lines:list}.</source>
        <translation>Après l&apos;étalonnage, {some} lignes sur {all} s&apos;écartent plus que ne l&apos;expliquent leurs propres erreurs, positif vers le navire : {lines}.</translation>
    </message>
    <message>
        <source>{line} ({off:n} mm, ± {half:n} mm)</source>
        <translation>{line} ({off} mm, ± {half} mm)</translation>
    </message>
    <message>
        <source>The reference sigma counts as one error that all points of the scan share, such as that of its registration; the noise of its single points averages out.</source>
        <translation>L&apos;écart-type de la référence compte comme une erreur commune à tous les points du balayage, celle de son recalage par exemple ; le bruit de ses points se compense.</translation>
    </message>
    <message>
        <source>Of all lines together, means and RMS count each line alike, however many places it has: its places share its POS error. Medians and percentiles are of all places.</source>
        <translation>Pour l&apos;ensemble des lignes, moyennes et RMS comptent chaque ligne autant, quel que soit son nombre d&apos;endroits : ses endroits partagent son erreur POS. Médianes et percentiles sont de tous les endroits.</translation>
    </message>
    <message>
        <source>Another surface lies behind or before the one measured, within {reach:n} m of the reference: {lines:list}. The nearest to the reference was taken; of a line that is off by more than half that distance it would be the wrong one.</source>
        <translation>Une autre surface se trouve derrière ou devant celle qui a été mesurée, à {reach} m au plus de la référence : {lines}. La plus proche de la référence a été retenue ; pour une ligne écartée de plus de la moitié de cette distance, ce ne serait pas la bonne.</translation>
    </message>
    <message>
        <source>{line} ({some:n} of {all:n} places, {off:n} m away)</source>
        <translation>{line} ({some} endroits sur {all}, à {off} m)</translation>
    </message>
    <message>
        <source>This check is of an earlier version, which took the mean of all surfaces within reach: where a wall stands behind what the reference shows, it is wrong. Repeat it.</source>
        <translation>Ce contrôle vient d&apos;une version antérieure, qui prenait la moyenne de toutes les surfaces à portée : là où un mur se trouve derrière ce que montre la référence, il est faux. Refaites-le.</translation>
    </message>
    <message>
        <source>Each surveyed point counts with an error of its own.</source>
        <translation>Chaque point levé compte avec sa propre erreur.</translation>
    </message>
    <message>
        <source>No line has a flat place within {reach:n} m of {points:kept}.</source>
        <translation>Aucune ligne n&apos;a d&apos;endroit plan à moins de {reach} m de {points}.</translation>
    </message>
    <message>
        <source>No surveyed point has a flat place of the line in front of it.</source>
        <translation>Aucun point levé n&apos;a devant lui d&apos;endroit plan de la ligne.</translation>
    </message>
    <message>
        <source>No place of the reference is seen before and after the calibration.</source>
        <translation>Aucun endroit de la référence n&apos;est vu avant et après l&apos;étalonnage.</translation>
    </message>
    <message>
        <source>No place has {points:n} points of both clouds within a cylinder of {diameter:n} m; choose a wider one.</source>
        <translation>Aucun endroit n&apos;a {points} points des deux nuages dans un cylindre de {diameter} m ; choisissez-en un plus large.</translation>
    </message>
    <message>
        <source>no surveyed point has a flat place of this line within {reach:n} m before and after the calibration; survey points where it is denser, or widen the reach</source>
        <translation>aucun point levé n&apos;a d&apos;endroit plan de cette ligne à moins de {reach} m avant et après l&apos;étalonnage ; levez des points là où elle est plus dense, ou élargissez la portée</translation>
    </message>
    <message>
        <source>the reference has no flat place within {reach:n} m of this line; scan what it has seen, or widen the reach</source>
        <translation>la référence n&apos;a aucun endroit plan à moins de {reach} m de cette ligne ; balayez ce qu&apos;elle a vu, ou élargissez la portée</translation>
    </message>
    <message>
        <source>{count:n} of {tried:n} flat places of the reference within {reach:n} m of this line have enough of its points before and after the calibration, and {least:n} must; scan more of what it has seen and where it is denser, or widen the reach</source>
        <translation>{count} des {tried} endroits plans de la référence à moins de {reach} m de cette ligne ont assez de ses points avant et après l&apos;étalonnage, et il en faut {least} ; balayez davantage de ce qu&apos;elle a vu et là où elle est plus dense, ou élargissez la portée</translation>
    </message>
</context>
<context>
    <name>maps</name>
    <message>
        <source>{plane}: distance of the first line from the second along the normal, over the plane as seen from the vessel; red where the first is nearer, blue where it is farther, grey where one of them has too few points.</source>
        <translation>{plane} : distance de la première ligne à la seconde le long de la normale, sur le plan vu du navire ; en rouge là où la première est plus près, en bleu là où elle est plus loin, en gris là où l&apos;une d&apos;elles a trop peu de points.</translation>
    </message>
    <message>
        <source>after, own scale</source>
        <translation>après, échelle propre</translation>
    </message>
    <message>
        <source>from</source>
        <translation>par rapport à</translation>
    </message>
    <message>
        <source>Across (m)</source>
        <translation>En largeur (m)</translation>
    </message>
    <message>
        <source>Up (m)</source>
        <translation>Haut (m)</translation>
    </message>
    <message>
        <source>Before (mm)</source>
        <translation>Avant (mm)</translation>
    </message>
    <message>
        <source>After (mm)</source>
        <translation>Après (mm)</translation>
    </message>
    <message>
        <source>no map; validate again</source>
        <translation>pas de carte ; validez de nouveau</translation>
    </message>
    <message>
        <source>Map of {plane:name}, {first:name} from {second:name}</source>
        <translation>Carte de {plane}, {first} depuis {second}</translation>
    </message>
</context>
<context>
    <name>budget</name>
    <message>
        <source>What the error budget rests on:</source>
        <translation>Ce sur quoi repose le bilan d&apos;erreurs :</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Horizontal
at {distance:n} m</source>
        <translation>Horiz.
à {distance} m</translation>
    </message>
    <message>
        <source>Vertical
at {distance:n} m</source>
        <translation>Vert.
à {distance} m</translation>
    </message>
    <message>
        <source>Across
at {distance:n} m</source>
        <translation>Transv.
à {distance} m</translation>
    </message>
    <message>
        <source>Error of a point, 1 sigma, beam {beam} (cm)</source>
        <translation>Erreur d&apos;un point, 1 sigma, faisceau {beam} (cm)</translation>
    </message>
    <message>
        <source>level to starboard</source>
        <translation>horizontal vers tribord</translation>
    </message>
    <message>
        <source>45 deg up to starboard</source>
        <translation>à 45° vers le haut sur tribord</translation>
    </message>
    <message>
        <source>GNSS position</source>
        <translation>Position GNSS</translation>
    </message>
    <message>
        <source>POS roll</source>
        <translation>Roulis du POS</translation>
    </message>
    <message>
        <source>POS pitch</source>
        <translation>Tangage du POS</translation>
    </message>
    <message>
        <source>POS heading</source>
        <translation>Cap du POS</translation>
    </message>
    <message>
        <source>LiDAR range</source>
        <translation>Distance du LiDAR</translation>
    </message>
    <message>
        <source>LiDAR beam angle</source>
        <translation>Angle du faisceau LiDAR</translation>
    </message>
    <message>
        <source>LiDAR noise</source>
        <translation>Bruit du LiDAR</translation>
    </message>
    <message>
        <source>Boresight before</source>
        <translation>Angles de visée avant</translation>
    </message>
    <message>
        <source>Boresight after</source>
        <translation>Angles de visée après</translation>
    </message>
    <message>
        <source>All together, before</source>
        <translation>Tout ensemble, avant</translation>
    </message>
    <message>
        <source>All together, after</source>
        <translation>Tout ensemble, après</translation>
    </message>
    <message>
        <source>Standard deviations of a point as seen from a vessel that sails north, level; distances are from the scanner. Horizontal and across the beam are the root of the sum of squares of two directions.</source>
        <translation>Écarts-types d&apos;un point vu d&apos;un navire qui fait route au nord, à l&apos;horizontale ; les distances sont comptées du scanneur. L&apos;erreur horizontale et l&apos;erreur transversale au faisceau sont la racine de la somme des carrés de deux directions.</translation>
    </message>
    <message>
        <source>POS: median of the accuracies on the lines, {north:n}, {east:n}, {up:n} mm (north, east, up) and {roll:n}, {pitch:n}, {heading:n} deg (roll, pitch, heading).</source>
        <translation>POS : médiane des précisions sur les lignes, {north}, {east}, {up} mm (nord, est, haut) et {roll}, {pitch}, {heading}° (roulis, tangage, cap).</translation>
    </message>
    <message>
        <source>Boresight before is no standard deviation but by how much the prior angles put the point elsewhere than the estimated ones; boresight after is by their covariance.</source>
        <translation>« Angles de visée avant » n&apos;est pas un écart-type, mais de combien les angles a priori placent le point ailleurs que les angles estimés ; « Angles de visée après » vient de leur covariance.</translation>
    </message>
    <message>
        <source>The LiDAR noise is stated on each axis alike; stated of range and beam it would grow with the distance.</source>
        <translation>Le bruit du LiDAR est déclaré égal sur chaque axe ; déclaré pour la distance et le faisceau, il croîtrait avec la distance.</translation>
    </message>
    <message>
        <source>The lever arm counts by what of it was estimated, with its covariance.</source>
        <translation>Le bras de levier compte pour ce qui en a été estimé, avec sa covariance.</translation>
    </message>
    <message>
        <source>How well the lever arm is known is not stated, so that it is not counted.</source>
        <translation>La précision du bras de levier n&apos;est pas déclarée ; il n&apos;est donc pas compté.</translation>
    </message>
    <message>
        <source>Latency: at the speed of the lines, {speed:n} m/s, and their RMS turning, {roll:n}, {pitch:n}, {heading:n} deg/s (roll, pitch, heading).</source>
        <translation>Latence : à la vitesse des lignes, {speed} m/s, et à leur vitesse de rotation RMS, {roll}, {pitch}, {heading}°/s (roulis, tangage, cap).</translation>
    </message>
    <message>
        <source>A latency was not estimated and is not counted.</source>
        <translation>La latence n&apos;a pas été estimée et n&apos;est pas comptée.</translation>
    </message>
    <message>
        <source>Trajectory on each line</source>
        <translation>Trajectoire de chaque ligne</translation>
    </message>
    <message>
        <source>Duration
(s)</source>
        <translation>Durée
(s)</translation>
    </message>
    <message>
        <source>Speed
(m/s)</source>
        <translation>Vitesse
(m/s)</translation>
    </message>
    <message>
        <source>Interval
(s)</source>
        <translation>Intervalle
(s)</translation>
    </message>
    <message>
        <source>Longest
gap (s)</source>
        <translation>Plus longue
lacune (s)</translation>
    </message>
    <message>
        <source>Horizontal
(mm)</source>
        <translation>Horizontal
(mm)</translation>
    </message>
    <message>
        <source>Vertical
(mm)</source>
        <translation>Vertical
(mm)</translation>
    </message>
    <message>
        <source>Roll, pitch
(deg)</source>
        <translation>Roulis, tangage
(°)</translation>
    </message>
    <message>
        <source>Roll and pitch: by how much the vessel moved (standard deviation).</source>
        <translation>Roulis et tangage : mouvement du navire (écart-type).</translation>
    </message>
    <message>
        <source>The last four columns are the largest stated 1 sigma of the POS on the line.</source>
        <translation>Les quatre dernières colonnes donnent le plus grand écart-type déclaré du POS sur la ligne.</translation>
    </message>
    <message>
        <source>Histogram of {plane:name}</source>
        <translation>Histogramme de {plane}</translation>
    </message>
    <message>
        <source>{plane:name} against height</source>
        <translation>{plane} selon la hauteur</translation>
    </message>
    <message>
        <source>{plane:name} against range</source>
        <translation>{plane} selon la distance au scanneur</translation>
    </message>
    <message>
        <source>From (mm)</source>
        <translation>De (mm)</translation>
    </message>
    <message>
        <source>To (mm)</source>
        <translation>À (mm)</translation>
    </message>
    <message>
        <source>From (m)</source>
        <translation>De (m)</translation>
    </message>
    <message>
        <source>To (m)</source>
        <translation>À (m)</translation>
    </message>
    <message>
        <source>and beyond</source>
        <translation>et au-delà</translation>
    </message>
    <message>
        <source>Points before</source>
        <translation>Points avant</translation>
    </message>
    <message>
        <source>Points after</source>
        <translation>Points après</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Distances</translation>
    </message>
    <message>
        <source>Median before (mm)</source>
        <translation>Médiane avant (mm)</translation>
    </message>
    <message>
        <source>Median after (mm)</source>
        <translation>Médiane après (mm)</translation>
    </message>
    <message>
        <source>95 % before (mm)</source>
        <translation>95 % avant (mm)</translation>
    </message>
    <message>
        <source>95 % after (mm)</source>
        <translation>95 % après (mm)</translation>
    </message>
</context>
<context>
    <name>older</name>
    <message>
        <source>An estimate asked for after this one was refused: {reason} The angles are those of the estimate before.</source>
        <translation>Une estimation demandée après celle-ci a été refusée : {reason} Les angles sont ceux de l&apos;estimation précédente.</translation>
    </message>
</context>
<context>
    <name>second opinions</name>
    <message>
        <source>natural planes</source>
        <translation>plans naturels</translation>
    </message>
    <message>
        <source>targetless</source>
        <translation>sans cible</translation>
    </message>
    <message>
        <source>patch test</source>
        <translation>patch test</translation>
    </message>
    <message>
        <source>the same adjustment on the validation planes instead of the targets</source>
        <translation>la même compensation sur les plans de validation à la place des cibles</translation>
    </message>
    <message>
        <source>surfaces of the scene that no one picked</source>
        <translation>surfaces de la scène que personne n’a choisies</translation>
    </message>
    <message>
        <source>lines turned until they meet on objects</source>
        <translation>lignes tournées jusqu’à ce qu’elles coïncident sur des objets</translation>
    </message>
    <message>
        <source>{a} and {b} agree: a point {n:n} m away moves by {d:n} cm.</source>
        <translation>{a} et {b} concordent : un point à {n} m se déplace de {d} cm.</translation>
    </message>
    <message>
        <source>{a} and {b} differ by more than their sigmas explain, in {angles:list}: a point {n:n} m away moves by {d:n} cm.</source>
        <translation>{a} et {b} diffèrent de plus que leurs sigmas n’expliquent, en {angles} : un point à {n} m se déplace de {d} cm.</translation>
    </message>
    <message>
        <source>{a} and {b} differ by more than their sigmas explain, all angles together: a point {n:n} m away moves by {d:n} cm.</source>
        <translation>{a} et {b} diffèrent de plus que leurs sigmas n’expliquent, tous angles ensemble : un point à {n} m se déplace de {d} cm.</translation>
    </message>
    <message>
        <source>All methods rest on the same lines. What an error of the trajectory does to all of them alike no comparison shows, and as they share it, their difference is judged by more than its own sigma: where they differ, something is wrong; that they agree is no proof.</source>
        <translation>Toutes les méthodes reposent sur les mêmes lignes. Ce qu’une erreur de trajectoire fait à toutes de la même façon, aucune comparaison ne le montre ; et comme elles la partagent, leur écart est jugé sur plus que son propre sigma : là où elles diffèrent, quelque chose ne va pas ; qu’elles concordent ne prouve rien.</translation>
    </message>
    <message>
        <source>{project:name}: at least two validation planes that two lines see are needed; pick more of them, facing different ways.</source>
        <translation>{project} : il faut au moins deux plans de validation vus par deux lignes ; en choisir d’autres, d’orientations différentes.</translation>
    </message>
    <message>
        <source>Natural planes</source>
        <translation>Plans naturels</translation>
    </message>
    <message>
        <source>Targetless</source>
        <translation>Sans cible</translation>
    </message>
    <message>
        <source>Patch test</source>
        <translation>Patch test</translation>
    </message>
    <message>
        <source>Alternative methods</source>
        <translation>Méthodes alternatives</translation>
    </message>
    <message>
        <source>What other methods say of the same lines: the validation planes adjusted as if they were targets (natural planes), surfaces of the scene that no one picked (targetless), lines turned until they meet on objects (patch test). The targets take part in none of them.</source>
        <translation>Ce que d’autres méthodes disent des mêmes lignes : les plans de validation compensés comme s’ils étaient des cibles (plans naturels), des surfaces de la scène que personne n’a choisies (sans cible), les lignes tournées jusqu’à ce qu’elles coïncident sur des objets (patch test). Les cibles n’ont part à aucune.</translation>
    </message>
    <message>
        <source>Natural planes: {remark}</source>
        <translation>Plans naturels : {remark}</translation>
    </message>
    <message>
        <source>Targetless: {remark}</source>
        <translation>Sans cible : {remark}</translation>
    </message>
    <message>
        <source>Patch test: {remark}</source>
        <translation>Patch test : {remark}</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Surfaces</translation>
    </message>
    <message>
        <source>The boresight by each method (deg)</source>
        <translation>Les angles de visée selon chaque méthode (deg)</translation>
    </message>
    <message>
        <source>Differences from the {what} (deg)</source>
        <translation>Écarts par rapport à : {what} (deg)</translation>
    </message>
    <message>
        <source>over its
sigma</source>
        <translation>sur son
sigma</translation>
    </message>
    <message>
        <source>Differs</source>
        <translation>Diffère</translation>
    </message>
</context>
</TS>
