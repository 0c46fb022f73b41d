<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR" sourcelanguage="en">
<context>
    <name>adjustment</name>
    <message>
        <source>Give the distances of the error budget in metres, each larger than 0.</source>
        <translation>Donnez les distances du bilan d&apos;erreur en mètres, chacune supérieure à 0.</translation>
    </message>
    <message>
        <source>A target&apos;s shape is not determined by its points; pick points that spread over it in two directions.</source>
        <translation>La forme d&apos;une cible n&apos;est pas déterminée par ses points ; désignez des points qui s&apos;y étendent dans deux directions.</translation>
    </message>
    <message>
        <source>No point of target {target:kept} agrees with the other targets and lines; pick the target again, or leave it out.</source>
        <translation>Aucun point de la cible {target} ne s&apos;accorde avec les autres cibles et lignes ; choisissez-la de nouveau ou écartez-la.</translation>
    </message>
    <message>
        <source>Target {target:kept} has only {count} points on line {line:kept}; a plane needs at least three: pick it again or leave that line out.</source>
        <translation>La cible {target} n&apos;a que {count} points sur la ligne {line} ; un plan en demande au moins trois : désignez-la de nouveau ou écartez cette ligne.</translation>
    </message>
    <message>
        <source>A {name} is not a number; leave that point out.</source>
        <translation>Valeur qui n&apos;est pas un nombre ({name}) ; écartez ce point.</translation>
    </message>
    <message>
        <source>A {name} sigma is negative or not a number; correct it.</source>
        <translation>Écart-type négatif ou qui n&apos;est pas un nombre ({name}) ; corrigez-le.</translation>
    </message>
    <message>
        <source>not tested: with uncorrelated POS errors the sigmas are too small</source>
        <translation>non testé : avec des erreurs du POS non corrélées les écarts-types sont trop petits</translation>
    </message>
    <message>
        <source>Target {target:kept} has only 1 points on line {line:kept}; a plane needs at least three: pick it again or leave that line out.</source>
        <translation>La cible {target} n&apos;a qu&apos;un point sur la ligne {line} ; un plan en demande au moins trois : désignez-la de nouveau ou écartez cette ligne.</translation>
    </message>
    <message>
        <source>Cross-checking: {what} {name:kept}</source>
        <translation>Vérification croisée : {what} {name}</translation>
    </message>
    <message>
        <source>Cross-checking: {what}</source>
        <translation>Vérification croisée : {what}</translation>
    </message>
    <message>
        <source>Adjusting: iteration {n:n}</source>
        <translation>Compensation : itération {n}</translation>
    </message>
    <message>
        <source>The targets face the same way, which no estimate accepts: pick another of another inclination.</source>
        <translation>Les cibles font face au même côté, ce qu&apos;aucune estimation n&apos;accepte : choisissez-en une d&apos;une autre inclinaison.</translation>
    </message>
    <message>
        <source>Leaving out parts of the data</source>
        <translation>Exclusion de parties des données</translation>
    </message>
    <message>
        <source>Cross-checking: half first</source>
        <translation>Vérification croisée : première moitié</translation>
    </message>
    <message>
        <source>Cross-checking: half second</source>
        <translation>Vérification croisée : seconde moitié</translation>
    </message>
</context>
<context>
    <name>design</name>
    <message>
        <source>As far as {len:n} surveys can tell, the stated 95 % intervals hold the truth as often as they should.</source>
        <translation>Pour autant que {len} levés puissent le dire, les intervalles à 95 % annoncés contiennent la vérité aussi souvent qu&apos;ils le devraient.</translation>
    </message>
    <message>
        <source>{failed} surveys could not be adjusted and are left out.</source>
        <translation>{failed} levés n&apos;ont pas pu être compensés et sont laissés de côté.</translation>
    </message>
    <message>
        <source>The adjustment can be told one flatness for all targets, and this plan states some of their own: let it be taken from the data.</source>
        <translation>La compensation ne peut recevoir qu&apos;une planéité pour toutes les cibles, et ce plan en déclare de particulières : laissez-la être tirée des données.</translation>
    </message>
    <message>
        <source>Adjusted {len:n} of {surveys:n} surveys</source>
        <translation>{len} levés compensés sur {surveys}</translation>
    </message>
    <message>
        <source>None of the simulated surveys could be adjusted; add lines or targets.</source>
        <translation>Aucun des levés simulés n&apos;a pu être compensé ; ajoutez des lignes ou des cibles.</translation>
    </message>
    <message>
        <source>the largest of the three sigmas</source>
        <translation>le plus grand des trois écarts-types</translation>
    </message>
    <message>
        <source>the sigma of roll</source>
        <translation>l&apos;écart-type du roulis</translation>
    </message>
    <message>
        <source>the sigma of pitch</source>
        <translation>l&apos;écart-type du tangage</translation>
    </message>
    <message>
        <source>the sigma of yaw</source>
        <translation>l&apos;écart-type du lacet</translation>
    </message>
    <message>
        <source>the root mean square of the three sigmas (A-optimality)</source>
        <translation>la moyenne quadratique des trois écarts-types (A-optimalité)</translation>
    </message>
    <message>
        <source>the radius of a ball as large as the confidence ellipsoid (D-optimality)</source>
        <translation>le rayon d&apos;une sphère aussi grande que l&apos;ellipsoïde de confiance (D-optimalité)</translation>
    </message>
    <message>
        <source>This plan does not determine the boresight; add lines in other directions.</source>
        <translation>Ce plan ne détermine pas les angles de visée ; ajoutez des lignes dans d&apos;autres directions.</translation>
    </message>
    <message>
        <source>No line sees a target: they look away from it, see it too obliquely or are too far off. Let lines pass on the side the targets face, within the scanner&apos;s range.</source>
        <translation>Aucune ligne ne voit de cible : elles regardent ailleurs, la voient trop obliquement ou sont trop loin. Faites passer les lignes du côté où les cibles font face, à portée du scanneur.</translation>
    </message>
    <message>
        <source>all six</source>
        <translation>les six</translation>
    </message>
    <message>
        <source>Scenarios done</source>
        <translation>Scénarios terminés</translation>
    </message>
    <message>
        <source>No plan within these limits determines the boresight. Boards over each other, lines nearer to the wall than allowed and targets that all face one way, which the adjustment refuses, are left out: allow more lines, other headings, or two boards of different inclinations.</source>
        <translation>Aucun plan dans ces limites ne détermine les angles de visée. Les panneaux qui se recouvrent, les lignes plus près du mur que permis et les cibles qui font toutes face au même côté, que la compensation refuse, sont exclus : permettez plus de lignes, d&apos;autres caps ou deux panneaux d&apos;inclinaisons différentes.</translation>
    </message>
    <message>
        <source>Weighing what each board and line is worth</source>
        <translation>Évaluation de ce que vaut chaque panneau et chaque ligne</translation>
    </message>
    <message>
        <source>Looked at {count:n} plans, the best {np:n} deg</source>
        <translation>{count} plans examinés, le meilleur à {np}°</translation>
    </message>
    <message>
        <source>A site needs at least two lines, and a board or a plane that is there anyway; raise the limits.</source>
        <translation>Un site demande au moins deux lignes, et un panneau ou un plan déjà en place ; relevez les limites.</translation>
    </message>
    <message>
        <source>Say where boards may hang, how inclined and how large.</source>
        <translation>Dites où des panneaux peuvent être posés, leur inclinaison et leur taille.</translation>
    </message>
    <message>
        <source>{lines} lines of {minutes_per_line:n} minutes and {boards} boards of {minutes_per_board:n} take {needed:n} minutes, longer than the {time_on_site:n} minutes on site; allow fewer, or more time.</source>
        <translation>{lines} lignes de {minutes_per_line} minutes et {boards} panneaux de {minutes_per_board} prennent {needed} minutes, plus que les {time_on_site} minutes sur place ; permettez-en moins, ou plus de temps.</translation>
    </message>
    <message>
        <source>No heading and distance keep {closest:n} m from the wall; allow others.</source>
        <translation>Aucun cap ni aucune distance ne garde {closest} m du mur ; permettez-en d&apos;autres.</translation>
    </message>
    <message>
        <source>From {low:n} to {high:n} in steps of {step:n}: the step must be positive, and the second value not less than the first.</source>
        <translation>De {low} à {high} par pas de {step} : le pas doit être positif, et la seconde valeur ne pas être inférieure à la première.</translation>
    </message>
    <message>
        <source>The stated sigma of {angle} is too small: its 95 % interval holds the truth in {share:n} % of the surveys.</source>
        <translation>L&apos;écart-type annoncé est trop petit ({angle}) : son intervalle à 95 % contient la vérité dans {share} % des levés.</translation>
    </message>
    <message>
        <source>scatter, deg</source>
        <translation>dispersion, °</translation>
    </message>
    <message>
        <source>stated sigma, deg</source>
        <translation>écart-type annoncé, °</translation>
    </message>
    <message>
        <source>foretold sigma, deg</source>
        <translation>écart-type prévu, °</translation>
    </message>
    <message>
        <source>scatter / foretold</source>
        <translation>dispersion / prévu</translation>
    </message>
    <message>
        <source>its sigma</source>
        <translation>son écart-type</translation>
    </message>
    <message>
        <source>95 % intervals right</source>
        <translation>intervalles à 95 % justes</translation>
    </message>
    <message>
        <source>mean error, deg</source>
        <translation>erreur moyenne, °</translation>
    </message>
    <message>
        <source>its sigma, deg</source>
        <translation>son écart-type, °</translation>
    </message>
    <message>
        <source>The mean error of {angle} is {mean:n} deg, more than chance explains.</source>
        <translation>L&apos;erreur moyenne ({angle}) est de {mean}°, plus que le hasard n&apos;explique.</translation>
    </message>
    <message>
        <source>Chi-square is {chi:n}, where {low:n} to {high:n} is to be expected: {verdict}.</source>
        <translation>Le khi-deux vaut {chi}, alors que {low} à {high} est attendu : {verdict}.</translation>
    </message>
    <message>
        <source>the errors are as large as foretold</source>
        <translation>les erreurs sont aussi grandes que prévu</translation>
    </message>
    <message>
        <source>the errors are larger than foretold</source>
        <translation>les erreurs sont plus grandes que prévu</translation>
    </message>
    <message>
        <source>the errors are smaller than foretold</source>
        <translation>les erreurs sont plus petites que prévu</translation>
    </message>
    <message>
        <source>Scatter over foretold sigma; the curve is what is to be expected</source>
        <translation>Dispersion sur écart-type prévu ; la courbe est ce qui est attendu</translation>
    </message>
    <message>
        <source>error / foretold sigma</source>
        <translation>erreur / écart-type prévu</translation>
    </message>
</context>
<context>
    <name>project</name>
    <message>
        <source>is the surface of {other:kept} already</source>
        <translation>est déjà la surface de {other}</translation>
    </message>
    <message>
        <source>shares points with {other:kept}</source>
        <translation>a des points en commun avec {other}</translation>
    </message>
    <message>
        <source>they would count twice</source>
        <translation>ils compteraient deux fois</translation>
    </message>
    <message>
        <source>a validation plane on a target checks nothing</source>
        <translation>un plan de validation sur une cible ne contrôle rien</translation>
    </message>
    <message>
        <source>Two of the points are the same; an angle needs three.</source>
        <translation>Deux des points sont le même ; un angle en demande trois.</translation>
    </message>
    <message>
        <source>who answers for the calibration</source>
        <translation>qui répond de l&apos;étalonnage</translation>
    </message>
    <message>
        <source>the surveyor&apos;s company</source>
        <translation>l&apos;entreprise de l&apos;hydrographe</translation>
    </message>
    <message>
        <source>name of the vessel</source>
        <translation>nom du navire</translation>
    </message>
    <message>
        <source>where the lines were run</source>
        <translation>où les lignes ont été parcourues</translation>
    </message>
    <message>
        <source>maker and model of the LiDAR</source>
        <translation>marque et modèle du LiDAR</translation>
    </message>
    <message>
        <source>its serial number</source>
        <translation>son numéro de série</translation>
    </message>
    <message>
        <source>maker and model of the INS/GNSS</source>
        <translation>marque et modèle de l&apos;INS/GNSS</translation>
    </message>
    <message>
        <source>day or days of the survey, 2026-03-04 for example</source>
        <translation>jour ou jours du levé, 2026-03-04 par exemple</translation>
    </message>
    <message>
        <source>how the lever arm was found: tacheometer in dock, 2026-03-04, for example</source>
        <translation>comment le bras de levier a été trouvé : tachéomètre en cale, 2026-03-04, par exemple</translation>
    </message>
    <message>
        <source>what else the reader should know</source>
        <translation>ce que le lecteur doit savoir d&apos;autre</translation>
    </message>
    <message>
        <source>{name}: more than one line; put what is left to the remarks.</source>
        <translation>{name} : plus d&apos;une ligne de texte ; mettez le reste dans les remarques.</translation>
    </message>
    <message>
        <source>{name}: longer than {longest:n} letters; shorten it.</source>
        <translation>{name} : plus de {longest} caractères ; raccourcissez.</translation>
    </message>
    <message>
        <source>{name:kept} is missing from this installation; install it again.</source>
        <translation>{name} manque dans cette installation ; réinstallez le programme.</translation>
    </message>
    <message>
        <source>There is no translation into {code:kept}; choose one of {LANGUAGES:kept}.</source>
        <translation>Il n&apos;y a pas de traduction en {code} ; choisissez parmi : {LANGUAGES}.</translation>
    </message>
    <message>
        <source>A target&apos;s name needs 1 to {LONGEST_NAME} printable characters; {longest_name:foreign} does not do.</source>
        <translation>Le nom d&apos;une cible demande de 1 à {LONGEST_NAME} caractères imprimables ; {longest_name} ne convient pas.</translation>
    </message>
    <message>
        <source>{name:kept}: lines are compared on planes only; use the sphere as a target.</source>
        <translation>{name} : les lignes ne se comparent que sur des plans ; employez la sphère comme cible.</translation>
    </message>
    <message>
        <source>position sigma</source>
        <translation>écart-type de la position</translation>
    </message>
    <message>
        <source>attitude sigma</source>
        <translation>écart-type de l&apos;attitude</translation>
    </message>
    <message>
        <source>subsampling distance</source>
        <translation>pas de sous-échantillonnage</translation>
    </message>
    <message>
        <source>LiDAR sigma along x, y, z</source>
        <translation>écart-type du LiDAR en x, y, z</translation>
    </message>
    <message>
        <source>LiDAR sigma of range and angle</source>
        <translation>écart-type de la distance et de l&apos;angle du LiDAR</translation>
    </message>
    <message>
        <source>The {name} is not a number; correct it.</source>
        <translation>Valeur qui n&apos;est pas un nombre ({name}) ; corrigez-la.</translation>
    </message>
    <message>
        <source>A sigma or the subsampling distance is negative; correct it.</source>
        <translation>Un écart-type ou le pas de sous-échantillonnage est négatif ; corrigez-le.</translation>
    </message>
    <message>
        <source>There is no model of POS errors named {pos_errors:kept}.</source>
        <translation>Il n&apos;y a pas de modèle d&apos;erreurs du POS nommé {pos_errors}.</translation>
    </message>
    <message>
        <source>The LiDAR sigma is given along x, y, z and along the beam; give one of the two.</source>
        <translation>L&apos;écart-type du LiDAR est donné en x, y, z et le long du faisceau ; donnez l&apos;un des deux.</translation>
    </message>
    <message>
        <source>The surface sigma is negative; correct it.</source>
        <translation>L&apos;écart-type des surfaces est négatif ; corrigez-le.</translation>
    </message>
    <message>
        <source>There is no loss named {loss:kept}.</source>
        <translation>Il n&apos;y a pas de fonction de perte nommée {loss}.</translation>
    </message>
    <message>
        <source>The latency or range offset is beyond 10 s or 10 m; correct it.</source>
        <translation>La latence ou le décalage de distance dépasse 10 s ou 10 m ; corrigez-le.</translation>
    </message>
    <message>
        <source>There is no parameter {name:kept}; give one of {SWITCHED:kept}.</source>
        <translation>Il n&apos;y a pas de paramètre {name} ; donnez l&apos;un de ceux-ci : {SWITCHED}.</translation>
    </message>
    <message>
        <source>The sigma of {name:kept} must be larger than zero.</source>
        <translation>L&apos;écart-type de {name} doit être supérieur à zéro.</translation>
    </message>
    <message>
        <source>A prior boresight angle is beyond 360 deg; give degrees.</source>
        <translation>Un angle de visée a priori dépasse 360° ; donnez des degrés.</translation>
    </message>
    <message>
        <source>The lever arm is longer than 100 m; give metres.</source>
        <translation>Le bras de levier fait plus de 100 m ; donnez des mètres.</translation>
    </message>
    <message>
        <source>The origin&apos;s latitude is beyond 90 deg; give LAT LON HEIGHT in degrees.</source>
        <translation>La latitude de l&apos;origine dépasse 90° ; donnez LATITUDE LONGITUDE HAUTEUR en degrés.</translation>
    </message>
    <message>
        <source>{name:kept}: there is no estimated boresight yet; estimate first.</source>
        <translation>{name} : les angles de visée ne sont pas encore estimés ; estimez-les d&apos;abord.</translation>
    </message>
    <message>
        <source>{name:kept}: there is no target or validation plane named {name2:kept}.</source>
        <translation>{name} : il n&apos;y a ni cible ni plan de validation nommé {name2}.</translation>
    </message>
    <message>
        <source>{name:kept} {same}: {share:n} % of {whose} on {line:kept} are the same. Keep one of the two.</source>
        <translation>{name} {same} : {share} % {whose} sur {line} sont les mêmes. Gardez-en un seul.</translation>
    </message>
    <message>
        <source>{name:kept} {same}: {share:n} % of {whose} on {line:kept} are the same. Keep one of the two{why}.</source>
        <translation>{name} {same} : {share} % {whose} sur {line} sont les mêmes. Gardez-en un seul{why}.</translation>
    </message>
</context>
<context>
    <name>files</name>
    <message>
        <source>{path:file}: there is no column called {token:kept}; name each column from the left as one of {sorted:kept}, and - for others.</source>
        <translation>{path} : il n&apos;y a pas de colonne appelée {token} ; nommez chaque colonne depuis la gauche par l&apos;un de ces mots : {sorted}, et - pour les autres.</translation>
    </message>
    <message>
        <source>{path:file}: two columns are named {token:kept}; name each once.</source>
        <translation>{path} : deux colonnes sont nommées {token} ; nommez chacune une seule fois.</translation>
    </message>
    <message>
        <source>generic text</source>
        <translation>texte générique</translation>
    </message>
    <message>
        <source>{path:file}: {header:kept} is not a number of header rows; state one, or auto.</source>
        <translation>{path} : {header} n&apos;est pas un nombre de rangées d&apos;en-tête ; indiquez-en un, ou auto.</translation>
    </message>
    <message>
        <source>No row names the columns; {DEFAULT_COLUMNS:kept} is taken: state the columns if they differ.</source>
        <translation>Aucune rangée ne nomme les colonnes ; supposées : {DEFAULT_COLUMNS}. Indiquez les colonnes si elles diffèrent.</translation>
    </message>
    <message>
        <source>The file does not say whether its times are UTC; UTC is taken.</source>
        <translation>Le fichier ne dit pas si ses temps sont en UTC ; UTC est supposé.</translation>
    </message>
    <message>
        <source>The file does not say the sign of {option}; positive {words} is taken.</source>
        <translation>Le fichier ne dit pas le signe ({option}) ; supposé positif : {words}.</translation>
    </message>
    <message>
        <source>The first values of {option} stay within a full circle of radians, so radians are taken; state degrees if they are.</source>
        <translation>Les premières valeurs ({option}) restent dans un tour en radians ; les radians sont donc supposés : indiquez des degrés si c&apos;en sont.</translation>
    </message>
    <message>
        <source>CIDCO binary, 22 float64 a point</source>
        <translation>CIDCO binaire, 22 float64 par point</translation>
    </message>
    <message>
        <source>columns in CIDCO&apos;s order; LiDAR coordinates are taken, the local ones and the POS states go along; points and trajectory share one time base</source>
        <translation>colonnes dans l&apos;ordre de CIDCO ; les coordonnées du LiDAR sont prises, les coordonnées locales et les états du POS les accompagnent ; points et trajectoire ont la même base de temps</translation>
    </message>
    <message>
        <source>{path:file}: {size:n} bytes are not a whole number of {RECORD}-byte points (the last one has {record}); the file is cut short or not CIDCO&apos;s: copy or export it again.</source>
        <translation>{path} : {size} octets ne font pas un nombre entier de points de {RECORD} octets (le dernier en a {record}) ; le fichier est tronqué ou n&apos;est pas de CIDCO : copiez-le ou exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>Where the file&apos;s local frame stands on Earth: latitude and longitude in degrees, height in metres above the ellipsoid, 46.8 -71.2 20 say.</source>
        <translation>Où le repère local du fichier se trouve sur la Terre : latitude et longitude en degrés, hauteur en mètres au-dessus de l&apos;ellipsoïde, par exemple 46.8 -71.2 20.</translation>
    </message>
    <message>
        <source>{path:file}: two points at {unlike:n} s hold different POS states, so these are not one trajectory: check that all files are of one survey.</source>
        <translation>{path} : deux points à {unlike} s ont des états du POS différents ; ce n&apos;est donc pas une seule trajectoire : vérifiez que tous les fichiers sont du même levé.</translation>
    </message>
    <message>
        <source>The origin {text:kept} is not latitude, longitude (degrees) and height (metres); check it, or leave it out.</source>
        <translation>L&apos;origine {text} n&apos;est pas latitude, longitude (degrés) et hauteur (mètres) ; vérifiez-la ou ne l&apos;indiquez pas.</translation>
    </message>
    <message>
        <source>{len:n} states of different times</source>
        <translation>{len} états à des temps différents</translation>
    </message>
    <message>
        <source>The file does not say where its local frame stands on Earth, so 0 N 0 E is taken: the boresight does not depend on it, but state the origin before clouds go on a map.</source>
        <translation>Le fichier ne dit pas où son repère local se trouve sur la Terre ; 0 N 0 E est donc supposé : les angles de visée n&apos;en dépendent pas, mais indiquez l&apos;origine avant de mettre des nuages sur une carte.</translation>
    </message>
    <message>
        <source>Whether time stamps count from the start of their scan, as the standard says, or from zero</source>
        <translation>Si les temps comptent depuis le début de leur balayage, comme le dit la norme, ou depuis zéro</translation>
    </message>
    <message>
        <source>Time stamps such as {stamps:n} are too large for the time since the start of a scan: taken as they are.</source>
        <translation>Des temps tels que {stamps} sont trop grands pour compter depuis le début d&apos;un balayage : pris tels quels.</translation>
    </message>
    <message>
        <source>The scans do not say when they started: time stamps are taken as they are.</source>
        <translation>Les balayages ne disent pas quand ils ont commencé : les temps sont pris tels quels.</translation>
    </message>
    <message>
        <source>The scans have poses: they are applied where points are georeferenced, not in the scanner frame.</source>
        <translation>Les balayages ont des poses : elles s&apos;appliquent là où les points sont géoréférencés, pas dans le repère du scanneur.</translation>
    </message>
    <message>
        <source>written by</source>
        <translation>écrit par</translation>
    </message>
    <message>
        <source>{count:n} in {len:n} scans</source>
        <translation>{count} en {len} balayages</translation>
    </message>
    <message>
        <source>time stamps counted from the start of their scan</source>
        <translation>temps comptés depuis le début de leur balayage</translation>
    </message>
    <message>
        <source>time stamps as they are; points and trajectory share one time base</source>
        <translation>temps tels quels ; points et trajectoire ont la même base de temps</translation>
    </message>
    <message>
        <source>{path:file}: the header of this E57 file speaks of {length:n} bytes, it has {size:n}; it is cut short or damaged: copy or export it again.</source>
        <translation>{path} : l&apos;en-tête de ce fichier E57 annonce {length} octets, il en a {size} ; il est tronqué ou endommagé : copiez-le ou exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: this file holds no points; leave it out.</source>
        <translation>{path} : ce fichier ne contient aucun point ; écartez-le.</translation>
    </message>
    <message>
        <source>{path:file}: a scan promises {count:n} points and holds {done:n}; copy or export it again.</source>
        <translation>{path} : un balayage annonce {count} points et en contient {done} ; copiez-le ou exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: no line that starts with # names the columns; export with the header, or read the file as generic text and state the columns.</source>
        <translation>{path} : aucune ligne commençant par # ne nomme les colonnes ; exportez avec l&apos;en-tête, ou lisez le fichier comme texte générique et indiquez les colonnes.</translation>
    </message>
    <message>
        <source>without title</source>
        <translation>sans titre</translation>
    </message>
    <message>
        <source>Sign of {role}</source>
        <translation>Signe ({role})</translation>
    </message>
    <message>
        <source>The header does not say the sign of {angle}; iXblue&apos;s is taken (positive {replace}).</source>
        <translation>L&apos;en-tête ne dit pas le signe ({angle}) ; celui d&apos;iXblue est supposé (positif : {replace}).</translation>
    </message>
    <message>
        <source>The header does not say whether its times are UTC; UTC is taken.</source>
        <translation>L&apos;en-tête ne dit pas si ses temps sont en UTC ; UTC est supposé.</translation>
    </message>
    <message>
        <source>Sign of pitch</source>
        <translation>Signe du tangage</translation>
    </message>
    <message>
        <source>Sign of roll</source>
        <translation>Signe du roulis</translation>
    </message>
    <message>
        <source>{path:file}: there is no such {what} file; check the path.</source>
        <translation>{path} : ce fichier ({what}) n&apos;existe pas ; vérifiez le chemin.</translation>
    </message>
    <message>
        <source>{path:file}: this is a {kind}, not a {what} file; choose a file.</source>
        <translation>{path} : {kind} au lieu d&apos;un fichier ({what}) ; choisissez un fichier.</translation>
    </message>
    <message>
        <source>folder</source>
        <translation>dossier</translation>
    </message>
    <message>
        <source>named pipe (FIFO)</source>
        <translation>tube nommé (FIFO)</translation>
    </message>
    <message>
        <source>socket</source>
        <translation>socket</translation>
    </message>
    <message>
        <source>device</source>
        <translation>périphérique</translation>
    </message>
    <message>
        <source>disk device</source>
        <translation>périphérique de stockage</translation>
    </message>
    <message>
        <source>{path:file}: this is a spreadsheet or another office document; save it as text (CSV).</source>
        <translation>{path} : c&apos;est un classeur ou un autre document bureautique ; enregistrez-le en texte (CSV).</translation>
    </message>
    <message>
        <source>ZIP archive</source>
        <translation>archive ZIP</translation>
    </message>
    <message>
        <source>7z archive</source>
        <translation>archive 7z</translation>
    </message>
    <message>
        <source>RAR archive</source>
        <translation>archive RAR</translation>
    </message>
    <message>
        <source>TAR archive</source>
        <translation>archive TAR</translation>
    </message>
    <message>
        <source>file compressed by xz</source>
        <translation>xz</translation>
    </message>
    <message>
        <source>file compressed by Zstandard</source>
        <translation>Zstandard</translation>
    </message>
    <message>
        <source>file compressed by LZ4</source>
        <translation>LZ4</translation>
    </message>
    <message>
        <source>file compressed by gzip</source>
        <translation>gzip</translation>
    </message>
    <message>
        <source>file compressed by bzip2</source>
        <translation>bzip2</translation>
    </message>
    <message>
        <source>{path:file}: this {what} file is empty; export it again.</source>
        <translation>{path} : ce fichier ({what}) est vide ; exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: {what} record {bad:n} holds a value that is not a number ({such}); export it again.</source>
        <translation>{path} : l&apos;enregistrement {what} {bad} contient une valeur qui n&apos;est pas un nombre ({such}) ; exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>choose another folder</source>
        <translation>choisissez un autre dossier</translation>
    </message>
    <message>
        <source>make room on the disk or {remedy}</source>
        <translation>faites de la place sur le disque ou {remedy}</translation>
    </message>
    <message>
        <source>{path:file}: cannot be written ({error:foreign}); {remedy}.</source>
        <translation>{path} : écriture impossible ({error}) ; {remedy}.</translation>
    </message>
    <message>
        <source>There is no format {key:kept}; choose one of {known:kept}.</source>
        <translation>Il n&apos;y a pas de format {key} ; choisissez parmi : {known}.</translation>
    </message>
    <message>
        <source>{path:file}: point format {id} has no gps_time, so its points cannot be put on the trajectory; export the line with GPS time.</source>
        <translation>{path} : le format de point {id} n&apos;a pas de gps_time et ses points ne peuvent être placés sur la trajectoire ; exportez la ligne avec le temps GPS.</translation>
    </message>
    <message>
        <source>{path:file}: this line holds no points; leave it out.</source>
        <translation>{path} : cette ligne ne contient aucun point ; écartez-la.</translation>
    </message>
    <message>
        <source>{path:file}: cannot be read as LAS or LAZ ({error:foreign}); copy or export it again.</source>
        <translation>{path} : illisible comme LAS ou LAZ ({error}) ; copiez-le ou exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: the header promises {count:n} points, the file holds {done:n}; copy or export it again.</source>
        <translation>{path} : l&apos;en-tête annonce {count} points, le fichier en contient {done} ; copiez-le ou exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>{file:file}: the header counts {header:n} points, but the file holds {held:n}. All of them are read. Export the file again before another program reads it.</source>
        <translation>{file} : l&apos;en-tête compte {header} points, mais le fichier en contient {held}. Tous sont lus. Exportez de nouveau le fichier avant de le lire avec un autre programme.</translation>
    </message>
    <message>
        <source>{file:file}: the two point counts of the header differ ({header:n} and {legacy:n}). The file holds {held:n} points, and all are read.</source>
        <translation>{file} : les deux nombres de points de l&apos;en-tête diffèrent ({header} et {legacy}). Le fichier contient {held} points, et tous sont lus.</translation>
    </message>
    <message>
        <source>{file:file}: {count:n} of {total:n} points are marked as invalid in the file. They are not used.</source>
        <translation>{file} : {count} points sur {total} sont marqués comme invalides dans le fichier. Ils ne sont pas utilisés.</translation>
    </message>
    <message>
        <source>{path:file}: a scan counts {counted:n} points and holds {held:n}, and no more than it counts can be read; export it again.</source>
        <translation>{path} : un balayage compte {counted} points et en contient {held}, et seuls ceux qu&apos;il compte peuvent être lus ; exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>{file:file}: the header states two coordinate systems. {used:kept} applies by its WKT bit, {other:kept} does not. If the points are in the second one, they are placed wrongly: set it as the coordinate system (option crs).</source>
        <translation>{file} : l&apos;en-tête indique deux systèmes de coordonnées. {used} s&apos;applique d&apos;après son bit WKT, {other} ne s&apos;applique pas. Si les points sont dans le second, ils sont mal placés : indiquez-le comme système de coordonnées (option crs).</translation>
    </message>
    <message>
        <source>{file:file}: the coordinate system that applies by the header cannot be used. {system:kept}, which the header states as well, is used.</source>
        <translation>{file} : le système de coordonnées qui s&apos;applique d&apos;après l&apos;en-tête est inutilisable. {system}, que l&apos;en-tête indique aussi, est utilisé.</translation>
    </message>
    <message>
        <source>Set {name:kept} to {value:kept}</source>
        <translation>Choisir {value} pour {name}</translation>
    </message>
    <message>
        <source>the last chunk is damaged</source>
        <translation>le dernier bloc est endommagé</translation>
    </message>
    <message>
        <source>{path:file}: point {bad:n} has a coordinate or time that is not a number ({such}); clean or export it again.</source>
        <translation>{path} : le point {bad} a une coordonnée ou un temps qui n&apos;est pas un nombre ({such}) ; nettoyez-le ou exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>Points lie outside the bounds that the header states: the file may be damaged.</source>
        <translation>Des points sont hors des bornes indiquées par l&apos;en-tête : le fichier est peut-être endommagé.</translation>
    </message>
    <message>
        <source>{compressed:kept} {version:kept}, point format {id}</source>
        <translation>{compressed} {version}, format de point {id}</translation>
    </message>
    <message>
        <source>points and trajectory share one time base</source>
        <translation>points et trajectoire ont la même base de temps</translation>
    </message>
    <message>
        <source>Coordinates are stored in steps of {metres:n} mm in {axis:kept}: the points are no better than that; export with 0.1 mm.</source>
        <translation>Les coordonnées sont stockées par pas de {metres} mm en {axis} : les points ne valent pas mieux ; exportez à 0.1 mm.</translation>
    </message>
    <message>
        <source>The resolution {scales:n} comes from feet: check the unit.</source>
        <translation>La résolution {scales} vient de pieds : vérifiez l&apos;unité.</translation>
    </message>
    <message>
        <source>The WKT of the header is not a coordinate system PROJ knows: give it.</source>
        <translation>Le WKT de l&apos;en-tête n&apos;est pas un système de coordonnées connu de PROJ : indiquez-le.</translation>
    </message>
    <message>
        <source>The header gives no code but the name {name:kept}, taken as EPSG:{crs}: check it.</source>
        <translation>L&apos;en-tête ne donne pas de code, mais le nom {name}, pris comme EPSG:{crs} : vérifiez-le.</translation>
    </message>
    <message>
        <source>without a name</source>
        <translation>sans nom</translation>
    </message>
    <message>
        <source>The header&apos;s coordinate system ({given}) has no known code: give it.</source>
        <translation>Le système de coordonnées de l&apos;en-tête ({given}) n&apos;a pas de code connu : indiquez-le.</translation>
    </message>
    <message>
        <source>The header says {unit}, but {name:kept} is in {own}: give the coordinate system that the points are in.</source>
        <translation>L&apos;en-tête dit {unit}, mais {name} est en {own} : indiquez le système de coordonnées des points.</translation>
    </message>
    <message>
        <source>The header&apos;s code of heights, {vertical:kept}, is not known: state them.</source>
        <translation>Le code de hauteurs de l&apos;en-tête, {vertical}, n&apos;est pas connu : indiquez-les.</translation>
    </message>
    <message>
        <source>{path:file}: cannot be read as LAS or LAZ ({error:foreign}).</source>
        <translation>{path} : illisible comme LAS ou LAZ ({error}).</translation>
    </message>
    <message>
        <source>{name:kept}: the points&apos; references to waveforms are kept, the waveforms themselves are not; their directions stay those of the source</source>
        <translation>{name} : les références des points aux formes d&apos;onde sont gardées, les formes d&apos;onde ne le sont pas ; leurs directions restent celles de la source</translation>
    </message>
    <message>
        <source>the column {name:kept} is neither numbers nor flags and is left out</source>
        <translation>la colonne {name} ne contient ni nombres ni indicateurs et est laissée de côté</translation>
    </message>
    <message>
        <source>{name:file}: points lie more than {scales:n} units from the trajectory, too far to be stored with them; clean the line.</source>
        <translation>{name} : des points sont à plus de {scales} unités de la trajectoire, trop loin pour être stockés avec elle ; nettoyez la ligne.</translation>
    </message>
    <message>
        <source>{path:file}: LAZ would not keep what points of several scanner channels say of their waveforms (point format {id}); write LAS instead.</source>
        <translation>{path} : le LAZ ne garderait pas ce que des points de plusieurs canaux du scanneur disent de leurs formes d&apos;onde (format de point {id}) ; écrivez plutôt du LAS.</translation>
    </message>
    <message>
        <source>{shown:file}: cannot be written ({reason:foreign}); nothing of it is kept: make room on the disk or choose another folder.</source>
        <translation>{shown} : écriture impossible ({reason}) ; rien n&apos;en est gardé : faites de la place sur le disque ou choisissez un autre dossier.</translation>
    </message>
    <message>
        <source>{path:file}: cannot be read as LAS or LAZ (it does not start with LASF, as these do); check what it is, or export it again.</source>
        <translation>{path} : illisible comme LAS ou LAZ (ne commence pas par LASF, comme eux) ; vérifiez ce que c&apos;est ou exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: cannot be read as LAS or LAZ (its header does not fit its {size:n} bytes); copy or export it again.</source>
        <translation>{path} : illisible comme LAS ou LAZ (son en-tête ne correspond pas à ses {size} octets) ; copiez-le ou exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: the file ends after point {held:n} of the {promised:n} that its header promises, so it is cut short; copy or export it again.</source>
        <translation>{path} : le fichier se termine après le point {held} sur les {promised} que son en-tête annonce ; il est tronqué : copiez-le ou exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>{name:kept}: {done:n} points looked at</source>
        <translation>{name} : {done} points examinés</translation>
    </message>
    <message>
        <source>{name:kept}: {k} of {BLOCKS} places looked at</source>
        <translation>{name} : {k} endroits examinés sur {BLOCKS}</translation>
    </message>
    <message>
        <source>{path:file}: no point looked at has a usable time; export the line again.</source>
        <translation>{path} : aucun point examiné n&apos;a de temps utilisable ; exportez la ligne de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: a mesh is PLY, OBJ or STL; export it as one of these.</source>
        <translation>{path} : un maillage est en PLY, OBJ ou STL ; exportez-le dans l&apos;un de ces formats.</translation>
    </message>
    <message>
        <source>{path:file}: no triangles are in it; export the mesh, not its points.</source>
        <translation>{path} : il ne contient pas de triangles ; exportez le maillage, pas ses points.</translation>
    </message>
    <message>
        <source>{path:file}: a vertex is not a number; export the mesh again.</source>
        <translation>{path} : un sommet n&apos;est pas un nombre ; exportez le maillage de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: the PCD data kind {kind:kept} is not known.</source>
        <translation>{path} : le genre de données PCD {kind} n&apos;est pas connu.</translation>
    </message>
    <message>
        <source>{path:file}: the header of this PCD file has no {missing:kept}; it is damaged: export it again.</source>
        <translation>{path} : l&apos;en-tête de ce fichier PCD n&apos;a pas {missing} ; il est endommagé : exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: the header of this PCD file is damaged ({error:foreign}); export it again.</source>
        <translation>{path} : l&apos;en-tête de ce fichier PCD est endommagé ({error}) ; exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: the header of this PCD file is damaged (points {count:foreign}).</source>
        <translation>{path} : l&apos;en-tête de ce fichier PCD est endommagé (points {count}).</translation>
    </message>
    <message>
        <source>{path:file}: {key2:kept} has no board; add [[boards]] or [[balls]].</source>
        <translation>{path} : {key2} n&apos;a pas de panneau ; ajoutez [[boards]] ou [[balls]].</translation>
    </message>
    <message>
        <source>{path:file}: {key2:kept} is empty; add [[lines]].</source>
        <translation>{path} : {key2} est vide ; ajoutez [[lines]].</translation>
    </message>
    <message>
        <source>{path:file}: {key2:kept} and width_m differ in number; give one of each a size.</source>
        <translation>{path} : {key2} et width_m diffèrent en nombre ; donnez une valeur de chacun par taille.</translation>
    </message>
    <message>
        <source>{path:file}: {key2:kept} holds {value:n}; give a whole number.</source>
        <translation>{path} : {key2} contient {value} ; donnez un nombre entier.</translation>
    </message>
    <message>
        <source>{path:file}: not a plane file of {COLUMNS} columns of numbers ({error:foreign}).</source>
        <translation>{path} : ce n&apos;est pas un fichier de plan de {COLUMNS} colonnes de nombres ({error}).</translation>
    </message>
    <message>
        <source>{path:file}: this plane file holds no points.</source>
        <translation>{path} : ce fichier de plan ne contient aucun point.</translation>
    </message>
    <message>
        <source>{path:file}: row {bad:n} holds a value that is not a number.</source>
        <translation>{path} : la rangée {bad} contient une valeur qui n&apos;est pas un nombre.</translation>
    </message>
    <message>
        <source>plane file, 25 columns</source>
        <translation>fichier de plan, 25 colonnes</translation>
    </message>
    <message>
        <source>LiDAR coordinates are taken, the local ones and the POS states go along; points and trajectory share one time base</source>
        <translation>Les coordonnées du LiDAR sont prises, les coordonnées locales et les états du POS les accompagnent ; points et trajectoire ont la même base de temps</translation>
    </message>
    <message>
        <source>A plane file holds the points of one target on all lines, not one line.</source>
        <translation>Un fichier de plan contient les points d&apos;une cible sur toutes les lignes, pas une ligne.</translation>
    </message>
    <message>
        <source>{path:file}: the PLY format {missing:kept} is not known.</source>
        <translation>{path} : le format PLY {missing} n&apos;est pas connu.</translation>
    </message>
    <message>
        <source>{path:file}: the header of this PLY file is damaged (count {text:foreign}).</source>
        <translation>{path} : l&apos;en-tête de ce fichier PLY est endommagé (nombre {text}).</translation>
    </message>
    <message>
        <source>{path:file}: {element:kept} has the property {name:kept} of type {none:kept}, which no point of a line has; export points alone, without faces.</source>
        <translation>{path} : {element} a la propriété {name} de type {none}, qu&apos;aucun point d&apos;une ligne n&apos;a ; exportez les points seuls, sans faces.</translation>
    </message>
    <message>
        <source>{path:file}: {element:kept} has two properties {name:kept}; export it again.</source>
        <translation>{path} : {element} a deux propriétés {name} ; exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: {element:kept} has no properties; export it again.</source>
        <translation>{path} : {element} n&apos;a pas de propriétés ; exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>What the coordinates refer to: the scanner, or the map</source>
        <translation>Ce à quoi se rapportent les coordonnées : le scanneur ou la carte</translation>
    </message>
    <message>
        <source>Unit of scanner-frame coordinates</source>
        <translation>Unité des coordonnées dans le repère du scanneur</translation>
    </message>
    <message>
        <source>Coordinate system of georeferenced points: EPSG code, EPSG:32619 say, or WKT</source>
        <translation>Système de coordonnées des points géoréférencés : code EPSG, EPSG:32619 par exemple, ou WKT</translation>
    </message>
    <message>
        <source>What heights are counted from: ellipsoid, EPSG code of a vertical system, path of a geoid grid, or metres to be added with their sign; empty: as the coordinate system says</source>
        <translation>Origine des hauteurs : ellipsoid, code EPSG d&apos;un système vertical, chemin d&apos;une grille de géoïde, ou mètres à ajouter avec leur signe ; vide : comme le dit le système de coordonnées</translation>
    </message>
    <message>
        <source>Unit of heights; empty: as the coordinate system says</source>
        <translation>Unité des hauteurs ; vide : comme le dit le système de coordonnées</translation>
    </message>
    <message>
        <source>Geographic system of the trajectory, EPSG:7912 say; empty: as the points</source>
        <translation>Système géographique de la trajectoire, EPSG:7912 par exemple ; vide : comme les points</translation>
    </message>
    <message>
        <source>Date of the survey as a decimal year, where datums drift apart</source>
        <translation>Date du levé en année décimale, là où les référentiels dérivent l&apos;un par rapport à l&apos;autre</translation>
    </message>
    <message>
        <source>What the times count; empty: as the file says</source>
        <translation>Ce que comptent les temps ; vide : comme le dit le fichier</translation>
    </message>
    <message>
        <source>Where times start again at zero within the line; empty: found by the times</source>
        <translation>Où les temps repartent de zéro dans la ligne ; vide : trouvé d&apos;après les temps</translation>
    </message>
    <message>
        <source>Name of the field with the time; empty: by the usual names</source>
        <translation>Nom du champ du temps ; vide : d&apos;après les noms usuels</translation>
    </message>
    <message>
        <source>Unit of the time</source>
        <translation>Unité du temps</translation>
    </message>
    <message>
        <source>names no coordinate system</source>
        <translation>ne nomme pas de système de coordonnées</translation>
    </message>
    <message>
        <source>{epoch:kept}: not a date as a decimal year; 2024.5 for example.</source>
        <translation>{epoch} : pas une date en année décimale ; 2024.5 par exemple.</translation>
    </message>
    <message>
        <source>scanner (LiDAR) frame</source>
        <translation>repère du scanneur (LiDAR)</translation>
    </message>
    <message>
        <source>{name}, turned into metres</source>
        <translation>{name}, converti en mètres</translation>
    </message>
    <message>
        <source>{path:file}: cannot be read as {what} ({reason:foreign}); copy or export it again.</source>
        <translation>{path} : illisible comme {what} ({reason}) ; copiez-le ou exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: there is no field {wanted:kept}; it has {names:kept}.</source>
        <translation>{path} : il n&apos;y a pas de champ {wanted} ; il a {names}.</translation>
    </message>
    <message>
        <source>{path:file}: times around {float:n} are stored with 32 bits, in steps of {step:n} s: too coarse to put points on the trajectory; export with 64-bit time.</source>
        <translation>{path} : les temps vers {float} sont stockés en 32 bits, par pas de {step} s : trop grossier pour placer des points sur la trajectoire ; exportez avec un temps de 64 bits.</translation>
    </message>
    <message>
        <source>time from, to</source>
        <translation>temps de, à</translation>
    </message>
    <message>
        <source>{time:n}, {time2:n} s (first {len:n} points)</source>
        <translation>{time}, {time2} s ({len} premiers points)</translation>
    </message>
    <message>
        <source>Coordinates up to {farthest:n} are too large for the scanner frame and the file {NO_SYSTEM}: give its EPSG code.</source>
        <translation>Des coordonnées jusqu&apos;à {farthest} sont trop grandes pour le repère du scanneur et le fichier {NO_SYSTEM} : indiquez son code EPSG.</translation>
    </message>
    <message>
        <source>The points lie all around the origin, as a scanner&apos;s do: where these are millimetres, choose the scanner frame and that unit.</source>
        <translation>Les points entourent l&apos;origine, comme ceux d&apos;un scanneur : si ce sont des millimètres, choisissez le repère du scanneur et cette unité.</translation>
    </message>
    <message>
        <source>The file names a coordinate system, but its coordinates are small enough for the scanner frame: check which it is.</source>
        <translation>Le fichier nomme un système de coordonnées, mais ses coordonnées sont assez petites pour le repère du scanneur : vérifiez duquel il s&apos;agit.</translation>
    </message>
    <message>
        <source>Points lie up to {farthest:n} from the origin, farther than a vessel&apos;s scanner sees: check the frame and the unit (feet, millimetres?).</source>
        <translation>Des points sont à {farthest} de l&apos;origine, plus loin que ne voit le scanneur d&apos;un navire : vérifiez le repère et l&apos;unité (pieds, millimètres ?).</translation>
    </message>
    <message>
        <source>All points lie {away:n} or more from the origin, so it is hardly the scanner: check the frame.</source>
        <translation>Tous les points sont à {away} ou plus de l&apos;origine, qui n&apos;est donc guère le scanneur : vérifiez le repère.</translation>
    </message>
    <message>
        <source>The first two coordinates vary by less than 0.02: these may be degrees of longitude and latitude; check the frame.</source>
        <translation>Les deux premières coordonnées varient de moins de 0.02 : ce sont peut-être des degrés de longitude et de latitude ; vérifiez le repère.</translation>
    </message>
    <message>
        <source>Times are stored with 32 bits, in steps of {step:n} s: export with 64.</source>
        <translation>Les temps sont stockés en 32 bits, par pas de {step} s : exportez en 64.</translation>
    </message>
    <message>
        <source>Times look as if they had passed through 32 bits (steps of {hidden:n} s): points may be put on the wrong pose; export with 64-bit time.</source>
        <translation>Les temps semblent être passés par 32 bits (pas de {hidden} s) : des points peuvent être placés sur une mauvaise pose ; exportez avec un temps de 64 bits.</translation>
    </message>
    <message>
        <source>Times are whole numbers: check their unit.</source>
        <translation>Les temps sont des nombres entiers : vérifiez leur unité.</translation>
    </message>
    <message>
        <source>All points looked at share one time: the file may hold no times.</source>
        <translation>Tous les points examinés ont le même temps : le fichier ne contient peut-être pas de temps.</translation>
    </message>
    <message>
        <source>Times run backward {backward:n} times in the first {count:n} points; points are taken in the order of the file.</source>
        <translation>Les temps reculent {backward} fois dans les {count} premiers points ; les points sont pris dans l&apos;ordre du fichier.</translation>
    </message>
    <message>
        <source>no known time base</source>
        <translation>aucune base de temps connue</translation>
    </message>
    <message>
        <source>Date of mission</source>
        <translation>Date de la mission</translation>
    </message>
    <message>
        <source>Mapping frame</source>
        <translation>Repère de la projection</translation>
    </message>
    <message>
        <source>Made from</source>
        <translation>Fait à partir de</translation>
    </message>
    <message>
        <source>{path:file}: no line names the columns (TIME, ..., LATITUDE, LONGITUDE, ...); export with the header, or read the file as generic text and state the columns.</source>
        <translation>{path} : aucune ligne ne nomme les colonnes (TIME, ..., LATITUDE, LONGITUDE, ...) ; exportez avec l&apos;en-tête, ou lisez le fichier comme texte générique et indiquez les colonnes.</translation>
    </message>
    <message>
        <source>{path:file}: {name:kept} is in degrees, minutes and seconds or in hours; export decimal degrees and seconds.</source>
        <translation>{path} : {name} est en degrés, minutes et secondes ou en heures ; exportez des degrés et des secondes décimaux.</translation>
    </message>
    <message>
        <source>POSPac text export</source>
        <translation>export texte de POSPac</translation>
    </message>
    <message>
        <source>{path:file}, row {row:n}: {strip:kept} is not a row of numbers; export the file again.</source>
        <translation>{path}, rangée {row} : {strip} n&apos;est pas une rangée de nombres ; exportez le fichier de nouveau.</translation>
    </message>
    <message>
        <source>{folder:file}: there is no project here ({FILE_NAME:kept} is missing).</source>
        <translation>{folder} : il n&apos;y a pas de projet ici ({FILE_NAME} manque).</translation>
    </message>
    <message>
        <source>{path:file}: made by a newer version of the program (schema {version}); update it.</source>
        <translation>{path} : fait par une version plus récente du programme (schéma {version}) ; mettez celui-ci à jour.</translation>
    </message>
    <message>
        <source>{path:file}: the points of target {name:kept} are missing; restore the file from a copy of the project, or make the project again.</source>
        <translation>{path} : les points de la cible {name} manquent ; restaurez le fichier depuis une copie du projet, ou refaites le projet.</translation>
    </message>
    <message>
        <source>{path:file}: the points of target {target:kept} are damaged ({in_one_line:foreign}); restore the file from a copy of the project, or make the project again.</source>
        <translation>{path} : les points de la cible {target} sont endommagés ({in_one_line}) ; restaurez le fichier depuis une copie du projet, ou refaites le projet.</translation>
    </message>
    <message>
        <source>The time {field:kept} is in whole numbers: state its unit.</source>
        <translation>Le temps {field} est en nombres entiers : indiquez son unité.</translation>
    </message>
    <message>
        <source>Coordinates are stored with 32 bits, in steps of {grain:n} mm at {farthest:n}: the points are no better than that; export with 64.</source>
        <translation>Les coordonnées sont stockées en 32 bits, par pas de {grain} mm à {farthest} : les points ne valent pas mieux ; exportez en 64.</translation>
    </message>
    <message>
        <source>{field:kept} is the time in {time_unit}s; points and trajectory share one time base</source>
        <translation>{field} est le temps en {time_unit}s ; points et trajectoire ont la même base de temps</translation>
    </message>
    <message>
        <source>{name} has no option {name2:kept}; leave it out.</source>
        <translation>{name} n&apos;a pas d&apos;option {name2} ; ne l&apos;indiquez pas.</translation>
    </message>
    <message>
        <source>latitude and longitude look exchanged: choose the order longitude-latitude</source>
        <translation>latitude et longitude semblent échangées : choisissez l&apos;ordre longitude-latitude</translation>
    </message>
    <message>
        <source>it may be of another byte order or another format: export it again</source>
        <translation>il a peut-être un autre ordre des octets ou un autre format : exportez-le de nouveau</translation>
    </message>
    <message>
        <source>{path:file}: latitude or longitude is out of range for {unit} from SBET record {first:n} on (up to {largest:n}); this is not SBET in {unit2}: {hint}.</source>
        <translation>{path} : latitude ou longitude hors limites en {unit} à partir de l&apos;enregistrement SBET {first} (jusqu&apos;à {largest}) ; ce n&apos;est pas un SBET en {unit2} : {hint}.</translation>
    </message>
    <message>
        <source>{path:file}: an accuracy is negative; this is not an smrmsg file: choose another.</source>
        <translation>{path} : une précision est négative ; ce n&apos;est pas un fichier smrmsg : choisissez-en un autre.</translation>
    </message>
    <message>
        <source>not two SBET records</source>
        <translation>pas deux enregistrements SBET</translation>
    </message>
    <message>
        <source>The numbers are big-endian, which SBET is not; check who wrote the file.</source>
        <translation>Les nombres sont gros-boutistes (big-endian), ce que SBET n&apos;est pas ; vérifiez qui a écrit le fichier.</translation>
    </message>
    <message>
        <source>The file ends within a record ({record} of {RECORD} bytes): it is cut short or not SBET; copy or export it again.</source>
        <translation>Le fichier se termine au milieu d&apos;un enregistrement ({record} octets sur {RECORD}) : il est tronqué ou n&apos;est pas un SBET ; copiez-le ou exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>{lost:n} of the records looked at hold values that are not numbers.</source>
        <translation>{lost} des enregistrements examinés contiennent des valeurs qui ne sont pas des nombres.</translation>
    </message>
    <message>
        <source>The numbers are not those of an SBET; choose the format the file has.</source>
        <translation>Les nombres ne sont pas ceux d&apos;un SBET ; choisissez le format du fichier.</translation>
    </message>
    <message>
        <source>Wander angle</source>
        <translation>Angle de dérive (wander)</translation>
    </message>
    <message>
        <source>Latitude and longitude reach {max:n} and can be neither radians nor degrees; choose the format the file has.</source>
        <translation>Latitude et longitude atteignent {max} et ne peuvent être ni des radians ni des degrés ; choisissez le format du fichier.</translation>
    </message>
    <message>
        <source>Latitude and longitude look like degrees; all angles are taken to be in degrees.</source>
        <translation>Latitude et longitude ressemblent à des degrés ; tous les angles sont supposés en degrés.</translation>
    </message>
    <message>
        <source>The heading stays below 6.3 and may be in radians although the positions are in degrees; export the file in radians to be sure.</source>
        <translation>Le cap reste au-dessous de 6.3 et est peut-être en radians alors que les positions sont en degrés ; exportez le fichier en radians pour en être sûr.</translation>
    </message>
    <message>
        <source>The first of the two positions exceeds 90 deg, so longitude is taken to stand before latitude.</source>
        <translation>La première des deux positions dépasse 90° ; la longitude est donc supposée avant la latitude.</translation>
    </message>
    <message>
        <source>The platform heading is taken less the wander angle, after Applanix.</source>
        <translation>Le cap de la plateforme est pris moins l&apos;angle de dérive (wander), selon Applanix.</translation>
    </message>
    <message>
        <source>all zero</source>
        <translation>toutes nulles</translation>
    </message>
    <message>
        <source>All velocities are zero, so neither their axes nor the wander angle could be checked against the course.</source>
        <translation>Toutes les vitesses sont nulles : ni leurs axes ni l&apos;angle de dérive (wander) n&apos;ont pu être comparés à la route.</translation>
    </message>
    <message>
        <source>The carrier hardly moves in the part looked at, so the velocities could not be checked against the course.</source>
        <translation>Le porteur ne bouge guère dans la partie examinée : les vitesses n&apos;ont pas pu être comparées à la route.</translation>
    </message>
    <message>
        <source>Longitude is taken to stand before latitude: only then do the velocities agree with the positions.</source>
        <translation>La longitude est supposée avant la latitude : c&apos;est seulement ainsi que les vitesses concordent avec les positions.</translation>
    </message>
    <message>
        <source>agree with the positions in no known frame</source>
        <translation>ne concordent avec les positions dans aucun repère connu</translation>
    </message>
    <message>
        <source>The velocities agree with the positions in no known frame (the best, {best}, misses by {best2:n} % of the speed); check axes, unit and heading.</source>
        <translation>Les vitesses ne concordent avec les positions dans aucun repère connu (le meilleur, {best}, s&apos;en écarte de {best2} % de la vitesse) ; vérifiez les axes, l&apos;unité et le cap.</translation>
    </message>
    <message>
        <source>{best} (agree with the positions to {best2:n} % of the speed)</source>
        <translation>{best} (concordent avec les positions à {best2} % de la vitesse)</translation>
    </message>
    <message>
        <source>The heading is taken {heading}: it then follows the course to {np:n} deg instead of {np2:n}.</source>
        <translation>Le cap est pris {heading} : il suit alors la route à {np}° au lieu de {np2}°.</translation>
    </message>
    <message>
        <source>The velocities count from true north although there is a wander angle (up to {np:n} deg), so the heading may do so too; it is taken less the wander angle, after Applanix: check with the writer of the file.</source>
        <translation>Les vitesses comptent depuis le nord vrai bien qu&apos;il y ait un angle de dérive (wander, jusqu&apos;à {np}°) ; le cap aussi, peut-être ; il est pris moins l&apos;angle de dérive, selon Applanix : vérifiez auprès de l&apos;auteur du fichier.</translation>
    </message>
    <message>
        <source>as Applanix states: roll positive starboard down, pitch positive bow up</source>
        <translation>comme l&apos;indique Applanix : roulis positif quand tribord descend, tangage positif quand l&apos;étrave monte</translation>
    </message>
    <message>
        <source>signs not checked</source>
        <translation>signes non vérifiés</translation>
    </message>
    <message>
        <source>All angular rates are zero, so the signs of roll and pitch could not be checked; they are taken {stated}.</source>
        <translation>Toutes les vitesses angulaires sont nulles : les signes du roulis et du tangage n&apos;ont pas pu être vérifiés ; ils sont pris {stated}.</translation>
    </message>
    <message>
        <source>The motion looked at is too small to check the sign of {unknown:list} against the angular rates; it is taken {stated}.</source>
        <translation>Le mouvement examiné est trop petit pour vérifier le signe par les vitesses angulaires ({unknown}) ; il est pris {stated}.</translation>
    </message>
    <message>
        <source>The angular rates say that signs differ from Applanix&apos;s: {facts:list}. This holds if the rates are in the writer&apos;s own body axes, x forward; check with the writer of the file.</source>
        <translation>Les vitesses angulaires disent que des signes diffèrent de ceux d&apos;Applanix : {facts}. Cela vaut si elles sont dans les axes propres de l&apos;auteur du fichier, x vers l&apos;avant ; vérifiez auprès de lui.</translation>
    </message>
    <message>
        <source>(by the angular rates)</source>
        <translation>(d&apos;après les vitesses angulaires)</translation>
    </message>
    <message>
        <source>{path:file}: {key2:kept} has to grow, by 360 deg at most.</source>
        <translation>{path} : {key2} doit croître, de 360° au plus.</translation>
    </message>
    <message>
        <source>{path:file}: {key2:kept} is empty; give the elevation of every beam.</source>
        <translation>{path} : {key2} est vide ; donnez l&apos;élévation de chaque faisceau.</translation>
    </message>
    <message>
        <source>{path:file}: {key2:kept} {name:kept} stands twice; give each target a name of its own.</source>
        <translation>{path} : {key2} {name} apparaît deux fois ; donnez à chaque cible un nom propre.</translation>
    </message>
    <message>
        <source>{path:file}: {key2:kept} is validation; a ball can only be a target.</source>
        <translation>{path} : {key2} est validation ; une sphère ne peut être que cible.</translation>
    </message>
    <message>
        <source>{path:file}: {key2:kept} is missing; say how far off the lines pass.</source>
        <translation>{path} : {key2} manque ; dites à quelle distance passent les lignes.</translation>
    </message>
    <message>
        <source>{path:file}: {key2:kept} mixes headings with start_s; give one of the two in all.</source>
        <translation>{path} : {key2} mêle des caps et start_s ; donnez l&apos;un des deux partout.</translation>
    </message>
    <message>
        <source>{path:file}: {key2:kept} holds a line of less than 1 m; give run_in_m and run_out_m.</source>
        <translation>{path} : {key2} contient une ligne de moins de 1 m ; donnez run_in_m et run_out_m.</translation>
    </message>
    <message>
        <source>coordinate list</source>
        <translation>liste de coordonnées</translation>
    </message>
    <message>
        <source>{path:file}: no row of coordinates is in it; give rows of name, x, y, z.</source>
        <translation>{path} : il ne contient aucune rangée de coordonnées ; donnez des rangées de nom, x, y, z.</translation>
    </message>
    <message>
        <source>{path:file}: no row of coordinates follows its names; export it again.</source>
        <translation>{path} : aucune rangée de coordonnées ne suit ses noms ; exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: more than {MOST:n} rows are in it, so it is no list of targets; leave only their rows in it.</source>
        <translation>{path} : il contient plus de {MOST} rangées et n&apos;est donc pas une liste de cibles ; n&apos;y laissez que leurs rangées.</translation>
    </message>
    <message>
        <source>name {twice:kept} twice</source>
        <translation>nomment {twice} deux fois</translation>
    </message>
    <message>
        <source>no name in front</source>
        <translation>ne commencent pas par un nom</translation>
    </message>
    <message>
        <source>{path:file}, row {row}: {count} of its {len:n} columns are numbers, and {named}; put a row of names above them (name, x, y, z), or state the columns.</source>
        <translation>{path}, rangée {row} : {count} de ses {len} colonnes sont des nombres, et {named} ; mettez au-dessus une rangée de noms (name, x, y, z), ou indiquez les colonnes.</translation>
    </message>
    <message>
        <source>{path:file}, row {row}: {count} of its {len:n} columns are numbers, and three coordinates are needed; put a row of names above them (name, x, y, z), or state the columns.</source>
        <translation>{path}, rangée {row} : {count} de ses {len} colonnes sont des nombres, et il faut trois coordonnées ; mettez au-dessus une rangée de noms (name, x, y, z), ou indiquez les colonnes.</translation>
    </message>
    <message>
        <source>three coordinates are needed</source>
        <translation>il faut trois coordonnées</translation>
    </message>
    <message>
        <source>{where}: it has {len:n} columns where {needed} are needed ({meant:kept}); complete the row or take it out.</source>
        <translation>{where} : elle a {len} colonnes où il en faut {needed} ({meant}) ; complétez la rangée ou retirez-la.</translation>
    </message>
    <message>
        <source>{where}: {axis:kept} is {axis2:foreign}, which is not a number; correct the row or take it out.</source>
        <translation>{where} : {axis} vaut {axis2}, ce qui n&apos;est pas un nombre ; corrigez la rangée ou retirez-la.</translation>
    </message>
    <message>
        <source>{where}: sigma is {text:foreign}, which is no number of metres that is zero or more; correct the row.</source>
        <translation>{where} : sigma vaut {text}, ce qui n&apos;est pas un nombre de mètres supérieur ou égal à zéro ; corrigez la rangée.</translation>
    </message>
    <message>
        <source>{path:file}, row {row}: {name:kept} stands in row {name2} already; give each target a name of its own.</source>
        <translation>{path}, rangée {row} : {name} est déjà dans la rangée {name2} ; donnez à chaque cible un nom propre.</translation>
    </message>
    <message>
        <source>{path:file}, row {row}: these coordinates stand in row {coordinates} already; one target is picked once.</source>
        <translation>{path}, rangée {row} : ces coordonnées sont déjà dans la rangée {coordinates} ; une cible se désigne une seule fois.</translation>
    </message>
    <message>
        <source>{path:file}: this {WHAT} holds no points; export it again.</source>
        <translation>{path} : ce fichier ({WHAT}) ne contient aucun point ; exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: a {WHAT} is read from LAS, LAZ, E57, PTS or text (x, y, z); export it as one of these.</source>
        <translation>{path} : un {WHAT} se lit en LAS, LAZ, E57, PTS ou texte (x, y, z) ; exportez-le sous l&apos;une de ces formes.</translation>
    </message>
    <message>
        <source>{path:file}: no row of coordinates is in it; give rows of x, y, z.</source>
        <translation>{path} : il ne contient aucune rangée de coordonnées ; donnez des rangées x, y, z.</translation>
    </message>
    <message>
        <source>{path:file}, row {sample:n}: a static scan as text is read with decimal points; this one has commas: export it again.</source>
        <translation>{path}, rangée {sample} : un balayage statique en texte se lit avec des points décimaux ; celui-ci a des virgules : exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>text of a {WHAT}</source>
        <translation>texte d&apos;un {WHAT}</translation>
    </message>
    <message>
        <source>{path:file}, row {number:n}: {error:foreign}; rows must be numbers.</source>
        <translation>{path}, rangée {number} : {error} ; les rangées doivent être des nombres.</translation>
    </message>
    <message>
        <source>Name of each column from the left, parted by blanks: time x y z are needed, - passes a column over; empty: as the first row of the file says</source>
        <translation>Nom de chaque colonne depuis la gauche, séparés par des blancs : time x y z sont nécessaires, - passe une colonne ; vide : comme le dit la première rangée du fichier</translation>
    </message>
    <message>
        <source>What parts the columns</source>
        <translation>Ce qui sépare les colonnes</translation>
    </message>
    <message>
        <source>Decimal sign</source>
        <translation>Signe décimal</translation>
    </message>
    <message>
        <source>not named</source>
        <translation>non nommées</translation>
    </message>
    <message>
        <source>The file does not name its columns: name them from the left, time x y z at least.</source>
        <translation>Le fichier ne nomme pas ses colonnes : nommez-les depuis la gauche, au moins time x y z.</translation>
    </message>
    <message>
        <source>time in {time_unit}s; points and trajectory share one time base</source>
        <translation>temps en {time_unit}s ; points et trajectoire ont la même base de temps</translation>
    </message>
    <message>
        <source>The head of the file speaks of feet: check the unit.</source>
        <translation>La tête du fichier parle de pieds : vérifiez l&apos;unité.</translation>
    </message>
    <message>
        <source>Times are as hh:mm:ss; the file does not say whether they are UTC: choose the time base (utc-day or gps-day).</source>
        <translation>Les temps sont en hh:mm:ss ; le fichier ne dit pas s&apos;ils sont en UTC : choisissez la base de temps (utc-day ou gps-day).</translation>
    </message>
    <message>
        <source>{path:file}: the file does not name its columns; name them from the left, time x y z at least.</source>
        <translation>{path} : le fichier ne nomme pas ses colonnes ; nommez-les depuis la gauche, au moins time x y z.</translation>
    </message>
    <message>
        <source>{path:file}: no row of four numbers or more is in it (a time is seconds, or hh:mm:ss without a date); this is not a text file of points.</source>
        <translation>{path} : il ne contient aucune rangée de quatre nombres ou plus (un temps est en secondes, ou hh:mm:ss sans date) ; ce n&apos;est pas un fichier texte de points.</translation>
    </message>
    <message>
        <source>{path:file}: rows must be numbers ({error:foreign}).</source>
        <translation>{path} : les rangées doivent être des nombres ({error}).</translation>
    </message>
    <message>
        <source>{path:file}: the file holds no rows of data; check what is stated of its separators and header, or export it again.</source>
        <translation>{path} : le fichier ne contient aucune rangée de données ; vérifiez ce qui est indiqué de ses séparateurs et de son en-tête, ou exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>By the name of its column x is in {said}, but {name:kept} is in {unit}: give the code of the same system in the unit of the file, or export in that of the system.</source>
        <translation>D&apos;après le nom de sa colonne, x est en {said}, mais {name} est en {unit} : donnez le code du même système dans l&apos;unité du fichier, ou exportez dans celle du système.</translation>
    </message>
    <message>
        <source>{path:file}: this is not sound TOML ({error:foreign}); correct it.</source>
        <translation>{path} : ce n&apos;est pas du TOML correct ({error}) ; corrigez-le.</translation>
    </message>
    <message>
        <source>{path:file}: {key2:kept} is {value:foreign}; give one of {words:kept}.</source>
        <translation>{path} : {key2} vaut {value} ; donnez l&apos;un de ces mots : {words}.</translation>
    </message>
    <message>
        <source>{path:file}: {key2:kept} is {value:foreign}; give true or false.</source>
        <translation>{path} : {key2} vaut {value} ; donnez true ou false.</translation>
    </message>
    <message>
        <source>{path:file}: {key2:kept} is {value:foreign}; give {many} in brackets.</source>
        <translation>{path} : {key2} vaut {value} ; donnez {many} entre crochets.</translation>
    </message>
    <message>
        <source>{path:file}: {key2:kept} is {value:foreign}, not a table; write [{key:kept}] above its keys.</source>
        <translation>{path} : {key2} vaut {value}, pas une table ; écrivez [{key}] au-dessus de ses clés.</translation>
    </message>
    <message>
        <source>{path:file}: {key2:kept} is no list of tables; write [[{key:kept}]] above each of them.</source>
        <translation>{path} : {key2} n&apos;est pas une liste de tables ; écrivez [[{key}]] au-dessus de chacune.</translation>
    </message>
    <message>
        <source>did you mean {near:kept}?</source>
        <translation>vouliez-vous dire {near} ?</translation>
    </message>
    <message>
        <source>known are {sorted:kept}</source>
        <translation>connus : {sorted}</translation>
    </message>
    <message>
        <source>{path:file}: {key2:kept} is not known here; {wanted}.</source>
        <translation>{path} : {key2} n&apos;est pas connu ici ; {wanted}.</translation>
    </message>
    <message>
        <source>{path:file}: {key2:kept} is not known here; it has to be named {key:kept}.</source>
        <translation>{path} : {key2} n&apos;est pas connu ici ; le nom doit être {key}.</translation>
    </message>
    <message>
        <source>{path:file}: {self:kept} is missing; add it.</source>
        <translation>{path} : {self} manque ; ajoutez-le.</translation>
    </message>
    <message>
        <source>{path:file}: {key2:kept} holds {value:foreign}, which is not a number; correct it.</source>
        <translation>{path} : {key2} contient {value}, qui n&apos;est pas un nombre ; corrigez-le.</translation>
    </message>
    <message>
        <source>{path:file}: {key2:kept} holds {value:n}; give {wanted}.</source>
        <translation>{path} : {key2} contient {value} ; donnez {wanted}.</translation>
    </message>
    <message>
        <source>{path:file}: {key2:kept} holds {value:n}; give at most {most:n}.</source>
        <translation>{path} : {key2} contient {value} ; donnez au plus {most}.</translation>
    </message>
    <message>
        <source>they fit no known time base; check which column or record is the time</source>
        <translation>ils ne conviennent à aucune base de temps connue ; vérifiez quelle colonne ou quel champ est le temps</translation>
    </message>
    <message>
        <source>{path:file}: times from {time:n} to {time2:n} cannot be {name}; {hint}.</source>
        <translation>{path} : des temps de {time} à {time2} ne peuvent être ceci : {name} ; {hint}.</translation>
    </message>
    <message>
        <source>{path:file}, {place}: a height of {height:n} m cannot be; check the columns and their unit.</source>
        <translation>{path}, {place} : une hauteur de {height} m est impossible ; vérifiez les colonnes et leur unité.</translation>
    </message>
    <message>
        <source>hours, minutes and seconds</source>
        <translation>heures, minutes et secondes</translation>
    </message>
    <message>
        <source>{path:file}, row {row:n}: a standard deviation is negative; check that this is the column of standard deviations, or export again.</source>
        <translation>{path}, rangée {row} : un écart-type est négatif ; vérifiez que c&apos;est bien la colonne des écarts-types, ou exportez de nouveau.</translation>
    </message>
    <message>
        <source>latitude and longitude (or easting and northing)</source>
        <translation>latitude et longitude (ou est et nord)</translation>
    </message>
    <message>
        <source>{path:file}: there is no column of {role}; export it too, or choose another file.</source>
        <translation>{path} : il manque une colonne ({role}) ; exportez-la aussi, ou choisissez un autre fichier.</translation>
    </message>
    <message>
        <source>{path:file}: the positions are eastings and northings; state their coordinate system (an EPSG code, EPSG:32619 say).</source>
        <translation>{path} : les positions sont des coordonnées est et nord ; indiquez leur système de coordonnées (un code EPSG, EPSG:32619 par exemple).</translation>
    </message>
    <message>
        <source>{path:file}: a heading from grid north needs eastings, northings and their coordinate system; state the system or choose a true heading.</source>
        <translation>{path} : un cap compté du nord de la grille demande les coordonnées est et nord et leur système de coordonnées ; indiquez le système ou choisissez un cap vrai.</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>un angle</translation>
    </message>
    <message>
        <source>{path:file}: column {name:kept} is in {UNIT_WORDS} by its header, and should be {wanted}; mend the header, or export it again.</source>
        <translation>{path} : la colonne {name} est en {UNIT_WORDS} d&apos;après son en-tête, et devrait être {wanted} ; corrigez l&apos;en-tête, ou exportez de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: its rows have a date, so their times are UTC or GPS seconds, not {name}; choose unix (UTC) or gps-full (GPS).</source>
        <translation>{path} : ses rangées ont une date ; leurs temps sont donc des secondes UTC ou GPS, et non ceci : {name} ; choisissez unix (UTC) ou gps-full (GPS).</translation>
    </message>
    <message>
        <source>they are degrees read as radians: state degrees</source>
        <translation>ce sont des degrés lus comme des radians : indiquez des degrés</translation>
    </message>
    <message>
        <source>check the columns and their unit</source>
        <translation>vérifiez les colonnes et leur unité</translation>
    </message>
    <message>
        <source>{path:file}, row {row:n}: latitude {lat:n} and longitude {lon:n} deg are not on Earth; {hint}.</source>
        <translation>{path}, rangée {row} : latitude {lat}° et longitude {lon}° ne sont pas sur la Terre ; {hint}.</translation>
    </message>
    <message>
        <source>{sum:n} per second</source>
        <translation>{sum} par seconde</translation>
    </message>
    <message>
        <source>Times from {time:n} to {time2:n} s fit no known time base; check which column or record is the time.</source>
        <translation>Des temps de {time} à {time2} s ne conviennent à aucune base de temps connue ; vérifiez quelle colonne ou quel champ est le temps.</translation>
    </message>
    <message>
        <source>points in gaps cannot be used</source>
        <translation>les points dans les lacunes ne peuvent servir</translation>
    </message>
    <message>
        <source>The trajectory has {wide:n} gaps longer than {longest_gap:n} s, the longest {float:n} s; {UNUSABLE}.</source>
        <translation>La trajectoire a {wide} lacunes de plus de {longest_gap} s, la plus longue de {float} s ; {UNUSABLE}.</translation>
    </message>
    <message>
        <source>The trajectory has {wide:n} gap longer than {longest_gap:n} s, the longest {float:n} s; {UNUSABLE}.</source>
        <translation>La trajectoire a {wide} lacune de plus de {longest_gap} s, la plus longue de {float} s ; {UNUSABLE}.</translation>
    </message>
    <message>
        <source>The positions move at {fast:n} m/s; degrees may have been read as radians, or the times may be in another unit.</source>
        <translation>Les positions se déplacent à {fast} m/s ; des degrés ont peut-être été lus comme des radians, ou les temps sont dans une autre unité.</translation>
    </message>
    <message>
        <source>The positions move at {fast:n} m/s in the middle, faster than a vessel; check the unit of the positions and of the times, and the coordinate system where there is one.</source>
        <translation>Les positions se déplacent à {fast} m/s en médiane, plus vite qu&apos;un navire ; vérifiez l&apos;unité des positions et des temps, et le système de coordonnées s&apos;il y en a un.</translation>
    </message>
    <message>
        <source>The positions jump: in places they move at up to {float:n} m/s, in the middle at {fast:n} m/s; look at the track and process the trajectory again.</source>
        <translation>Les positions sautent : par endroits elles se déplacent à {float} m/s, contre {fast} m/s en médiane ; regardez la trace et retraitez la trajectoire.</translation>
    </message>
    <message>
        <source>The carrier hardly moves in the part looked at, so heading and the order of latitude and longitude could not be checked against the course.</source>
        <translation>Le porteur ne bouge guère dans la partie examinée : le cap et l&apos;ordre de latitude et longitude n&apos;ont pas pu être comparés à la route.</translation>
    </message>
    <message>
        <source>Latitude and longitude look exchanged: the course then follows the heading.</source>
        <translation>Latitude et longitude semblent échangées : la route suit alors le cap.</translation>
    </message>
    <message>
        <source>The heading points backward along the course; check that it is the bow&apos;s and clockwise from north.</source>
        <translation>Le cap pointe vers l&apos;arrière de la route ; vérifiez que c&apos;est celui de l&apos;étrave, dans le sens horaire depuis le nord.</translation>
    </message>
    <message>
        <source>Heading and course over ground differ by {np:n} deg in the middle; check the heading, its unit and its sense.</source>
        <translation>Le cap et la route fond diffèrent de {np}° en médiane ; vérifiez le cap, son unité et son sens.</translation>
    </message>
    <message>
        <source>velocity north</source>
        <translation>vitesse nord</translation>
    </message>
    <message>
        <source>velocity east</source>
        <translation>vitesse est</translation>
    </message>
    <message>
        <source>velocity down</source>
        <translation>vitesse vers le bas</translation>
    </message>
    <message>
        <source>Which way the bow moves where pitch grows.</source>
        <translation>Dans quel sens bouge l&apos;étrave quand le tangage croît.</translation>
    </message>
    <message>
        <source>Which side goes down where roll grows; starboard down is port up.</source>
        <translation>Quel côté descend quand le roulis croît ; tribord descend veut dire bâbord monte.</translation>
    </message>
    <message>
        <source>What the times count.</source>
        <translation>Ce que comptent les temps.</translation>
    </message>
    <message>
        <source>{size:n} bytes are not a whole number of {SMRMSG_RECORD}-byte records: the file is empty, cut short or not smrmsg; copy or export it again.</source>
        <translation>{size} octets ne font pas un nombre entier d&apos;enregistrements de {SMRMSG_RECORD} octets : le fichier est vide, tronqué ou n&apos;est pas un smrmsg ; copiez-le ou exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>Applanix SBET</source>
        <translation>SBET d&apos;Applanix</translation>
    </message>
    <message>
        <source>Whether the wander angle has to be taken off the platform heading to get true heading.</source>
        <translation>Si l&apos;angle de dérive (wander) doit être retiré du cap de la plateforme pour obtenir le cap vrai.</translation>
    </message>
    <message>
        <source>Axes of the velocities; they serve to check the heading.</source>
        <translation>Axes des vitesses ; elles servent à vérifier le cap.</translation>
    </message>
    <message>
        <source>Unit of all angles.</source>
        <translation>Unité de tous les angles.</translation>
    </message>
    <message>
        <source>Which of the two positions stands first.</source>
        <translation>Laquelle des deux positions vient en premier.</translation>
    </message>
    <message>
        <source>Order of the bytes.</source>
        <translation>Ordre des octets.</translation>
    </message>
    <message>
        <source>Coordinate system of eastings and northings where there is no latitude (EPSG:...).</source>
        <translation>Système de coordonnées des coordonnées est et nord là où il n&apos;y a pas de latitude (EPSG:...).</translation>
    </message>
    <message>
        <source>Exail (iXblue) APPS or Delph INS text</source>
        <translation>Texte Exail (iXblue) APPS ou Delph INS</translation>
    </message>
    <message>
        <source>Applanix POSPac text</source>
        <translation>Texte Applanix POSPac</translation>
    </message>
    <message>
        <source>Text, columns stated</source>
        <translation>Texte, colonnes indiquées</translation>
    </message>
    <message>
        <source>What each column is, from the left: time, date, latitude, longitude, easting, northing, height, roll, pitch, heading; - passes one over.</source>
        <translation>Ce qu&apos;est chaque colonne, depuis la gauche : time, date, latitude, longitude, easting, northing, height, roll, pitch, heading ; - en passe une.</translation>
    </message>
    <message>
        <source>What stands between the columns.</source>
        <translation>Ce qui se trouve entre les colonnes.</translation>
    </message>
    <message>
        <source>Rows to pass over at the head; auto: up to the first of numbers.</source>
        <translation>Rangées à passer en tête ; auto : jusqu&apos;à la première rangée de nombres.</translation>
    </message>
    <message>
        <source>Unit of latitude and longitude.</source>
        <translation>Unité de la latitude et de la longitude.</translation>
    </message>
    <message>
        <source>Unit of roll, pitch and heading.</source>
        <translation>Unité du roulis, du tangage et du cap.</translation>
    </message>
    <message>
        <source>Unit of eastings and northings; empty: as in the coordinate system, of whose kind plain feet are too.</source>
        <translation>Unité des coordonnées est et nord ; vide : comme dans le système de coordonnées, qui dit aussi de quels pieds il s&apos;agit.</translation>
    </message>
    <message>
        <source>Unit of the heights; empty: as in the coordinate system where it has heights, else metres.</source>
        <translation>Unité des hauteurs ; vide : comme dans le système de coordonnées s&apos;il a des hauteurs, sinon le mètre.</translation>
    </message>
    <message>
        <source>North that the heading counts from.</source>
        <translation>Nord à partir duquel compte le cap.</translation>
    </message>
    <message>
        <source>Coordinate system of eastings and northings (EPSG:32619, say).</source>
        <translation>Système de coordonnées des coordonnées est et nord (EPSG:32619 par exemple).</translation>
    </message>
    <message>
        <source>CIDCO binary, states of its points</source>
        <translation>CIDCO binaire, états de ses points</translation>
    </message>
    <message>
        <source>CIDCO binary, sigmas of its states</source>
        <translation>CIDCO binaire, écarts-types de ses états</translation>
    </message>
    <message>
        <source>Applanix smrmsg</source>
        <translation>smrmsg d&apos;Applanix</translation>
    </message>
    <message>
        <source>Exail (iXblue) text, standard deviations</source>
        <translation>Texte Exail (iXblue), écarts-types</translation>
    </message>
    <message>
        <source>Applanix POSPac text, standard deviations</source>
        <translation>Texte Applanix POSPac, écarts-types</translation>
    </message>
    <message>
        <source>Column {name:kept} is in feet, the file does not say which, and {text:kept} is in {words}; feet of 0.3048 m are taken. US survey feet would put the positions metres elsewhere: make sure which they are, and state it or name it in the header.</source>
        <translation>La colonne {name} est en pieds, le fichier ne dit pas lesquels, et {text} est en {words} ; des pieds de 0.3048 m sont supposés. Les pieds d&apos;arpentage américains placeraient les positions à des mètres de là : assurez-vous de l&apos;unité, et indiquez-la ou nommez-la dans l&apos;en-tête.</translation>
    </message>
    <message>
        <source>{path:file}: eastings and northings lie outside {text:kept} ({name:kept}); state the coordinate system they are in, and check that they are not swapped.</source>
        <translation>{path} : les coordonnées est et nord sont hors de {text} ({name}) ; indiquez leur système de coordonnées et vérifiez qu&apos;elles ne sont pas échangées.</translation>
    </message>
    <message>
        <source>{path:file}: {text:kept} ({name:kept}) is not a projected coordinate system; state the one of the eastings and northings.</source>
        <translation>{path} : {text} ({name}) n&apos;est pas un système de coordonnées projeté ; indiquez celui des coordonnées est et nord.</translation>
    </message>
    <message>
        <source>No unit is stated for the heights in column {name:kept}, and eastings and northings are in {words}; metres are taken: make sure, and state feet if they are, or name them in the header.</source>
        <translation>Aucune unité n&apos;est indiquée pour les hauteurs de la colonne {name}, et les coordonnées est et nord sont en {words} ; le mètre est supposé : assurez-vous-en, et indiquez des pieds si c&apos;en sont, ou nommez-les dans l&apos;en-tête.</translation>
    </message>
    <message>
        <source>{path:file}: the coordinate system {text:kept} cannot be used ({said:foreign}); state an EPSG code such as EPSG:32619.</source>
        <translation>{path} : le système de coordonnées {text} ne peut être employé ({said}) ; indiquez un code EPSG tel que EPSG:32619.</translation>
    </message>
    <message>
        <source>The columns lack {missing:list}; a trajectory needs them.</source>
        <translation>Il manque aux colonnes : {missing} ; une trajectoire en a besoin.</translation>
    </message>
    <message>
        <source>Standard deviations are all zero; the file holds no accuracy.</source>
        <translation>Les écarts-types sont tous nuls ; le fichier ne contient pas de précision.</translation>
    </message>
    <message>
        <source>Standard deviations are large (in the middle {np:n} m and {np2:n} deg); check their unit.</source>
        <translation>Les écarts-types sont grands (médianes : {np} m et {np2}°) ; vérifiez leur unité.</translation>
    </message>
    <message>
        <source>The last rows do not go on from the first ones: the file may be cut short or its times run backward. The facts are those of the first rows; reading names the row.</source>
        <translation>Les dernières rangées ne font pas suite aux premières : le fichier est peut-être tronqué ou ses temps reculent. Les constats sont ceux des premières rangées ; la lecture nommera la rangée.</translation>
    </message>
    <message>
        <source>error of the lever arm</source>
        <translation>erreur du bras de levier</translation>
    </message>
    <message>
        <source>The {name} is beyond {most:n} {unit:kept}; give a smaller one.</source>
        <translation>Valeur au-delà de {most} {unit} ({name}) ; donnez-en une plus petite.</translation>
    </message>
    <message>
        <source>{path:file}: {key2:kept} is missing; write [[pos]] above each of its errors.</source>
        <translation>{path} : {key2} manque ; écrivez [[pos]] au-dessus de chacune de ses erreurs.</translation>
    </message>
    <message>
        <source>{path:file}: the point at {place:foreign} lies outside {name:kept} or its geoid grid ({int:n} such points): check the coordinate system.</source>
        <translation>{path} : le point {place} est hors de {name} ou de sa grille de géoïde (nombre de tels points : {int}) : vérifiez le système de coordonnées.</translation>
    </message>
    <message>
        <source>{path:file}: the points name no coordinate system; give its EPSG code, EPSG:32619 for example.</source>
        <translation>{path} : les points ne nomment pas de système de coordonnées ; donnez son code EPSG, EPSG:32619 par exemple.</translation>
    </message>
    <message>
        <source>{path:file}: the shift from {name:kept} to {name2:kept} changes with time: state the date of the survey as a decimal year (its epoch; at the command line --epoch 2024.5, or epoch=2024.5 among the options of a line).</source>
        <translation>{path} : le passage de {name} à {name2} change avec le temps : indiquez la date du levé en année décimale (son époque ; en ligne de commande --epoch 2024.5, ou epoch=2024.5 parmi les options d&apos;une ligne).</translation>
    </message>
    <message>
        <source>: as where feet are taken for metres, or metres for feet</source>
        <translation>, comme lorsque des pieds sont pris pour des mètres, ou des mètres pour des pieds</translation>
    </message>
    <message>
        <source>not stated; the values fit {fitting:either}</source>
        <translation>non indiquée ; les valeurs conviennent à {fitting}</translation>
    </message>
    <message>
        <source>The file states {name}, but times such as {float:n} are {fitting:either}: choose the time base.</source>
        <translation>Le fichier indique {name}, mais des temps tels que {float} sont {fitting} : choisissez la base de temps.</translation>
    </message>
    <message>
        <source>The velocities fit the axes {others:either} about as well: the motion looked at does not tell them apart.</source>
        <translation>Les vitesses conviennent aussi bien aux axes {others} : le mouvement examiné ne les distingue pas.</translation>
    </message>
    <message>
        <source>The times cannot be {stated}; by their values they are {bases:either}.</source>
        <translation>Les temps ne peuvent être ceci : {stated}. D&apos;après leurs valeurs, ils sont {bases}.</translation>
    </message>
    <message>
        <source>The times are taken as {name}; by their values alone they could also be {others:either}.</source>
        <translation>Base de temps supposée : {name}. D&apos;après leurs seules valeurs, les temps pourraient aussi être {others}.</translation>
    </message>
    <message>
        <source>{file:file}, row {row:n}</source>
        <translation>{file}, rangée {row}</translation>
    </message>
    <message>
        <source>, row {row:n}</source>
        <translation>, rangée {row}</translation>
    </message>
    <message>
        <source>row {row:n}</source>
        <translation>rangée {row}</translation>
    </message>
    <message>
        <source>record {k:n}</source>
        <translation>enregistrement {k}</translation>
    </message>
    <message>
        <source>{what:kept} record {k:n}</source>
        <translation>enregistrement {what} {k}</translation>
    </message>
    <message>
        <source>{n:n} numbers</source>
        <translation>{n} nombres</translation>
    </message>
    <message>
        <source>numbers</source>
        <translation>nombres</translation>
    </message>
    <message>
        <source>at least {n:n}</source>
        <translation>au moins {n}</translation>
    </message>
    <message>
        <source>more than {n:n}</source>
        <translation>plus de {n}</translation>
    </message>
    <message>
        <source>did you mean {near:kept}</source>
        <translation>vouliez-vous dire {near}</translation>
    </message>
    <message>
        <source>lack {names:kept}</source>
        <translation>n&apos;ont pas {names}</translation>
    </message>
    <message>
        <source>name {names:kept} twice</source>
        <translation>nomment {names} deux fois</translation>
    </message>
    <message>
        <source>positive {words}</source>
        <translation>positif : {words}</translation>
    </message>
    <message>
        <source>SBET</source>
        <translation>SBET</translation>
    </message>
    <message>
        <source>smrmsg</source>
        <translation>smrmsg</translation>
    </message>
    <message>
        <source>text</source>
        <translation>texte</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>maillage</translation>
    </message>
    <message>
        <source>survey</source>
        <translation>levé</translation>
    </message>
    <message>
        <source>logo</source>
        <translation>logo</translation>
    </message>
    <message>
        <source>trajectory accuracy</source>
        <translation>précision de la trajectoire</translation>
    </message>
    <message>
        <source>trajectory</source>
        <translation>trajectoire</translation>
    </message>
    <message>
        <source>line</source>
        <translation>ligne</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>fichier ou dossier introuvable</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>accès refusé</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>le disque est plein</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>c&apos;est un dossier</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>ce n&apos;est pas un dossier</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>nom de fichier trop long</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>disque en lecture seule</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>erreur d&apos;entrée-sortie</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>quota de disque dépassé</translation>
    </message>
    <message>
        <source>LAS</source>
        <translation>LAS</translation>
    </message>
    <message>
        <source>LAZ</source>
        <translation>LAZ</translation>
    </message>
    <message>
        <source>CIDCO</source>
        <translation>CIDCO</translation>
    </message>
    <message>
        <source>CIDCO binary</source>
        <translation>CIDCO binaire</translation>
    </message>
    <message>
        <source>{view:foreign} (stated, not applied)</source>
        <translation>{view} (indiqué, non appliqué)</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>secondes</translation>
    </message>
    <message>
        <source>date</source>
        <translation>date</translation>
    </message>
    <message>
        <source>latitude</source>
        <translation>latitude</translation>
    </message>
    <message>
        <source>longitude</source>
        <translation>longitude</translation>
    </message>
    <message>
        <source>time</source>
        <translation>temps</translation>
    </message>
    <message>
        <source>Exail text</source>
        <translation>texte Exail</translation>
    </message>
    <message>
        <source>POSPac text</source>
        <translation>texte POSPac</translation>
    </message>
    <message>
        <source>Smrmsg</source>
        <translation>Smrmsg</translation>
    </message>
    <message>
        <source>{role} standard deviation</source>
        <translation>écart-type ({role})</translation>
    </message>
    <message>
        <source>starboard down</source>
        <translation>tribord vers le bas</translation>
    </message>
    <message>
        <source>port down</source>
        <translation>bâbord vers le bas</translation>
    </message>
    <message>
        <source>bow up</source>
        <translation>étrave vers le haut</translation>
    </message>
    <message>
        <source>bow down</source>
        <translation>étrave vers le bas</translation>
    </message>
    <message>
        <source>Smrmsg record {k:n} holds a value that is not a number ({such}); export it again.</source>
        <translation>L&apos;enregistrement smrmsg {k} contient une valeur qui n&apos;est pas un nombre ({such}) ; exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>SBET record {k:n} holds a value that is not a number ({such}); export it again.</source>
        <translation>L&apos;enregistrement SBET {k} contient une valeur qui n&apos;est pas un nombre ({such}) ; exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>position</source>
        <translation>position</translation>
    </message>
    <message>
        <source>attitude</source>
        <translation>attitude</translation>
    </message>
    <message>
        <source>LiDAR sigma</source>
        <translation>écart-type du LiDAR</translation>
    </message>
    <message>
        <source>lever arm</source>
        <translation>bras de levier</translation>
    </message>
    <message>
        <source>boresight</source>
        <translation>angles de visée</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>origine</translation>
    </message>
    <message>
        <source>correlation time</source>
        <translation>temps de corrélation</translation>
    </message>
    <message>
        <source>surface sigma</source>
        <translation>écart-type des surfaces</translation>
    </message>
    <message>
        <source>longest gap</source>
        <translation>plus longue lacune</translation>
    </message>
    <message>
        <source>north</source>
        <translation>nord</translation>
    </message>
    <message>
        <source>east</source>
        <translation>est</translation>
    </message>
    <message>
        <source>{base}, stated</source>
        <translation>{base} (indiqué)</translation>
    </message>
    <message>
        <source>about {n:n}</source>
        <translation>environ {n}</translation>
    </message>
    <message>
        <source>{a:n} to {b:n} m</source>
        <translation>{a} à {b} m</translation>
    </message>
    <message>
        <source>{a:n} to {b:n} m/s</source>
        <translation>{a} à {b} m/s</translation>
    </message>
    <message>
        <source>{m:n} min {s:n} s</source>
        <translation>{m} min {s} s</translation>
    </message>
    <message>
        <source>{h:n} h {m:n} min</source>
        <translation>{h} h {m} min</translation>
    </message>
    <message>
        <source>roll positive {side}</source>
        <translation>roulis positif : {side}</translation>
    </message>
    <message>
        <source>pitch positive {side}</source>
        <translation>tangage positif : {side}</translation>
    </message>
    <message>
        <source>{facts:list} (by the angular rates)</source>
        <translation>{facts} (d&apos;après les vitesses angulaires)</translation>
    </message>
    <message>
        <source>format</source>
        <translation>format</translation>
    </message>
    <message>
        <source>points</source>
        <translation>points</translation>
    </message>
    <message>
        <source>coordinate system</source>
        <translation>système de coordonnées</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>repère</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>unité</translation>
    </message>
    <message>
        <source>resolution</source>
        <translation>résolution</translation>
    </message>
    <message>
        <source>time base</source>
        <translation>base de temps</translation>
    </message>
    <message>
        <source>x from, to</source>
        <translation>x de, à</translation>
    </message>
    <message>
        <source>y from, to</source>
        <translation>y de, à</translation>
    </message>
    <message>
        <source>z from, to</source>
        <translation>z de, à</translation>
    </message>
    <message>
        <source>attributes</source>
        <translation>attributs</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>supposé</translation>
    </message>
    <message>
        <source>comments</source>
        <translation>commentaires</translation>
    </message>
    <message>
        <source>header</source>
        <translation>en-tête</translation>
    </message>
    <message>
        <source>fields</source>
        <translation>champs</translation>
    </message>
    <message>
        <source>viewpoint</source>
        <translation>point de vue</translation>
    </message>
    <message>
        <source>georeferenced</source>
        <translation>géoréférencé</translation>
    </message>
    <message>
        <source>scanner</source>
        <translation>scanneur</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>Records</source>
        <translation>Enregistrements</translation>
    </message>
    <message>
        <source>Velocities</source>
        <translation>Vitesses</translation>
    </message>
    <message>
        <source>Roll and pitch</source>
        <translation>Roulis et tangage</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Cadence</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Latitude</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Longitude</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Sigma north</source>
        <translation>Écart-type nord</translation>
    </message>
    <message>
        <source>Sigma east</source>
        <translation>Écart-type est</translation>
    </message>
    <message>
        <source>Sigma height</source>
        <translation>Écart-type hauteur</translation>
    </message>
    <message>
        <source>Sigma roll</source>
        <translation>Écart-type roulis</translation>
    </message>
    <message>
        <source>Sigma pitch</source>
        <translation>Écart-type tangage</translation>
    </message>
    <message>
        <source>Sigma heading</source>
        <translation>Écart-type cap</translation>
    </message>
    <message>
        <source>Header</source>
        <translation>En-tête</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Colonnes</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Rangées</translation>
    </message>
    <message>
        <source>separator</source>
        <translation>séparateur</translation>
    </message>
    <message>
        <source>blank</source>
        <translation>blanc</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>virgule</translation>
    </message>
    <message>
        <source>semicolon</source>
        <translation>point-virgule</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>tabulation</translation>
    </message>
    <message>
        <source>decimal</source>
        <translation>signe décimal</translation>
    </message>
    <message>
        <source>point</source>
        <translation>point</translation>
    </message>
    <message>
        <source>columns</source>
        <translation>colonnes</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>rangées</translation>
    </message>
    <message>
        <source>In {text:kept} ({name:kept}) the positions lie at latitude {middle:n}, longitude {middle2:n} deg, and it is meant for {elsewhere:foreign}: check the coordinate system, the unit of eastings and northings (feet, metres), and their order.</source>
        <translation>En {text} ({name}), les positions sont à la latitude {middle}°, longitude {middle2}°, alors que le système est prévu pour {elsewhere} : vérifiez le système de coordonnées, l&apos;unité des coordonnées est et nord (pieds, mètres), et leur ordre.</translation>
    </message>
    <message>
        <source>{path:file}: {foreign:kept} is no axis of the local frame (north, west, up); say which coordinate system the list is in.</source>
        <translation>{path} : {foreign} n&apos;est pas un axe du repère local (nord, ouest, haut) ; dites dans quel système de coordonnées est la liste.</translation>
    </message>
    <message>
        <source>{path:file}, row {row:n}: {foreign:kept} is no axis of the local frame (north, west, up); say which coordinate system the list is in.</source>
        <translation>{path}, rangée {row} : {foreign} n&apos;est pas un axe du repère local (nord, ouest, haut) ; dites dans quel système de coordonnées est la liste.</translation>
    </message>
    <message>
        <source>{path:file}: the columns {said}; name them from the left: name, x, y, z for example, and - for one that is not used.</source>
        <translation>{path} : les colonnes {said} ; nommez-les depuis la gauche : name, x, y, z par exemple, et - pour celles qui ne servent pas.</translation>
    </message>
    <message>
        <source>{path:file}, row {row:n}: the columns {said}; name them from the left: name, x, y, z for example, and - for one that is not used.</source>
        <translation>{path}, rangée {row} : les colonnes {said} ; nommez-les depuis la gauche : name, x, y, z par exemple, et - pour celles qui ne servent pas.</translation>
    </message>
    <message>
        <source>The positions move at {ratio:n} times the speed in {a:kept} and {b:kept}; check the unit of the positions and the coordinate system.</source>
        <translation>Les positions se déplacent à {ratio} fois la vitesse que donnent {a} et {b} ; vérifiez l&apos;unité des positions et le système de coordonnées.</translation>
    </message>
    <message>
        <source>The positions move at {ratio:n} times the speed in {a:kept} and {b:kept}: as where feet are taken for metres, or metres for feet; check the unit of the positions and the coordinate system.</source>
        <translation>Les positions se déplacent à {ratio} fois la vitesse que donnent {a} et {b}, comme lorsque des pieds sont pris pour des mètres, ou des mètres pour des pieds ; vérifiez l&apos;unité des positions et le système de coordonnées.</translation>
    </message>
    <message>
        <source>times restart at {where} (after {t:n} s): counted on by {period:n} s</source>
        <translation>les temps repartent de zéro à {where} (après {t} s) : comptés ensuite avec {period} s de plus</translation>
    </message>
    <message>
        <source>times restart at {where}: counted on by {period:n} s</source>
        <translation>les temps repartent de zéro à {where} : comptés ensuite avec {period} s de plus</translation>
    </message>
    <message>
        <source>they lie outside the local frame</source>
        <translation>elles sont hors du repère local</translation>
    </message>
    <message>
        <source>in the local frame they are {distance:n} km from the trajectory</source>
        <translation>dans le repère local, elles sont à {distance} km de la trajectoire</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>une longueur</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>The heading is taken as is: it then follows the course to {np:n} deg instead of {np2:n}.</source>
        <translation>Le cap est pris tel quel : il suit alors la route à {np}° au lieu de {np2}°.</translation>
    </message>
    <message>
        <source>The heading is taken less the wander angle: it then follows the course to {np:n} deg instead of {np2:n}.</source>
        <translation>Le cap est pris moins l&apos;angle de dérive (wander) : il suit alors la route à {np}° au lieu de {np2}°.</translation>
    </message>
    <message>
        <source>{path:file}: {size:n} bytes are not a whole number of {record}-byte {what} records (the last one has {record2}); the file is cut short or not {what2}: copy or export it again.</source>
        <translation>{path} : {size} octets ne font pas un nombre entier d&apos;enregistrements {what} de {record} octets (le dernier en a {record2}) ; le fichier est tronqué ou d&apos;un autre format que {what2} : copiez-le ou exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: times stand on steps of {resolution:n} s from {place} on, as if they had gone through 32-bit numbers; export with 64-bit times.</source>
        <translation>{path} : les temps vont par pas de {resolution} s ({place} et suivants), comme s&apos;ils étaient passés par des nombres de 32 bits ; exportez avec des temps de 64 bits.</translation>
    </message>
    <message>
        <source>run backward</source>
        <translation>reculent</translation>
    </message>
    <message>
        <source>{path:file}: time runs from {time:n} to {time2:n} s at {place} ({counted:list} of {len:n}); times must increase: sort the file or export it again.</source>
        <translation>{path} : le temps passe de {time} à {time2} s ({place}) ; sur {len} temps, {counted} ; les temps doivent croître : triez le fichier ou exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: this {what} file is empty; copy or export it again.</source>
        <translation>{path} : ce fichier ({what}) est vide ; copiez-le ou exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: {size:n} bytes are nothing; export it again.</source>
        <translation>{path} : un fichier de {size} octets est vide ; exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>{name}: {name2:kept} cannot be {value:kept}; choose {choices:codes}.</source>
        <translation>{name} : {name2} ne peut être {value} ; choisissez {choices}.</translation>
    </message>
    <message>
        <source>{path:file}: the points have no timeStamp (fields: {none:foreign}), so they cannot be put on the trajectory; export with time stamps.</source>
        <translation>{path} : les points n&apos;ont pas de timeStamp (champs : {none}) et ne peuvent donc être placés sur la trajectoire ; exportez avec les temps.</translation>
    </message>
    <message>
        <source>{path:file}: no field holds a time (it has {none:foreign}), so the points cannot be put on the trajectory; export with time, or name the field.</source>
        <translation>{path} : aucun champ ne contient un temps (champs : {none}) et les points ne peuvent être placés sur la trajectoire ; exportez avec le temps, ou nommez le champ.</translation>
    </message>
    <message>
        <source>{path:file}: the column names given ({none:foreign}) lack {missing:kept}; name every column of the file from the left.</source>
        <translation>{path} : aux noms de colonnes donnés ({none}) il manque {missing} ; nommez chaque colonne du fichier depuis la gauche.</translation>
    </message>
    <message>
        <source>{n:n} such point</source>
        <translation>{n} point de ce genre</translation>
    </message>
    <message>
        <source>{n:n} such points</source>
        <translation>{n} points de ce genre</translation>
    </message>
    <message>
        <source>{n:n} such record</source>
        <translation>{n} enregistrement de ce genre</translation>
    </message>
    <message>
        <source>{n:n} such records</source>
        <translation>{n} enregistrements de ce genre</translation>
    </message>
    <message>
        <source>1 repeat</source>
        <translation>1 se répète</translation>
    </message>
    <message>
        <source>{n:n} repeat</source>
        <translation>{n} se répètent</translation>
    </message>
    <message>
        <source>1 run backward</source>
        <translation>1 recule</translation>
    </message>
    <message>
        <source>{n:n} run backward</source>
        <translation>{n} reculent</translation>
    </message>
    <message>
        <source>choose {names:codes}</source>
        <translation>choisissez {names}</translation>
    </message>
    <message>
        <source>easting</source>
        <translation>la coordonnée est</translation>
    </message>
    <message>
        <source>northing</source>
        <translation>la coordonnée nord</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>(aucune)</translation>
    </message>
    <message>
        <source>{path:file}, row {k:n}: {column:kept} is {value:foreign}; rows must be numbers.</source>
        <translation>{path}, rangée {k} : {column} vaut {value} ; les rangées doivent être des nombres.</translation>
    </message>
    <message>
        <source>{file:file}, row {row:n}: {said}</source>
        <translation>{file}, rangée {row} : {said}</translation>
    </message>
    <message>
        <source>plan</source>
        <translation>plan</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>cylindre</translation>
    </message>
    <message>
        <source>board</source>
        <translation>panneau</translation>
    </message>
    <message>
        <source>wall</source>
        <translation>mur</translation>
    </message>
    <message>
        <source>ball</source>
        <translation>sphère</translation>
    </message>
    <message>
        <source>{path:file}: line {number:n} is no sound vertex ({text:foreign}); export the mesh again.</source>
        <translation>{path} : la ligne {number} n&apos;est pas un sommet correct ({text}) ; exportez le maillage de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: line {number:n} is no sound face ({text:foreign}); export the mesh again.</source>
        <translation>{path} : la ligne {number} n&apos;est pas une face correcte ({text}) ; exportez le maillage de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: the file ends after point {done:n} of the {count:n} that row {head:n} promises, so it is cut short; copy or export it again.</source>
        <translation>{path} : le fichier finit après le point {done} des {count} que la rangée {head} annonce, il est donc tronqué ; copiez-le ou exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}, row {row:n}: the points that row {head:n} promises ({count:n}) end above this row, and it is no number of points; copy or export it again.</source>
        <translation>{path}, rangée {row} : les points que la rangée {head} annonce ({count}) finissent au-dessus de cette rangée, et elle n&apos;est pas un nombre de points ; copiez-le ou exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}, row {row:n}: a PTS file begins with its number of points, and this is {text:kept}; export it again, or give a text of x, y, z the ending .txt.</source>
        <translation>{path}, rangée {row} : un fichier PTS commence par son nombre de points, et ceci est {text} ; exportez-le de nouveau, ou donnez à un texte x, y, z l&apos;extension .txt.</translation>
    </message>
    <message>
        <source>{path:file}, row {row:n}: a new number of points stands here after {k:n} of the {count:n} points that row {head:n} promises; copy or export it again.</source>
        <translation>{path}, rangée {row} : un nouveau nombre de points se trouve ici après {k} des {count} points que la rangée {head} annonce ; copiez-le ou exportez-le de nouveau.</translation>
    </message>
</context>
<context>
    <name>report</name>
    <message>
        <source>Reading {name:kept} for its digest</source>
        <translation>Lecture de {name} pour son empreinte</translation>
    </message>
    <message>
        <source>Dot and bar: a calibration with its 95 % interval (brown: the mounting has moved). Line and band:
mean of those before, and three sigmas of the difference.</source>
        <translation>Point et barre : un étalonnage avec son intervalle à 95 % (brun : le montage a bougé). Ligne et bande :
moyenne des précédents et trois écarts-types de la différence.</translation>
    </message>
    <message>
        <source>POS errors that drift</source>
        <translation>Erreurs du POS qui dérivent</translation>
    </message>
    <message>
        <source>every point its own POS error (thesis)</source>
        <translation>chaque point avec sa propre erreur du POS (thèse)</translation>
    </message>
    <message>
        <source>not determined</source>
        <translation>non déterminés</translation>
    </message>
    <message>
        <source>1 sigma (deg)</source>
        <translation>Écart-type (°)</translation>
    </message>
    <message>
        <source>Minutes on site (targets × lines beside each)</source>
        <translation>Minutes sur place (cibles x lignes à côté de chacune)</translation>
    </message>
    <message>
        <source>Lines, in this order</source>
        <translation>Lignes, dans cet ordre</translation>
    </message>
    <message>
        <source>This plan does not determine the boresight.</source>
        <translation>Ce plan ne détermine pas les angles de visée.</translation>
    </message>
    <message>
        <source>Expected (1 sigma): roll {sigma:n}, pitch {sigma2:n}, yaw {sigma3:n} deg; {duration:n} minutes of lines</source>
        <translation>Attendu (1 sigma) : roulis {sigma}°, tangage {sigma2}°, lacet {sigma3}° ; {duration} minutes de lignes</translation>
    </message>
    <message>
        <source>From above; numbers stand where a line begins, opposite lines are drawn beside each other</source>
        <translation>Vu d&apos;en haut ; les numéros sont au début des lignes, les lignes opposées sont dessinées côte à côte</translation>
    </message>
    <message>
        <source>Along the wall, to the right as seen from the water (m)</source>
        <translation>Le long du mur, vers la droite vu de l&apos;eau (m)</translation>
    </message>
    <message>
        <source>Above POS (m)</source>
        <translation>Au-dessus du POS (m)</translation>
    </message>
    <message>
        <source>off the wall (m)</source>
        <translation>au mur (m)</translation>
    </message>
    <message>
        <source>above POS (m)</source>
        <translation>au-dessus du POS (m)</translation>
    </message>
    <message>
        <source>from level (deg)</source>
        <translation>sur l&apos;horizontale (°)</translation>
    </message>
    <message>
        <source>faces (deg)</source>
        <translation>fait face à (°)</translation>
    </message>
    <message>
        <source>heading (deg)</source>
        <translation>cap (°)</translation>
    </message>
    <message>
        <source>site on</source>
        <translation>site sur</translation>
    </message>
    <message>
        <source>off wall (m)</source>
        <translation>au mur (m)</translation>
    </message>
    <message>
        <source>straight from, to (m)</source>
        <translation>droit de, à (m)</translation>
    </message>
    <message>
        <source>{degrees:n}, leans back</source>
        <translation>{degrees}, penche en arrière</translation>
    </message>
    <message>
        <source>{degrees:n}, leans forward</source>
        <translation>{degrees}, penche en avant</translation>
    </message>
    <message>
        <source>The report could not be set ({message:foreign}).</source>
        <translation>Le rapport n&apos;a pas pu être composé ({message}).</translation>
    </message>
    <message>
        <source>Type I: is it still a board, near where it stands?</source>
        <translation>Type I : est-ce encore un panneau, près de là où il se trouve ?</translation>
    </message>
    <message>
        <source>Type II: how far the board is shifted</source>
        <translation>Type II : de combien le panneau est déplacé</translation>
    </message>
    <message>
        <source>Signed orthogonal distance (m)</source>
        <translation>Distance orthogonale signée (m)</translation>
    </message>
    <message>
        <source>Type II: how far the board is turned</source>
        <translation>Type II : de combien le panneau est tourné</translation>
    </message>
    <message>
        <source>Angular deviation (deg)</source>
        <translation>Écart angulaire (°)</translation>
    </message>
    <message>
        <source>Inclination of the board (deg; positive leans to the vessel)</source>
        <translation>Inclinaison du panneau (° ; positif penche vers le navire)</translation>
    </message>
    <message>
        <source>Line (deg)</source>
        <translation>Ligne (°)</translation>
    </message>
    <message>
        <source>Inclination (deg)</source>
        <translation>Inclinaison (°)</translation>
    </message>
    <message>
        <source>Centroidal distance (m)</source>
        <translation>Distance centroïdale (m)</translation>
    </message>
    <message>
        <source>{label} at {np:n} deg on line {said:foreign}</source>
        <translation>{label} à {np}° sur la ligne {said}</translation>
    </message>
    <message>
        <source>Kept (deg)</source>
        <translation>Gardées (°)</translation>
    </message>
    <message>
        <source>Thesis keeps</source>
        <translation>La thèse garde</translation>
    </message>
    <message>
        <source>Best (deg)</source>
        <translation>Meilleure (°)</translation>
    </message>
    <message>
        <source>Lines that differ</source>
        <translation>Lignes différentes</translation>
    </message>
    <message>
        <source>Inclination is</source>
        <translation>Inclinaison</translation>
    </message>
    <message>
        <source>Lines are</source>
        <translation>Lignes</translation>
    </message>
    <message>
        <source>Why not</source>
        <translation>Pourquoi non</translation>
    </message>
    <message>
        <source>the same as</source>
        <translation>les mêmes que</translation>
    </message>
    <message>
        <source>others than</source>
        <translation>d&apos;autres que</translation>
    </message>
    <message>
        <source>Fewest lines that show every error: {sets:foreign}.</source>
        <translation>Le moins de lignes qui montrent toutes les erreurs : {sets}.</translation>
    </message>
    <message>
        <source>Heights are above the vessel&apos;s POS. The distance is from the middle of the site to the line; off wall: the least on the way; straight from, to: metres along the line before and after the middle is abeam. Keep course and speed there. The order of the lines counts. Hang the boards flat and firm: the sigmas rest on their not moving by a millimetre. Headings are from true north. Along is counted to the right from the middle of the site: mark it on the wall first.</source>
        <translation>Les hauteurs sont au-dessus du POS du navire. La distance va du milieu du site à la ligne ; au mur : la plus petite en chemin ; droit de, à : mètres le long de la ligne avant et après le travers du milieu. Tenez-y cap et vitesse. L&apos;ordre des lignes compte. Posez les panneaux bien plans et solidement : les écarts-types supposent qu&apos;ils ne bougent pas d&apos;un millimètre. Les caps sont comptés du nord vrai. « Le long » se compte vers la droite depuis le milieu du site : marquez-le d&apos;abord sur le mur.</translation>
    </message>
    <message>
        <source>And {others} more like these.</source>
        <translation>Et {others} autres du même genre.</translation>
    </message>
    <message>
        <source>Expected with a POS of {mm:kept} mm (north, east, up) and {deg:kept} deg (roll, pitch, heading), and targets flat to {flatness:n} mm.</source>
        <translation>Attendu avec un POS de {mm} mm (nord, est, haut) et {deg}° (roulis, tangage, cap), et des cibles planes à {flatness} mm près.</translation>
    </message>
</context>
<context>
    <name>simulation</name>
    <message>
        <source>Meshes are ready</source>
        <translation>Les maillages sont prêts</translation>
    </message>
    <message>
        <source>Scanned line {x} of {len:n}</source>
        <translation>Ligne {x} balayée sur {len}</translation>
    </message>
    <message>
        <source>With a latency of {latency:n} s the lines lead out of the trajectory; give a smaller one, or let the vessel wait longer (wait_s).</source>
        <translation>Avec une latence de {latency} s, les lignes sortent de la trajectoire ; donnez-en une plus petite, ou laissez le navire attendre plus longtemps (wait_s).</translation>
    </message>
    <message>
        <source>Line {x} is to be recorded from {ends:n} to {ends2:n} s, where the trajectory ({time:n} to {time2:n} s) has no states or a gap: give start_s and stop_s inside it, in its own time.</source>
        <translation>La ligne {x} est à enregistrer de {ends} à {ends2} s, où la trajectoire (de {time} à {time2} s) n&apos;a pas d&apos;états ou a une lacune : donnez start_s et stop_s à l&apos;intérieur, dans son propre temps.</translation>
    </message>
    <message>
        <source>Fewest lines that show every error: {sets:foreign} (the same as the {n:n} of the thesis&apos;s table 3.3).</source>
        <translation>Le moins de lignes qui montrent toutes les erreurs : {sets} (les mêmes que les {n} du tableau 3.3 de la thèse).</translation>
    </message>
    <message>
        <source>Fewest lines that show every error: {sets:foreign} (others than the {n:n} of the thesis&apos;s table 3.3).</source>
        <translation>Le moins de lignes qui montrent toutes les erreurs : {sets} (d&apos;autres que les {n} du tableau 3.3 de la thèse).</translation>
    </message>
</context>
<context>
    <name>survey</name>
    <message>
        <source>X {x} and Y {y} lie on one line; give two different lines.</source>
        <translation>X {x} et Y {y} sont sur une même droite ; donnez deux droites différentes.</translation>
    </message>
    <message>
        <source>the signs follow from the axes stated, by the right-hand rule</source>
        <translation>les signes découlent des axes indiqués, par la règle de la main droite</translation>
    </message>
    <message>
        <source>{name:kept}: the body axes {in_words} are left-handed, so no rotation leads there from scanner axes that stay as they are; let the scanner&apos;s axes be turned with the body&apos;s.</source>
        <translation>{name} : les axes du navire {in_words} sont indirects ; aucune rotation n&apos;y mène donc depuis des axes du scanneur laissés tels quels ; faites tourner les axes du scanneur avec ceux du navire.</translation>
    </message>
    <message>
        <source>{name:kept} is not offered as angles, only as a matrix; give or take that.</source>
        <translation>{name} n&apos;est pas proposé en angles, seulement en matrice ; donnez ou prenez celle-ci.</translation>
    </message>
    <message>
        <source>A rotation needs three rows of three numbers; correct the matrix.</source>
        <translation>Une rotation demande trois rangées de trois nombres ; corrigez la matrice.</translation>
    </message>
    <message>
        <source>The matrix is not a rotation: its rows are off by {off:n} from being orthogonal and of length one; give six decimals or more, and no scale.</source>
        <translation>La matrice n&apos;est pas une rotation : ses rangées s&apos;écartent de {off} de l&apos;orthogonalité et de la longueur un ; donnez six décimales ou plus, et pas d&apos;échelle.</translation>
    </message>
    <message>
        <source>The matrix mirrors (determinant -1) instead of rotating: one axis has the wrong sign; check the directions of the axes.</source>
        <translation>La matrice est un miroir (déterminant -1) et non une rotation : un axe a le mauvais signe ; vérifiez les directions des axes.</translation>
    </message>
    <message>
        <source>The lever arm given here replaces that of the present matrix.</source>
        <translation>Le bras de levier donné ici remplace celui de la matrice actuelle.</translation>
    </message>
    <message>
        <source>The lever arm is that of the present matrix, unchanged: none was given here.</source>
        <translation>Le bras de levier est celui de la matrice actuelle, inchangé : aucun n&apos;a été donné ici.</translation>
    </message>
    <message>
        <source>The lines are taken as turned and moved by the present 4x4 matrix, so its lever arm is part of the new one: the one given here stands on top of it. Where they were only turned, give the 3x3 alone.</source>
        <translation>Les lignes sont considérées comme tournées et déplacées par la matrice 4x4 actuelle ; son bras de levier fait donc partie du nouveau : celui donné ici s&apos;y ajoute. Si elles ont seulement été tournées, donnez la 3x3 seule.</translation>
    </message>
    <message>
        <source>The lines are taken as turned and moved by the present 4x4 matrix, so its lever arm is the new one, turned by what was found. Where they were only turned, give the 3x3 alone and the lever arm of the lines.</source>
        <translation>Les lignes sont considérées comme tournées et déplacées par la matrice 4x4 actuelle ; son bras de levier, tourné de ce qui a été trouvé, est donc le nouveau. Si elles ont seulement été tournées, donnez la 3x3 seule et le bras de levier des lignes.</translation>
    </message>
    <message>
        <source>There is no system named {key:kept}; choose one of {known:kept}.</source>
        <translation>Il n&apos;y a pas de système nommé {key} ; choisissez parmi : {known}.</translation>
    </message>
    <message>
        <source>{where:kept}: {error:foreign}; give a matrix of 3x3 or 4x4 numbers.</source>
        <translation>{where} : {error} ; donnez une matrice de 3x3 ou 4x4 nombres.</translation>
    </message>
    <message>
        <source>{where:kept}: the last row of a 4x4 matrix is 0 0 0 1; give rows, not columns.</source>
        <translation>{where} : la dernière rangée d&apos;une matrice 4x4 est 0 0 0 1 ; donnez des rangées, pas des colonnes.</translation>
    </message>
    <message>
        <source>{where:kept}: a number of the lever arm is not finite; correct it.</source>
        <translation>{where} : un nombre du bras de levier n&apos;est pas fini ; corrigez-le.</translation>
    </message>
    <message>
        <source>is turned {turned} deg to starboard</source>
        <translation>est tourné de {turned}° vers tribord</translation>
    </message>
    <message>
        <source>is turned {turned} deg to port</source>
        <translation>est tourné de {turned}° vers bâbord</translation>
    </message>
    <message>
        <source>The scanner is parallel to the body.</source>
        <translation>Le scanneur est parallèle au navire.</translation>
    </message>
    <message>
        <source>(first turned, then pitched, then rolled)</source>
        <translation>(tourné d&apos;abord, puis tangué, puis roulé)</translation>
    </message>
    <message>
        <source>forward of</source>
        <translation>vers l&apos;avant</translation>
    </message>
    <message>
        <source>aft of</source>
        <translation>vers l&apos;arrière</translation>
    </message>
    <message>
        <source>to port of</source>
        <translation>vers bâbord</translation>
    </message>
    <message>
        <source>to starboard of</source>
        <translation>vers tribord</translation>
    </message>
    <message>
        <source>The scanner&apos;s optical centre is at the POS centre.</source>
        <translation>Le centre optique du scanneur est au centre du POS.</translation>
    </message>
    <message>
        <source>The scanner&apos;s optical centre is {listed:list} the POS centre.</source>
        <translation>Le centre optique du scanneur, par rapport au centre du POS : {listed}.</translation>
    </message>
    <message>
        <source>The point at {place:foreign} lies outside {name:kept} or its geoid grid ({int:n} such points): check the coordinate system.</source>
        <translation>Le point {place} est hors de {name} ou de sa grille de géoïde (nombre de tels points : {int}) : vérifiez le système de coordonnées.</translation>
    </message>
    <message>
        <source>{short:kept}: PROJ cannot use this coordinate system ({short2:foreign}); give its EPSG code, EPSG:32619 for example.</source>
        <translation>{short} : PROJ ne peut employer ce système de coordonnées ({short2}) ; donnez son code EPSG, EPSG:32619 par exemple.</translation>
    </message>
    <message>
        <source>{short:kept}: this coordinate system is not tied to the earth; give the EPSG code of the one the points are in.</source>
        <translation>{short} : ce système de coordonnées n&apos;est pas lié à la Terre ; donnez le code EPSG de celui des points.</translation>
    </message>
    <message>
        <source>The points name no coordinate system; give its EPSG code, EPSG:32619 for example.</source>
        <translation>Les points ne nomment pas de système de coordonnées ; donnez son code EPSG, EPSG:32619 par exemple.</translation>
    </message>
    <message>
        <source>{short:foreign}: not a coordinate system known to PROJ; give its EPSG code, EPSG:32619 for example, or its WKT.</source>
        <translation>{short} : pas un système de coordonnées connu de PROJ ; donnez son code EPSG, EPSG:32619 par exemple, ou son WKT.</translation>
    </message>
    <message>
        <source>{height:kept}: {name:kept} is not a system of heights; give ellipsoid, the EPSG code of a vertical system, or a geoid grid (.gtx, .tif).</source>
        <translation>{height} : {name} n&apos;est pas un système de hauteurs ; donnez ellipsoid, le code EPSG d&apos;un système vertical, ou une grille de géoïde (.gtx, .tif).</translation>
    </message>
    <message>
        <source>{short:kept}: not a geographic coordinate system; the datum of a trajectory is one such as EPSG:7912 (ITRF2014).</source>
        <translation>{short} : pas un système de coordonnées géographiques ; le référentiel d&apos;une trajectoire en est un, tel que EPSG:7912 (ITRF2014).</translation>
    </message>
    <message>
        <source>{name:kept} names no datum; give the EPSG code of the system.</source>
        <translation>{name} ne nomme pas de référentiel ; donnez le code EPSG du système.</translation>
    </message>
    <message>
        <source>{name:kept} is not on the ellipsoid of satellite positioning but on {name2:kept}: state the datum of the trajectory, EPSG:4979 (WGS 84) for example.</source>
        <translation>{name} n&apos;est pas sur l&apos;ellipsoïde du positionnement par satellites mais sur {name2} : indiquez le référentiel de la trajectoire, EPSG:4979 (WGS 84) par exemple.</translation>
    </message>
    <message>
        <source>The shift from {name:kept} to {name2:kept} changes with time: state the date of the survey as a decimal year (its epoch; at the command line --epoch 2024.5, or epoch=2024.5 among the options of a line).</source>
        <translation>Le passage de {name} à {name2} change avec le temps : indiquez la date du levé en année décimale (son époque ; en ligne de commande --epoch 2024.5, ou epoch=2024.5 parmi les options d&apos;une ligne).</translation>
    </message>
    <message>
        <source>From {name:kept} to {name2:kept} PROJ knows no way, and no grid file would help</source>
        <translation>De {name} à {name2}, PROJ ne connaît aucun passage, et aucun fichier de grille n&apos;y aiderait</translation>
    </message>
    <message>
        <source>{told}: give the code of a system whose datum is tied to {name:kept} (epsg.org lists them), or state another datum of the trajectory, or none where both are in one.</source>
        <translation>{told} : donnez le code d&apos;un système dont le référentiel est lié à {name} (epsg.org en donne la liste), ou indiquez un autre référentiel de la trajectoire, ou aucun si les deux sont dans un seul.</translation>
    </message>
    <message>
        <source>{grid:file}: cannot be read as a geoid grid; give a .gtx or GeoTIFF grid of PROJ.</source>
        <translation>{grid} : illisible comme grille de géoïde ; donnez une grille .gtx ou GeoTIFF de PROJ.</translation>
    </message>
    <message>
        <source>Points from {np:n} to {np2:n} s lie outside the trajectory ({known:n} to {known2:n} s): check that both use the same time base.</source>
        <translation>Des points de {np} à {np2} s sont hors de la trajectoire (de {known} à {known2} s) : vérifiez que les deux ont la même base de temps.</translation>
    </message>
    <message>
        <source>{path:file}: half of the points lie farther than {farthest:n} km from the origin (up to {np:n} m), so they are not in the scanner frame: leave the frame unstated, or state frame=georeferenced and the coordinate system; check the unit.</source>
        <translation>{path} : la moitié des points sont à plus de {farthest} km de l&apos;origine (jusqu&apos;à {np} m) ; ils ne sont donc pas dans le repère du scanneur : n&apos;indiquez pas de repère, ou indiquez frame=georeferenced et le système de coordonnées ; vérifiez l&apos;unité.</translation>
    </message>
    <message>
        <source>{path:file}: this part of an imported line is damaged ({said:foreign})</source>
        <translation>{path} : cette partie d&apos;une ligne importée est endommagée ({said})</translation>
    </message>
    <message>
        <source>{path:file}: this part of an imported line is damaged ({said:foreign}); import the line again.</source>
        <translation>{path} : cette partie d&apos;une ligne importée est endommagée ({said}) ; importez la ligne de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: made by a newer version of the program; update it.</source>
        <translation>{path} : fait par une version plus récente du programme ; mettez celui-ci à jour.</translation>
    </message>
    <message>
        <source>{path:file}: the imported line is damaged ({error:foreign}); import the line again.</source>
        <translation>{path} : la ligne importée est endommagée ({error}) ; importez la ligne de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: this part of the imported line {line:kept} {found}</source>
        <translation>{path} : cette partie de la ligne importée {line} {found}</translation>
    </message>
    <message>
        <source>{path:file}: this part of the imported line {line:kept} {found}; import the line again.</source>
        <translation>{path} : cette partie de la ligne importée {line} {found} ; importez la ligne de nouveau.</translation>
    </message>
    <message>
        <source>(about {amount:kept} while importing)</source>
        <translation>(environ {amount} pendant l&apos;import)</translation>
    </message>
    <message>
        <source>{folder:file}: what the import has written cannot be read back ({error:foreign}); check the disk, then import the line again.</source>
        <translation>{folder} : ce que l&apos;import a écrit ne peut être relu ({error}) ; vérifiez le disque, puis importez la ligne de nouveau.</translation>
    </message>
    <message>
        <source>{folder:file}: the line cannot be written here ({error:foreign}); choose a project folder that can be written, then import the line again.</source>
        <translation>{folder} : la ligne ne peut être écrite ici ({error}) ; choisissez un dossier de projet où l&apos;on peut écrire, puis importez la ligne de nouveau.</translation>
    </message>
    <message>
        <source>{folder:file}: this line is being imported already; wait for it or stop that import.</source>
        <translation>{folder} : cette ligne est déjà en cours d&apos;import ; attendez-le ou arrêtez-le.</translation>
    </message>
    <message>
        <source>{done:n} of {points:n} points came back from the disk</source>
        <translation>{done} points sur {points} relus du disque</translation>
    </message>
    <message>
        <source>Ordering {line:kept}: bringing it on the disk</source>
        <translation>Mise en ordre de {line} : regroupement sur le disque</translation>
    </message>
    <message>
        <source>{source:file}: the attribute {name:kept} is not a number for every point and cannot be imported; export the line without it.</source>
        <translation>{source} : l&apos;attribut {name} n&apos;est pas un nombre pour chaque point et ne peut être importé ; exportez la ligne sans lui.</translation>
    </message>
    <message>
        <source>{source:file}: from point {index:n} on the points have other attributes than before{what:foreign}; import these as lines of their own.</source>
        <translation>{source} : à partir du point {index}, les points ont d&apos;autres attributs qu&apos;avant{what} ; importez-les comme des lignes séparées.</translation>
    </message>
    <message>
        <source>{folder:file}: this is the line {line:kept}, not {line2:kept}; import it.</source>
        <translation>{folder} : c&apos;est la ligne {line}, et non {line2} ; importez-la.</translation>
    </message>
    <message>
        <source>Checking {line:kept}, which was copied</source>
        <translation>Vérification de {line}, qui a été copiée</translation>
    </message>
    <message>
        <source>{path:file}: this part of an imported line cannot be read ({error:foreign}); check the disk, or import the line again.</source>
        <translation>{path} : cette partie d&apos;une ligne importée ne peut être lue ({error}) ; vérifiez le disque, ou importez la ligne de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: this part of an imported line has changed since (its checksum does not hold)</source>
        <translation>{path} : cette partie d&apos;une ligne importée a changé depuis (sa somme de contrôle n&apos;est plus la bonne)</translation>
    </message>
    <message>
        <source>{path:file}: this part of an imported line has changed since (its checksum does not hold); import the line again.</source>
        <translation>{path} : cette partie d&apos;une ligne importée a changé depuis (sa somme de contrôle n&apos;est plus la bonne) ; importez la ligne de nouveau.</translation>
    </message>
    <message>
        <source>block {number} of the import is cut short</source>
        <translation>le bloc {number} de l&apos;import est tronqué</translation>
    </message>
    <message>
        <source>{path:file}: there is no point in it; leave the line out.</source>
        <translation>{path} : elle ne contient aucun point ; écartez la ligne.</translation>
    </message>
    <message>
        <source>There is no time base {key:kept}; choose one of {KEYS:kept}.</source>
        <translation>Il n&apos;y a pas de base de temps {key} ; choisissez parmi : {KEYS}.</translation>
    </message>
    <message>
        <source>No known time base brings the points onto the trajectory; check that both are of the same survey, or state the time bases.</source>
        <translation>Aucune base de temps connue ne place les points sur la trajectoire ; vérifiez que les deux sont du même levé, ou indiquez les bases de temps.</translation>
    </message>
    <message>
        <source>{share:n} % of the points inside it</source>
        <translation>{share} % des points à l&apos;intérieur</translation>
    </message>
    <message>
        <source>{share:n} % of the points inside it; by the times alone a further shift of {others:either} fits as well: state the time base of the points (option time_base)</source>
        <translation>{share} % des points à l&apos;intérieur ; d&apos;après les seuls temps, un décalage supplémentaire de {others} convient aussi bien : indiquez la base de temps des points (option time_base)</translation>
    </message>
    <message>
        <source>{share:n} % of the points inside it (leap seconds of today, {n:n} s, as neither file tells the date); by the times alone a further shift of {others:either} fits as well: state the time base of the points (option time_base)</source>
        <translation>{share} % des points à l&apos;intérieur (secondes intercalaires d&apos;aujourd&apos;hui, {n} s, aucun des fichiers ne disant la date) ; d&apos;après les seuls temps, un décalage supplémentaire de {others} convient aussi bien : indiquez la base de temps des points (option time_base)</translation>
    </message>
    <message>
        <source>Point times fit the trajectory as they are, with {share}</source>
        <translation>Les temps des points conviennent à la trajectoire tels quels, avec {share}</translation>
    </message>
    <message>
        <source>Points in {name} fit the trajectory in {name2} after adding {shift:n} s, with {share}</source>
        <translation>Les points ({name}) conviennent à la trajectoire ({name2}) une fois {shift} s ajoutées, avec {share}</translation>
    </message>
    <message>
        <source>Times have lost precision to 32-bit numbers and stand on steps of {resolution:n} s; export them again with 64-bit times.</source>
        <translation>Les temps ont perdu leur précision en passant par 32 bits et vont par pas de {resolution} s ; exportez-les de nouveau avec des temps de 64 bits.</translation>
    </message>
    <message>
        <source>{backward:n} of {count:n} times run backward; sort the file or export it again.</source>
        <translation>{backward} temps sur {count} reculent ; triez le fichier ou exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>{duplicates:n} of {count:n} times repeat the one before; sort the file or export it again.</source>
        <translation>{duplicates} temps sur {count} répètent le précédent ; triez le fichier ou exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>The line has no points.</source>
        <translation>La ligne n&apos;a pas de points.</translation>
    </message>
    <message>
        <source>The trajectory covers all points.</source>
        <translation>La trajectoire couvre tous les points.</translation>
    </message>
    <message>
        <source>{usable:n} of {count:n} points cannot be used: {outside:n} ({share_outside:n} %) lie outside the trajectory, {in_gaps:n} ({share_in_gaps:n} %) in gaps of it longer than {longest_gap:n} s.</source>
        <translation>{usable} points sur {count} ne peuvent servir : {outside} ({share_outside} %) sont hors de la trajectoire, {in_gaps} ({share_in_gaps} %) dans des lacunes de celle-ci de plus de {longest_gap} s.</translation>
    </message>
    <message>
        <source>times are those after {where}: counted on by {period:n} s</source>
        <translation>les temps sont ceux d&apos;après {where} : comptés avec {period} s de plus</translation>
    </message>
    <message>
        <source>as its values suggest</source>
        <translation>comme ses valeurs le suggèrent</translation>
    </message>
    <message>
        <source>as read from the file</source>
        <translation>lu dans le fichier</translation>
    </message>
    <message>
        <source>its times from {times:n} to {times2:n} s cannot be {name}, as stated; {hint}.</source>
        <translation>ses temps de {times} à {times2} s ne peuvent être ceci, comme indiqué : {name} ; {hint}.</translation>
    </message>
    <message>
        <source>{shift:n} s are added to its times, from {words} to the trajectory&apos;s {words2}</source>
        <translation>{shift} s sont ajoutées à ses temps, de {words} vers ceux de la trajectoire : {words2}</translation>
    </message>
    <message>
        <source>in {words} none of its points lies within the trajectory, whose times are {words2}</source>
        <translation>avec ses temps ({words}), aucun de ses points n&apos;est dans la trajectoire, dont les temps sont : {words2}</translation>
    </message>
    <message>
        <source>{told}; state the time base that the times are in, or give the trajectory of the same survey.</source>
        <translation>{told} ; indiquez la base de temps de ces temps, ou donnez la trajectoire du même levé.</translation>
    </message>
    <message>
        <source>The trajectory&apos;s pitch is beyond {np:n} deg most of the time, where roll and heading cannot be told apart: export it for a body frame whose first axis is level (vessel or reference frame, not the tilted IMU&apos;s own).</source>
        <translation>Le tangage de la trajectoire dépasse {np}° la plupart du temps, où roulis et cap ne se distinguent pas : exportez-la pour un repère du navire dont le premier axe est horizontal (navire ou référence, et non celui de l&apos;IMU inclinée).</translation>
    </message>
    <message>
        <source>{folder:file}: the disk is full; make room or move the project to a larger disk, then import the line again.</source>
        <translation>{folder} : le disque est plein ; faites de la place ou mettez le projet sur un disque plus grand, puis importez la ligne de nouveau.</translation>
    </message>
    <message>
        <source>{folder:file}: the disk is full; make room{room} or move the project to a larger disk, then import the line again.</source>
        <translation>{folder} : le disque est plein ; faites de la place{room} ou mettez le projet sur un disque plus grand, puis importez la ligne de nouveau.</translation>
    </message>
    <message>
        <source>{folder:file}: files cannot grow as large as this line needs; move the project to a disk that takes large files, then import the line again.</source>
        <translation>{folder} : les fichiers ne peuvent y devenir aussi grands que cette ligne le demande ; mettez le projet sur un disque qui accepte de grands fichiers, puis importez la ligne de nouveau.</translation>
    </message>
    <message>
        <source>{folder:file}: files cannot grow as large as this line needs{room}; move the project to a disk that takes large files, then import the line again.</source>
        <translation>{folder} : les fichiers ne peuvent y devenir aussi grands que cette ligne le demande{room} ; mettez le projet sur un disque qui accepte de grands fichiers, puis importez la ligne de nouveau.</translation>
    </message>
    <message>
        <source>{told}: {name:kept} stands for all its realizations, and only each of these is tied to {name2:kept}. Give the system on the realization that the survey is in (the latest are {named:foreign}) with the date of the survey as a decimal year.</source>
        <translation>{told} : {name} désigne toutes ses réalisations, et seule chacune de celles-ci est liée à {name2}. Donnez le système sur la réalisation du levé (les plus récentes sont {named}) avec la date du levé en année décimale.</translation>
    </message>
    <message>
        <source>{told}: {name:kept} stands for all its realizations, and only each of these is tied to {name2:kept}. Give the system on the realization that the survey is in (the latest are {named:foreign}) with the date of the survey as a decimal year{apart}.</source>
        <translation>{told} : {name} désigne toutes ses réalisations, et seule chacune de celles-ci est liée à {name2}. Donnez le système sur la réalisation du levé (les plus récentes sont {named}) avec la date du levé en année décimale{apart}.</translation>
    </message>
    <message>
        <source>{base} do not tell the date; state the date.</source>
        <translation>Ceci ne dit pas la date : {base} ; indiquez la date.</translation>
    </message>
    <message>
        <source>{share:n} % of the points inside it (leap seconds of today, {n:n} s, as neither file tells the date)</source>
        <translation>{share} % des points à l&apos;intérieur (secondes intercalaires d&apos;aujourd&apos;hui, {n} s, aucun des fichiers ne disant la date)</translation>
    </message>
    <message>
        <source>{share:n} % of the points inside it; by the times alone a further shift of {others:either} fits as well</source>
        <translation>{share} % des points à l&apos;intérieur ; d&apos;après les seuls temps, un décalage supplémentaire de {others} convient aussi bien</translation>
    </message>
    <message>
        <source>{share:n} % of the points inside it (leap seconds of today, {n:n} s, as neither file tells the date); by the times alone a further shift of {others:either} fits as well</source>
        <translation>{share} % des points à l&apos;intérieur (secondes intercalaires d&apos;aujourd&apos;hui, {n} s, aucun des fichiers ne disant la date) ; d&apos;après les seuls temps, un décalage supplémentaire de {others} convient aussi bien</translation>
    </message>
    <message>
        <source>Point times fit the trajectory as they are, with {share}.</source>
        <translation>Les temps des points conviennent à la trajectoire tels quels, avec {share}.</translation>
    </message>
    <message>
        <source>Points in {own} fit the trajectory in {other} after adding {shift:n} s, with {share}.</source>
        <translation>Les points ({own}) conviennent à la trajectoire ({other}) une fois {shift} s ajoutées, avec {share}.</translation>
    </message>
    <message>
        <source>{words}, with the leap seconds of today, {n:n} s, as neither tells the date</source>
        <translation>{words}, avec les secondes intercalaires d&apos;aujourd&apos;hui, {n} s, aucun des deux ne disant la date</translation>
    </message>
    <message>
        <source>{told}; {others:either} would fit as well: make sure of the day</source>
        <translation>{told} ; {others} conviendraient aussi bien : assurez-vous du jour</translation>
    </message>
    <message>
        <source>{shift:n} s are added to its times, from {own} to the trajectory&apos;s {other}.</source>
        <translation>{shift} s sont ajoutées à ses temps, de {own} vers ceux de la trajectoire : {other}.</translation>
    </message>
    <message>
        <source>{told}; {others:either} would fit as well: make sure of the day.</source>
        <translation>{told} ; {others} conviendraient aussi bien : assurez-vous du jour.</translation>
    </message>
    <message>
        <source>{shift:n} s are added to its times.</source>
        <translation>{shift} s sont ajoutées à ses temps.</translation>
    </message>
    <message>
        <source>{base} (stated)</source>
        <translation>{base} (indiqué)</translation>
    </message>
    <message>
        <source>{base} (as its values suggest)</source>
        <translation>{base} (comme ses valeurs le suggèrent)</translation>
    </message>
    <message>
        <source>{base} (as read from the file)</source>
        <translation>{base} (lu dans le fichier)</translation>
    </message>
    <message>
        <source>{shift:n} s ({base})</source>
        <translation>{shift} s ({base})</translation>
    </message>
    <message>
        <source>Times are those after {where}: counted on by {period:n} s.</source>
        <translation>Les temps sont ceux d&apos;après {where} : comptés avec {period} s de plus.</translation>
    </message>
    <message>
        <source>Times restart at {where} (after {t:n} s): counted on by {period:n} s.</source>
        <translation>Les temps repartent de zéro à {where} (après {t} s) : comptés ensuite avec {period} s de plus.</translation>
    </message>
    <message>
        <source>Times restart at {where}: counted on by {period:n} s.</source>
        <translation>Les temps repartent de zéro à {where} : comptés ensuite avec {period} s de plus.</translation>
    </message>
    <message>
        <source>(after {t:n} s)</source>
        <translation>(après {t} s)</translation>
    </message>
    <message>
        <source>midnight</source>
        <translation>minuit</translation>
    </message>
    <message>
        <source>the end of the week</source>
        <translation>la fin de la semaine</translation>
    </message>
    <message>
        <source>Its times from {times:n} to {times2:n} s cannot be {name}, as stated; {hint}.</source>
        <translation>Ses temps de {times} à {times2} s ne peuvent être ceci, comme indiqué : {name} ; {hint}.</translation>
    </message>
    <message>
        <source>From {name:kept} to {name2:kept} PROJ needs {grids:kept}, which is not on this machine and not fetched from the network: put it into {folder:kept}, or export the points with ellipsoidal heights in the datum of the trajectory.</source>
        <translation>De {name} à {name2}, PROJ a besoin de {grids}, qui n&apos;est pas sur cette machine et n&apos;a pas été cherché sur le réseau : mettez-le dans {folder}, ou exportez les points avec des hauteurs ellipsoïdales dans le référentiel de la trajectoire.</translation>
    </message>
    <message>
        <source>From {name:kept} to {name2:kept} PROJ needs {grids:kept}, which are not on this machine and not fetched from the network: put them into {folder:kept}, or export the points with ellipsoidal heights in the datum of the trajectory.</source>
        <translation>De {name} à {name2}, PROJ a besoin de {grids}, qui ne sont pas sur cette machine et n&apos;ont pas été cherchés sur le réseau : mettez-les dans {folder}, ou exportez les points avec des hauteurs ellipsoïdales dans le référentiel de la trajectoire.</translation>
    </message>
    <message>
        <source>From {name:kept} to {name2:kept} PROJ needs {grids:kept}, which is not on this machine and not fetched from the network: give the geoid as a file (.gtx, .tif), put it into {folder:kept}, or export the points with ellipsoidal heights in the datum of the trajectory.</source>
        <translation>De {name} à {name2}, PROJ a besoin de {grids}, qui n&apos;est pas sur cette machine et n&apos;a pas été cherché sur le réseau : donnez le géoïde en fichier (.gtx, .tif), mettez-le dans {folder}, ou exportez les points avec des hauteurs ellipsoïdales dans le référentiel de la trajectoire.</translation>
    </message>
    <message>
        <source>From {name:kept} to {name2:kept} PROJ needs {grids:kept}, which are not on this machine and not fetched from the network: give the geoid as a file (.gtx, .tif), put them into {folder:kept}, or export the points with ellipsoidal heights in the datum of the trajectory.</source>
        <translation>De {name} à {name2}, PROJ a besoin de {grids}, qui ne sont pas sur cette machine et n&apos;ont pas été cherchés sur le réseau : donnez le géoïde en fichier (.gtx, .tif), mettez-les dans {folder}, ou exportez les points avec des hauteurs ellipsoïdales dans le référentiel de la trajectoire.</translation>
    </message>
    <message>
        <source>From {name:kept} to {name2:kept} PROJ needs a grid file that is not on this machine and not fetched from the network: put it into {folder:kept}, or export the points with ellipsoidal heights in the datum of the trajectory.</source>
        <translation>De {name} à {name2}, PROJ a besoin d&apos;une grille qui n&apos;est pas sur cette machine et n&apos;a pas été cherchée sur le réseau : mettez-la dans {folder}, ou exportez les points avec des hauteurs ellipsoïdales dans le référentiel de la trajectoire.</translation>
    </message>
    <message>
        <source>From {name:kept} to {name2:kept} PROJ needs a grid file that is not on this machine and not fetched from the network: give the geoid as a file (.gtx, .tif), put it into {folder:kept}, or export the points with ellipsoidal heights in the datum of the trajectory.</source>
        <translation>De {name} à {name2}, PROJ a besoin d&apos;une grille qui n&apos;est pas sur cette machine et n&apos;a pas été cherchée sur le réseau : donnez le géoïde en fichier (.gtx, .tif), mettez-la dans {folder}, ou exportez les points avec des hauteurs ellipsoïdales dans le référentiel de la trajectoire.</translation>
    </message>
    <message>
        <source>Half of the points come out farther than {far:n} km from the scanner with {name:kept}: check the coordinate system and its unit, and that points and trajectory share one time base.</source>
        <translation>Avec {name}, la moitié des points tombent à plus de {far} km du scanneur : vérifiez le système de coordonnées et son unité, et que points et trajectoire ont la même base de temps.</translation>
    </message>
    <message>
        <source>{path:file}: half of the points come out farther than {far:n} km from the scanner with {name:kept}: check the coordinate system and its unit, and that points and trajectory share one time base.</source>
        <translation>{path} : la moitié des points tombent à plus de {far} km du scanneur avec {name} : vérifiez le système de coordonnées et son unité, et que points et trajectoire ont la même base de temps.</translation>
    </message>
    <message>
        <source>The scanner {says:list}.</source>
        <translation>Le scanneur {says}.</translation>
    </message>
    <message>
        <source>The scanner {says:list} (first turned, then pitched, then rolled).</source>
        <translation>Le scanneur {says} (rotations dans l&apos;ordre : lacet, tangage, roulis).</translation>
    </message>
    <message>
        <source>{n:n} m forward of</source>
        <translation>{n} m vers l&apos;avant</translation>
    </message>
    <message>
        <source>{n:n} m aft of</source>
        <translation>{n} m vers l&apos;arrière</translation>
    </message>
    <message>
        <source>{n:n} m to port of</source>
        <translation>{n} m vers bâbord</translation>
    </message>
    <message>
        <source>{n:n} m to starboard of</source>
        <translation>{n} m vers tribord</translation>
    </message>
    <message>
        <source>{n:n} m above</source>
        <translation>{n} m au-dessus</translation>
    </message>
    <message>
        <source>{n:n} m below</source>
        <translation>{n} m au-dessous</translation>
    </message>
    <message>
        <source>{n:n} deg bow down</source>
        <translation>{n}° étrave en bas</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>manque</translation>
    </message>
    <message>
        <source>has {n:n} of {all:n} bytes</source>
        <translation>a {n} octets sur {all}</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>rayon</translation>
    </message>
    <message>
        <source>looks {looks} deg bow down</source>
        <translation>pointe de {looks}° vers le bas</translation>
    </message>
    <message>
        <source>looks {looks} deg bow up</source>
        <translation>pointe de {looks}° vers le haut</translation>
    </message>
    <message>
        <source>leans {n:n} deg with its left side up</source>
        <translation>penche de {n}°, côté gauche (bâbord) en haut</translation>
    </message>
    <message>
        <source>leans {n:n} deg with its right side up</source>
        <translation>penche de {n}°, côté droit (tribord) en haut</translation>
    </message>
    <message>
        <source>by their values they are {fitting:either}: state {fitting2:codes}, or leave it unstated</source>
        <translation>d&apos;après leurs valeurs, ce sont {fitting} : indiquez {fitting2}, ou n&apos;indiquez rien</translation>
    </message>
    <message>
        <source>{height_unit:kept}: not a unit; choose {UNITS:codes}.</source>
        <translation>{height_unit} : pas une unité ; choisissez {UNITS}.</translation>
    </message>
    <message>
        <source>{told}; by their values these could also be {names:either}, where the points lie inside: make sure what the trajectory counts, and state it ({options:codes}).</source>
        <translation>{told} ; d&apos;après leurs valeurs, ceux-ci pourraient aussi être {names}, où les points sont à l&apos;intérieur : assurez-vous de ce que compte la trajectoire et indiquez-le ({options}).</translation>
    </message>
    <message>
        <source>The lever arm is zero, as if the scanner&apos;s optical centre were at the POS centre: type the measured one.</source>
        <translation>Le bras de levier est nul, comme si le centre optique du scanneur était au centre du POS : saisissez celui qui a été mesuré.</translation>
    </message>
    <message>
        <source>The lever arm puts the scanner {up:n} m below the POS centre, and on a vessel it is mostly above it: look at the sign of Z, which is positive up here.</source>
        <translation>Le bras de levier place le scanneur {up:n} m sous le centre du POS, or sur un navire il est le plus souvent au-dessus : vérifiez le signe de Z, positif vers le haut ici.</translation>
    </message>
    <message>
        <source>The lever arm is {length:n} m long, and few vessels are: it is stated in metres here.</source>
        <translation>Le bras de levier mesure {length:n} m, et peu de navires sont aussi longs : il s&apos;exprime ici en mètres.</translation>
    </message>
</context>
<context>
    <name>targets</name>
    <message>
        <source>Looking for flat surfaces in every line</source>
        <translation>Recherche de surfaces planes sur chaque ligne</translation>
    </message>
    <message>
        <source>Found {len:n} planes</source>
        <translation>{len} plans trouvés</translation>
    </message>
    <message>
        <source>The expected inclination must be from 0 to 90 deg.</source>
        <translation>L&apos;inclinaison attendue doit être de 0 à 90°.</translation>
    </message>
    <message>
        <source>There is no line named {first_line:kept}.</source>
        <translation>Il n&apos;y a pas de ligne nommée {first_line}.</translation>
    </message>
    <message>
        <source>There is no line to seek a {word} in.</source>
        <translation>Il n&apos;y a pas de ligne où chercher ceci : {word}.</translation>
    </message>
    <message>
        <source>Looked for the target in {name:kept}</source>
        <translation>Cible cherchée sur {name}</translation>
    </message>
    <message>
        <source>at most {degrees:n} deg of tilt</source>
        <translation>au plus {degrees}° d&apos;inclinaison</translation>
    </message>
    <message>
        <source>stop criterion {stop:n}</source>
        <translation>critère d&apos;arrêt {stop}</translation>
    </message>
    <message>
        <source>random seed {seed}</source>
        <translation>point initial aléatoire {seed}</translation>
    </message>
    <message>
        <source>The thinning distance must be a number of metres.</source>
        <translation>Le pas de sous-échantillonnage doit être un nombre de mètres.</translation>
    </message>
</context>
<context>
    <name>validation</name>
    <message>
        <source>The reference cloud of a cloud-to-cloud distance holds no point.</source>
        <translation>Le nuage de référence d&apos;une distance de nuage à nuage ne contient aucun point.</translation>
    </message>
    <message>
        <source>Indexing the clouds</source>
        <translation>Indexation des nuages</translation>
    </message>
    <message>
        <source>Measuring distances</source>
        <translation>Mesure des distances</translation>
    </message>
    <message>
        <source>The {name} cloud must be an array of shape (n, 3), and its shape is {shape:foreign}.</source>
        <translation>Le nuage ({name}) doit être un tableau de forme (n, 3), et sa forme est {shape}.</translation>
    </message>
    <message>
        <source>The {name} cloud holds {bad} of {len:n} points whose coordinates are not finite numbers; remove them before measuring distances.</source>
        <translation>Le nuage ({name}) contient {bad} points sur {len} dont les coordonnées ne sont pas des nombres finis ; retirez-les avant de mesurer des distances.</translation>
    </message>
    <message>
        <source>Comparing {a:kept} and {b:kept} on {name:kept}</source>
        <translation>Comparaison de {a} et {b} sur {name}</translation>
    </message>
    <message>
        <source>Compared {len:n} pairs of lines on {name:kept}</source>
        <translation>{len} paires de lignes comparées sur {name}</translation>
    </message>
    <message>
        <source>The validation plane {name:kept} is not placed on the same lines before and after: {only:kept} stands in one state only.</source>
        <translation>Le plan de validation {name} n&apos;est pas placé sur les mêmes lignes avant et après : {only} n&apos;est que dans un état.</translation>
    </message>
    <message>
        <source>The points of {name:kept} on line {line:kept} ({state}) must have the shape (n, 3), and theirs is {shape:foreign}.</source>
        <translation>Les points de {name} sur la ligne {line} ({state}) doivent avoir la forme (n, 3), et la leur est {shape}.</translation>
    </message>
    <message>
        <source>The points of {name:kept} on line {line:kept} ({state}) hold coordinates that are not finite numbers.</source>
        <translation>Les points de {name} sur la ligne {line} ({state}) contiennent des coordonnées qui ne sont pas des nombres finis.</translation>
    </message>
    <message>
        <source>Line {line:kept} has {len:n} points on {name:kept} before and {len2:n} after; both states must hold the same points.</source>
        <translation>La ligne {line} a {len} points sur {name} avant et {len2} après ; les deux états doivent avoir les mêmes points.</translation>
    </message>
    <message>
        <source>The heading of line {line:kept}, seen on {name:kept}, is not given.</source>
        <translation>Le cap de la ligne {line}, vue sur {name}, n&apos;est pas donné.</translation>
    </message>
    <message>
        <source>There is no local model {kind:kept}; choose {FEWEST:kept}.</source>
        <translation>Il n&apos;y a pas de modèle local {kind} ; choisissez {FEWEST}.</translation>
    </message>
    <message>
        <source>The radius of a local {kind} must be positive, and it is {radius} m.</source>
        <translation>Modèle local ({kind}) : le rayon doit être positif, et il est de {radius} m.</translation>
    </message>
    <message>
        <source>A local {kind} needs at least {kind2} neighbours, and {neighbours} were asked for.</source>
        <translation>Modèle local ({kind}) : il faut au moins {kind2} voisins, et {neighbours} ont été demandés.</translation>
    </message>
    <message>
        <source>scale of the normals</source>
        <translation>échelle des normales</translation>
    </message>
    <message>
        <source>diameter of the cylinder</source>
        <translation>diamètre du cylindre</translation>
    </message>
    <message>
        <source>depth of the cylinder</source>
        <translation>profondeur du cylindre</translation>
    </message>
    <message>
        <source>The {name} must be positive, and it is {value} m.</source>
        <translation>Valeur qui doit être positive ({name}) : elle est de {value} m.</translation>
    </message>
    <message>
        <source>A plane with its confidence needs at least four points of each line.</source>
        <translation>Un plan avec son intervalle demande au moins quatre points de chaque ligne.</translation>
    </message>
    <message>
        <source>The points of a line lie in one row and make no plane.</source>
        <translation>Les points d&apos;une ligne sont alignés et ne font pas un plan.</translation>
    </message>
    <message>
        <source>The line has no surface within reach of the reference.</source>
        <translation>La ligne n&apos;a pas de surface à portée de la référence.</translation>
    </message>
    <message>
        <source>{name:kept}: three angles and their covariance are needed.</source>
        <translation>{name} : il faut trois angles et leur covariance.</translation>
    </message>
    <message>
        <source>Repeatability needs at least two calibrations of the same mounting.</source>
        <translation>La répétabilité demande au moins deux étalonnages du même montage.</translation>
    </message>
    <message>
        <source>Statistics need at least one distance and only finite ones.</source>
        <translation>Des statistiques demandent au moins une distance, et seulement des distances finies.</translation>
    </message>
</context>
<context>
    <name>workflow</name>
    <message>
        <source>Comparing {line:kept} with {name:kept}</source>
        <translation>Comparaison de {line} avec {name}</translation>
    </message>
    <message>
        <source>{path:file}: no line has a flat place within {reach:n} m of this reference; check its coordinates, or widen the reach.</source>
        <translation>{path} : aucune ligne n&apos;a d&apos;endroit plan à moins de {reach} m de cette référence ; vérifiez ses coordonnées, ou élargissez la portée.</translation>
    </message>
    <message>
        <source>{path:file}: no line has {fewest} flat places within {reach:n} m of this reference; check its coordinates, or widen the reach.</source>
        <translation>{path} : aucune ligne n&apos;a {fewest} endroits plans à moins de {reach} m de cette référence ; vérifiez ses coordonnées, ou élargissez la portée.</translation>
    </message>
    <message>
        <source>Compared {len:n} lines with {name:kept}</source>
        <translation>{len} lignes comparées avec {name}</translation>
    </message>
    <message>
        <source>{name:kept}: there is no answer yet; estimate first.</source>
        <translation>{name} : il n&apos;y a pas encore de réponse ; estimez d&apos;abord.</translation>
    </message>
    <message>
        <source>The sigmas of the lever arm must be zero or more; correct them.</source>
        <translation>Les écarts-types du bras de levier doivent être positifs ou nuls ; corrigez-les.</translation>
    </message>
    <message>
        <source>on line {line:kept} only</source>
        <translation>sur la ligne {line} seulement</translation>
    </message>
    <message>
        <source>seed it on</source>
        <translation>placez son point initial sur</translation>
    </message>
    <message>
        <source>Selecting the points again, round {x} of {rounds}</source>
        <translation>Nouvelle sélection des points, tour {x} sur {rounds}</translation>
    </message>
    <message>
        <source>{in_gaps:n} points in gaps of the trajectory or where its pitch is beyond 80 deg</source>
        <translation>{in_gaps} points dans des lacunes de la trajectoire ou là où son tangage dépasse 80°</translation>
    </message>
    <message>
        <source>{stem:kept}: none of its {in_gaps:n} points lies within the trajectory ({known:n} to {known2:n} s); check the date and the time base, or leave the line out.</source>
        <translation>{stem} : aucun de ses {in_gaps} points n&apos;est dans la trajectoire (de {known} à {known2} s) ; vérifiez la date et la base de temps, ou écartez la ligne.</translation>
    </message>
    <message>
        <source>The scheduler {address:kept}</source>
        <translation>L&apos;ordonnanceur {address}</translation>
    </message>
    <message>
        <source>The worker {worker:kept}</source>
        <translation>Le travailleur {worker}</translation>
    </message>
    <message>
        <source>{address:kept}: the same {len:n} calculations lost their worker again and again; it has too little memory, or is stopped from outside.</source>
        <translation>{address} : les mêmes {len} calculs ont perdu leur travailleur encore et encore ; il a trop peu de mémoire, ou est arrêté de l&apos;extérieur.</translation>
    </message>
    <message>
        <source>no LISPAC that answers ({found:foreign})</source>
        <translation>aucun LISPAC qui réponde ({found})</translation>
    </message>
    <message>
        <source>{who} has {has}, and this is {wanted:kept}: install the same everywhere.</source>
        <translation>{who} a {has}, alors qu&apos;ici c&apos;est {wanted} : installez le même partout.</translation>
    </message>
    <message>
        <source>A worker that came later</source>
        <translation>Un travailleur arrivé plus tard</translation>
    </message>
    <message>
        <source>{said}; give metres north, west and up from its origin, or a coordinate system</source>
        <translation>{said} ; donnez les mètres nord, ouest et haut depuis son origine, ou un système de coordonnées</translation>
    </message>
    <message>
        <source>{said}; check the coordinate system and the order of the numbers</source>
        <translation>{said} ; vérifiez le système de coordonnées et l&apos;ordre des nombres</translation>
    </message>
    <message>
        <source>{what}: the coordinates {numbers:kept} cannot be used: {said}.</source>
        <translation>{what} : les coordonnées {numbers} ne peuvent servir : {said}.</translation>
    </message>
    <message>
        <source>Finding {name:kept} in every line</source>
        <translation>Recherche de {name} sur chaque ligne</translation>
    </message>
    <message>
        <source>Demo done</source>
        <translation>Démonstration terminée</translation>
    </message>
    <message>
        <source>All targets face the same way, and the adjustment refuses that: add a target of another inclination.</source>
        <translation>Toutes les cibles font face au même côté, ce que la compensation refuse : ajoutez une cible d&apos;une autre inclinaison.</translation>
    </message>
    <message>
        <source>{name:kept} on {line:kept} would keep {len:n} points only; untick the sighting in the table instead.</source>
        <translation>{name} sur {line} ne garderait que {len} points ; décochez plutôt l&apos;observation dans le tableau.</translation>
    </message>
    <message>
        <source>{path:file}: a report is written as {REPORT_ENDINGS:kept}; end its name so.</source>
        <translation>{path} : un rapport s&apos;écrit en {REPORT_ENDINGS} ; terminez son nom ainsi.</translation>
    </message>
    <message>
        <source>Collecting the report</source>
        <translation>Préparation du rapport</translation>
    </message>
    <message>
        <source>Report written</source>
        <translation>Rapport écrit</translation>
    </message>
    <message>
        <source>Setting the pages</source>
        <translation>Mise en page</translation>
    </message>
    <message>
        <source>Pages set</source>
        <translation>Pages composées</translation>
    </message>
    <message>
        <source>velocities, accelerations, rates and wander angle in the SBET are zero</source>
        <translation>vitesses, accélérations, vitesses angulaires et angle de dérive (wander) du SBET sont nuls</translation>
    </message>
    <message>
        <source>Targets written</source>
        <translation>Cibles écrites</translation>
    </message>
    <message>
        <source>Plane files written</source>
        <translation>Fichiers de plan écrits</translation>
    </message>
    <message>
        <source>latitude, longitude and height are as in {name:kept}: in the datum and at the epoch it was computed in, which the exported file does not name</source>
        <translation>latitude, longitude et hauteur sont comme dans {name} : dans le référentiel et à l&apos;époque où elle a été calculée, que le fichier exporté ne nomme pas</translation>
    </message>
    <message>
        <source>coordinates at the epoch of the trajectory, not moved to another one</source>
        <translation>coordonnées à l&apos;époque de la trajectoire, non ramenées à une autre</translation>
    </message>
    <message>
        <source>Lines written</source>
        <translation>Lignes écrites</translation>
    </message>
    <message>
        <source>{name:kept}: its file is not there; points, attributes and the records of its header are those kept at the import</source>
        <translation>{name} : son fichier n&apos;est pas là ; points, attributs et enregistrements de son en-tête sont ceux gardés à l&apos;import</translation>
    </message>
    <message>
        <source>{name:kept}: its file is not there; the points have all their attributes, but other records of the file&apos;s header, and the scaling and descriptions of its extra attributes, are not kept</source>
        <translation>{name} : son fichier n&apos;est pas là ; les points ont tous leurs attributs, mais les autres enregistrements de l&apos;en-tête du fichier, ainsi que l&apos;échelle et la description de ses attributs supplémentaires, ne sont pas gardés</translation>
    </message>
    <message>
        <source>{name:kept}: there is no line {name2:kept}; the lines are {known:kept}.</source>
        <translation>{name} : il n&apos;y a pas de ligne {name2} ; les lignes sont {known}.</translation>
    </message>
    <message>
        <source>coordinates are metres North, West, Up in the local frame</source>
        <translation>les coordonnées sont des mètres nord, ouest, haut dans le repère local</translation>
    </message>
    <message>
        <source>{path:file}: this is a file of the survey itself; choose another name or folder.</source>
        <translation>{path} : c&apos;est un fichier du levé même ; choisissez un autre nom ou dossier.</translation>
    </message>
    <message>
        <source>a system that is not named</source>
        <translation>un système qui n&apos;est pas nommé</translation>
    </message>
    <message>
        <source>{folder:file}: there is no such folder.</source>
        <translation>{folder} : ce dossier n&apos;existe pas.</translation>
    </message>
    <message>
        <source>{named:kept}: there is no project in it; name a folder that holds projects.</source>
        <translation>{named} : il ne contient aucun projet ; nommez un dossier qui contient des projets.</translation>
    </message>
    <message>
        <source>Left out: {error}</source>
        <translation>Laissé de côté : {error}</translation>
    </message>
    <message>
        <source>Left out: {name:kept} has no answer yet.</source>
        <translation>Laissé de côté : {name} n&apos;a pas encore de réponse.</translation>
    </message>
    <message>
        <source>its dates ({stated:foreign}) hold no day like 2026-03-04</source>
        <translation>ses dates ({stated}) ne contiennent pas de jour comme 2026-03-04</translation>
    </message>
    <message>
        <source>it has no date</source>
        <translation>il n&apos;a pas de date</translation>
    </message>
    <message>
        <source>Left out: {name:kept}: {why}; lispac identity {name2:kept} --dates, or Details for the report, gives it one.</source>
        <translation>Laissé de côté : {name} : {why} ; lispac identity {name2} --dates, ou « Détails pour le rapport », lui en donne une.</translation>
    </message>
    <message>
        <source>{len:n} calibrations of {len2:n} systems</source>
        <translation>{len} étalonnages de {len2} systèmes</translation>
    </message>
    <message>
        <source>{name:kept} is the first.</source>
        <translation>{name} est le premier.</translation>
    </message>
    <message>
        <source>{largest} by {np:n} deg, {abs:n} of its sigmas</source>
        <translation>{largest} de {np}°, {abs} fois son écart-type</translation>
    </message>
    <message>
        <source>{name:kept} differs from those before it ({told}): the mounting has moved, or one of the calibrations is wrong. A new series begins.</source>
        <translation>{name} diffère des précédents ({told}) : le montage a bougé, ou l&apos;un des étalonnages est faux. Une nouvelle série commence.</translation>
    </message>
    <message>
        <source>{name:kept} lies within the limits that those before it set (most off: {told}).</source>
        <translation>{name} est dans les limites que fixent les précédents (écart le plus grand : {told}).</translation>
    </message>
    <message>
        <source>These projects do not name vessel, scanner and INS/GNSS: whether they are of one system is not known.</source>
        <translation>Ces projets ne nomment pas navire, scanneur et INS/GNSS : on ne sait pas s&apos;ils sont d&apos;un même système.</translation>
    </message>
    <message>
        <source>Left out: {folder:file} rests on the same lines as {folder2:file}.</source>
        <translation>Laissé de côté : {folder} repose sur les mêmes lignes que {folder2}.</translation>
    </message>
    <message>
        <source>{name:kept}: there is no line named {name2:kept}.</source>
        <translation>{name} : il n&apos;y a pas de ligne nommée {name2}.</translation>
    </message>
    <message>
        <source>{name:kept}: {changed:list} changed since it was imported; import it again.</source>
        <translation>{name} : ceci a changé depuis l&apos;import : {changed} ; importez-la de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: the file of {name:kept} cannot be read ({error:foreign}), so nothing tells whether it is still what was imported; bring it back, or take it away.</source>
        <translation>{path} : le fichier de {name} ne peut être lu ({error}), rien ne dit donc s&apos;il est encore ce qui a été importé ; remettez-le en place, ou retirez-le.</translation>
    </message>
    <message>
        <source>Add the survey&apos;s files: drop them here, or press Add files.</source>
        <translation>Ajoutez les fichiers du levé : déposez-les ici, ou cliquez sur « Ajouter des fichiers ».</translation>
    </message>
    <message>
        <source>The files are being looked into.</source>
        <translation>Les fichiers sont en cours d&apos;examen.</translation>
    </message>
    <message>
        <source>({more} more files have errors.)</source>
        <translation>({more} autres fichiers ont des erreurs.)</translation>
    </message>
    <message>
        <source>({more} more file has errors.)</source>
        <translation>({more} autre fichier a des erreurs.)</translation>
    </message>
    <message>
        <source>No file is the trajectory yet: add the SBET, or a text export of it.</source>
        <translation>Aucun fichier n&apos;est encore la trajectoire : ajoutez le SBET, ou un export texte de celle-ci.</translation>
    </message>
    <message>
        <source>No file is a line yet: add the scan file of at least one.</source>
        <translation>Aucun fichier n&apos;est encore une ligne : ajoutez le fichier de balayage d&apos;une ligne au moins.</translation>
    </message>
    <message>
        <source>Two lines are named {twice:kept}; rename a file.</source>
        <translation>Deux lignes sont nommées {twice} ; renommez un fichier.</translation>
    </message>
    <message>
        <source>Choose a folder for the project.</source>
        <translation>Choisissez un dossier pour le projet.</translation>
    </message>
    <message>
        <source>There is a project in this folder already; choose another.</source>
        <translation>Il y a déjà un projet dans ce dossier ; choisissez-en un autre.</translation>
    </message>
    <message>
        <source>This is a file; choose a folder for the project.</source>
        <translation>C&apos;est un fichier ; choisissez un dossier pour le projet.</translation>
    </message>
    <message>
        <source>{place:file} cannot be written; choose another folder.</source>
        <translation>{place} ne peut être écrit ; choisissez un autre dossier.</translation>
    </message>
    <message>
        <source>Height (ellipsoid)</source>
        <translation>Hauteur (ellipsoïde)</translation>
    </message>
    <message>
        <source>Height (sea level)</source>
        <translation>Hauteur (niveau de la mer)</translation>
    </message>
    <message>
        <source>Pass over</source>
        <translation>Passer</translation>
    </message>
    <message>
        <source>No row names the columns</source>
        <translation>Aucune rangée ne nomme les colonnes</translation>
    </message>
    <message>
        <source>Looking into {name:kept}</source>
        <translation>Examen de {name}</translation>
    </message>
    <message>
        <source>It may be {name}, but hardly: choose its role if it is.</source>
        <translation>Ce pourrait être ceci, mais à peine : {name}. Choisissez son rôle si c&apos;est le cas.</translation>
    </message>
    <message>
        <source>{epoch:kept}: not a date as a decimal year; 2024.5, say.</source>
        <translation>{epoch} : pas une date en année décimale ; 2024.5, par exemple.</translation>
    </message>
    <message>
        <source>The points lie outside {name:kept}.</source>
        <translation>Les points sont hors de {name}.</translation>
    </message>
    <message>
        <source>One line</source>
        <translation>Une seule ligne</translation>
    </message>
    <message>
        <source>Leave it out</source>
        <translation>L&apos;écarter</translation>
    </message>
    <message>
        <source>This is the line {name:kept} of the project already.</source>
        <translation>C&apos;est déjà la ligne {name} du projet.</translation>
    </message>
    <message>
        <source>More than one file has the role {role}, and a project has one; leave the others out.</source>
        <translation>Plusieurs fichiers ont ce rôle : {role} ; un projet n&apos;en a qu&apos;un : écartez les autres.</translation>
    </message>
    <message>
        <source>State the coordinate system</source>
        <translation>Indiquer le système de coordonnées</translation>
    </message>
    <message>
        <source>Choose anew</source>
        <translation>Choisir de nouveau</translation>
    </message>
    <message>
        <source>The columns are those chosen for the last file laid out alike.</source>
        <translation>Les colonnes sont celles choisies pour le dernier fichier de même disposition.</translation>
    </message>
    <message>
        <source>The file is long: the first {len:n} times looked at stand for it here, the rest is checked when the project is made.</source>
        <translation>Le fichier est long : ici, les {len} premiers temps examinés le représentent, le reste est vérifié à la création du projet.</translation>
    </message>
    <message>
        <source>Exchange them</source>
        <translation>Les échanger</translation>
    </message>
    <message>
        <source>They are degrees</source>
        <translation>Ce sont des degrés</translation>
    </message>
    <message>
        <source>They are feet</source>
        <translation>Ce sont des pieds</translation>
    </message>
    <message>
        <source>Look at the coordinate system</source>
        <translation>Voir le système de coordonnées</translation>
    </message>
    <message>
        <source>Look at the signs</source>
        <translation>Voir les signes</translation>
    </message>
    <message>
        <source>Choose the time base</source>
        <translation>Choisir la base de temps</translation>
    </message>
    <message>
        <source>Choose the frame</source>
        <translation>Choisir le repère</translation>
    </message>
    <message>
        <source>Its times ({own:n} to {own2:n} s) do not meet those of the trajectory ({track:n} to {track2:n} s); give the file that belongs to it, or leave it out and type the accuracies.</source>
        <translation>Ses temps (de {own} à {own2} s) ne rencontrent pas ceux de la trajectoire (de {track} à {track2} s) ; donnez le fichier qui va avec elle, ou écartez-le et saisissez les précisions.</translation>
    </message>
    <message>
        <source>Take it back</source>
        <translation>Revenir en arrière</translation>
    </message>
    <message>
        <source>Bridge up to {bridged:n} s</source>
        <translation>Franchir jusqu&apos;à {bridged} s</translation>
    </message>
    <message>
        <source>With {shift:n} s added, {share:n} % lie inside: make sure whether the scanner wrote {name}.</source>
        <translation>Avec {shift} s ajoutées, {share} % sont à l&apos;intérieur : assurez-vous si le scanneur a écrit ceci : {name}.</translation>
    </message>
    <message>
        <source>They do not restart</source>
        <translation>Ils ne repartent pas de zéro</translation>
    </message>
    <message>
        <source>{shift:n} s are added to its times</source>
        <translation>{shift} s sont ajoutées à ses temps</translation>
    </message>
    <message>
        <source>{told}. By the times alone {others:either} would fit as well: make sure which time base the scanner wrote.</source>
        <translation>{told}. D&apos;après les seuls temps, {others} conviendraient aussi bien : assurez-vous de la base de temps du scanneur.</translation>
    </message>
    <message>
        <source>Points in {name}, trajectory in {name2}</source>
        <translation>Points en {name}, trajectoire en {name2}</translation>
    </message>
    <message>
        <source>{share} lie before or after the trajectory</source>
        <translation>{share} sont avant ou après la trajectoire</translation>
    </message>
    <message>
        <source>{share} lie in {gaps} of the trajectory longer than {longest_gap:n} s</source>
        <translation>{share} sont dans {gaps} de la trajectoire de plus de {longest_gap} s</translation>
    </message>
    <message>
        <source>No point lies within the trajectory (line {span}, trajectory {reach}). {sentence}</source>
        <translation>Aucun point n&apos;est dans la trajectoire (ligne {span}, trajectoire {reach}). {sentence}</translation>
    </message>
    <message>
        <source>before it starts</source>
        <translation>avant qu&apos;elle ne commence</translation>
    </message>
    <message>
        <source>after it ends</source>
        <translation>après qu&apos;elle finit</translation>
    </message>
    <message>
        <source>No point lies within the trajectory: the line is {span}, the trajectory {reach}, {apart:n} s {where}. No known time base brings them together; give the trajectory of the same survey, or leave the line out.</source>
        <translation>Aucun point n&apos;est dans la trajectoire : la ligne va de {span}, la trajectoire de {reach} ; la ligne est {apart} s {where}. Aucune base de temps connue ne les réunit ; donnez la trajectoire du même levé, ou écartez la ligne.</translation>
    </message>
    <message>
        <source>In {system:kept} the points lie {distance:n} km from the trajectory; state the coordinate system that they are in.</source>
        <translation>En {system}, les points sont à {distance} km de la trajectoire ; indiquez leur système de coordonnées.</translation>
    </message>
    <message>
        <source>{name:kept}: {name2:kept} is a {role} already; pick it in the same role, or give another name.</source>
        <translation>{name} : {name2} existe déjà dans un autre rôle ({role}) ; désignez dans le même rôle, ou donnez un autre nom.</translation>
    </message>
    <message>
        <source>as planned</source>
        <translation>comme prévu</translation>
    </message>
    <message>
        <source>{folder:file}: another program is changing this project; nothing was saved. Wait until it has ended, then try again.</source>
        <translation>{folder} : un autre programme modifie ce projet ; rien n'a été enregistré. Attendez qu'il ait terminé, puis recommencez.</translation>
    </message>
    <message>
        <source>{folder:file}: another program has written this project since it was opened; nothing was saved. Open it again and repeat your changes, or save it in another folder.</source>
        <translation>{folder} : un autre programme a enregistré ce projet depuis son ouverture ; rien n'a été enregistré. Ouvrez-le de nouveau et refaites vos modifications, ou enregistrez-le dans un autre dossier.</translation>
    </message>
    <message>
        <source>{address:kept}: not the address of a scheduler; it is written tls://HOST:PORT, for example tls://192.168.1.20:8786.</source>
        <translation>{address} : ce n'est pas l'adresse d'un ordonnanceur ; elle s'écrit tls://HÔTE:PORT, par exemple tls://192.168.1.20:8786.</translation>
    </message>
    <message>
        <source>{url:kept}: its TLS certificates cannot be used ({in_one_line:foreign}); check the files of the authority, the certificate and the key.</source>
        <translation>{url} : ses certificats TLS sont inutilisables ({in_one_line}) ; vérifiez les fichiers de l'autorité, du certificat et de la clé.</translation>
    </message>
    <message>
        <source>{name:kept}: the imported line holds values that no import writes, so its files were changed since; import the line again.</source>
        <translation>{name} : la ligne importée contient des valeurs qu'aucune importation n'écrit ; ses fichiers ont été modifiés depuis. Importez de nouveau la ligne.</translation>
    </message>
    <message>
        <source>the logo {name:kept} is not in the folder of the template; copy the picture there.</source>
        <translation>le logo {name} n'est pas dans le dossier du modèle ; copiez l'image dans ce dossier.</translation>
    </message>
    <message>
        <source>{path:file}: the logo {name:kept} is not in the folder of the template; copy the picture there.</source>
        <translation>{path} : le logo {name} n'est pas dans le dossier du modèle ; copiez l'image dans ce dossier.</translation>
    </message>
    <message>
        <source>{path:file}: a triangle has a corner that is not in the file; export the mesh again.</source>
        <translation>{path} : un triangle a un sommet qui n'est pas dans le fichier ; exportez de nouveau le maillage.</translation>
    </message>
    <message>
        <source>it is not UTF-8 text</source>
        <translation>ce n'est pas du texte UTF-8</translation>
    </message>
    <message>
        <source>a number in it is too large</source>
        <translation>un nombre y est trop grand</translation>
    </message>
    <message>
        <source>the number of points of a sighting is not one</source>
        <translation>le nombre de points d'une observation n'en est pas un</translation>
    </message>
    <message>
        <source>The {name} is {value:n} {unit:kept}, beyond what is possible ({least:n} to {most:n} {unit2:kept}); correct it.</source>
        <translation>Valeur impossible ({name}) : {value} {unit}, alors que de {least} à {most} {unit2} sont possibles ; corrigez-la.</translation>
    </message>
    <message>
        <source>A project needs at least one line; name its scan file.</source>
        <translation>Un projet demande au moins une ligne ; nommez son fichier de balayage.</translation>
    </message>
    <message>
        <source>{path:file}: this is the line {name:kept} already.</source>
        <translation>{path} : c&apos;est déjà la ligne {name}.</translation>
    </message>
    <message>
        <source>Laying the lines roughly onto each other</source>
        <translation>Rapprochement approximatif des lignes</translation>
    </message>
    <message>
        <source>Looking how flat they are</source>
        <translation>Examen de leur planéité</translation>
    </message>
    <message>
        <source>The lines show different parts of every target ({names:list}), and these are not flat enough to be one plane; seed surfaces that lines share.</source>
        <translation>Les lignes montrent différentes parties de chaque cible ({names}), qui ne sont pas assez planes pour former un seul plan ; placez des points initiaux sur des surfaces que les lignes ont en commun.</translation>
    </message>
    <message>
        <source>Choosing the targets</source>
        <translation>Choix des cibles</translation>
    </message>
    <message>
        <source>Seen on {lines:n} lines; without it the angles are not determined.</source>
        <translation>Vue sur {lines} lignes ; sans elle, les angles ne sont pas déterminés.</translation>
    </message>
    <message>
        <source>Seen on {lines:n} lines; without it the sigma of {angle} would be {then:n}° instead of {now:n}°.</source>
        <translation>Vue sur {lines} lignes ; sans elle, l&apos;écart-type du {angle} serait de {then}° au lieu de {now}°.</translation>
    </message>
    <message>
        <source>Plane of {area:n} m², seen on {len:n} lines, opposite ones among them, {centre:n} m high.</source>
        <translation>Plan de {area} m², vu sur {len} lignes, dont des opposées, à {centre} m de haut.</translation>
    </message>
    <message>
        <source>Plane of {area:n} m², seen on {len:n} lines, opposite ones among them, {centre:n} m high.{plane}</source>
        <translation>Plan de {area} m², vu sur {len} lignes, dont des opposées, à {centre} m de haut.{plane}</translation>
    </message>
    <message>
        <source>Plane of {area:n} m², seen on {len:n} lines, {centre:n} m high.</source>
        <translation>Plan de {area} m², vu sur {len} lignes, à {centre} m de haut.</translation>
    </message>
    <message>
        <source>Plane of {area:n} m², seen on {len:n} lines, {centre:n} m high.{plane}</source>
        <translation>Plan de {area} m², vu sur {len} lignes, à {centre} m de haut.{plane}</translation>
    </message>
    <message>
        <source>, opposite ones among them</source>
        <translation>, dont des opposées</translation>
    </message>
    <message>
        <source>Proposed {len:n} targets and {len2:n} validation planes</source>
        <translation>{len} cibles et {len2} plans de validation proposés</translation>
    </message>
    <message>
        <source>Poor on {listed:list}: {reasons}</source>
        <translation>Mauvaise sur {listed} : {reasons}</translation>
    </message>
    <message>
        <source>{count} more is {what}</source>
        <translation>{count} de plus est {what}</translation>
    </message>
    <message>
        <source>{count} more are {what}</source>
        <translation>{count} de plus sont {what}</translation>
    </message>
    <message>
        <source>seen poorly</source>
        <translation>mal vues</translation>
    </message>
    <message>
        <source>{name:kept}: only {few} flat surface is seen on two lines or more; set seeds on the targets, put up boards, or use the targetless method.</source>
        <translation>{name} : seule {few} surface plane est vue sur deux lignes ou plus ; placez des points initiaux sur les cibles, installez des panneaux ou utilisez la méthode sans cible.</translation>
    </message>
    <message>
        <source>{name:kept}: only {few} flat surface is seen on two lines or more{why}; set seeds on the targets, put up boards, or use the targetless method.</source>
        <translation>{name} : seule {few} surface plane est vue sur deux lignes ou plus{why} ; placez des points initiaux sur les cibles, installez des panneaux ou utilisez la méthode sans cible.</translation>
    </message>
    <message>
        <source>{name:kept}: only {few} flat surfaces are seen on two lines or more; set seeds on the targets, put up boards, or use the targetless method.</source>
        <translation>{name} : seules {few} surfaces planes sont vues sur deux lignes ou plus ; placez des points initiaux sur les cibles, installez des panneaux ou utilisez la méthode sans cible.</translation>
    </message>
    <message>
        <source>{name:kept}: only {few} flat surfaces are seen on two lines or more{why}; set seeds on the targets, put up boards, or use the targetless method.</source>
        <translation>{name} : seules {few} surfaces planes sont vues sur deux lignes ou plus{why} ; placez des points initiaux sur les cibles, installez des panneaux ou utilisez la méthode sans cible.</translation>
    </message>
    <message>
        <source>All flat surfaces found face one way, and that leaves the boresight open; put up a board of another inclination, or set seeds by hand.</source>
        <translation>Toutes les surfaces planes trouvées font face au même côté, ce qui laisse les angles de visée indéterminés ; installez un panneau d&apos;une autre inclinaison, ou placez des points initiaux à la main.</translation>
    </message>
    <message>
        <source>No two of the planes found determine the boresight.</source>
        <translation>Il n&apos;y a pas deux des plans trouvés qui déterminent les angles de visée.</translation>
    </message>
    <message>
        <source>Judging the sightings of {name:kept}</source>
        <translation>Examen des observations de {name}</translation>
    </message>
    <message>
        <source>A surface like it stands {apart:n} m beside it, and the scene does not tell which of the two the line shows here: see in the section that it is the one meant.</source>
        <translation>Une surface semblable se trouve à {apart} m d&apos;elle, et la scène ne dit pas laquelle des deux la ligne montre ici : voyez dans la coupe si c&apos;est bien la bonne.</translation>
    </message>
    <message>
        <source>{crs:kept} is stated for it, but its points are in the scanner frame, where no coordinate system is used: leave it out, or check the frame (frame=georeferenced).</source>
        <translation>{crs} est indiqué pour lui, mais ses points sont dans le repère du scanneur, où aucun système de coordonnées ne sert : ne l&apos;indiquez pas, ou vérifiez le repère (frame=georeferenced).</translation>
    </message>
    <message>
        <source>{path:file}: {name} is no format of a {kind} file.</source>
        <translation>{path} : ceci n&apos;est pas un format de fichier « {kind} » : {name}.</translation>
    </message>
    <message>
        <source>{path:file}: no format of a {kind} file knows it; `lispac look` shows what it may be, otherwise say which format it is.</source>
        <translation>{path} : aucun format de fichier « {kind} » ne le reconnaît ; `lispac look` montre ce que ce peut être, sinon dites quel format c&apos;est.</translation>
    </message>
    <message>
        <source>{name:file}: read as {name2}, with {detected:foreign}</source>
        <translation>{name} : lu comme {name2}, avec {detected}</translation>
    </message>
    <message>
        <source>{name:kept}: the origin is {distance:n} km from the trajectory; give its latitude and longitude in degrees, or leave it out.</source>
        <translation>{name} : l&apos;origine est à {distance} km de la trajectoire ; donnez sa latitude et sa longitude en degrés, ou ne l&apos;indiquez pas.</translation>
    </message>
    <message>
        <source>{path:file}: none of its points lies within the trajectory&apos;s time; check the date and the time base, or leave the line out.</source>
        <translation>{path} : aucun de ses points n&apos;est dans le temps de la trajectoire ; vérifiez la date et la base de temps, ou écartez la ligne.</translation>
    </message>
    <message>
        <source>columns as named: {meant:list}</source>
        <translation>colonnes telles que nommées : {meant}</translation>
    </message>
    <message>
        <source>columns by their order: {meant:list}</source>
        <translation>colonnes selon leur ordre : {meant}</translation>
    </message>
    <message>
        <source>as named</source>
        <translation>telles que nommées</translation>
    </message>
    <message>
        <source>by their order</source>
        <translation>selon leur ordre</translation>
    </message>
    <message>
        <source>, and {more} more is above it</source>
        <translation>, et {more} autre le dépasse</translation>
    </message>
    <message>
        <source>, and {more} more are above it</source>
        <translation>, et {more} autres le dépassent</translation>
    </message>
    <message>
        <source>the sigma of {row} is {sigma:n} m, and a surveyed point rarely has more than {LARGEST_SIGMA:n} m; the file&apos;s sigmas are read in metres, 3 mm is 0.003: correct the list if they are in millimetres</source>
        <translation>l&apos;écart-type de {row} est de {sigma} m, et un point levé a rarement plus de {LARGEST_SIGMA} m ; les écarts-types du fichier sont lus en mètres, 3 mm font 0.003 : corrigez la liste s&apos;ils sont en millimètres</translation>
    </message>
    <message>
        <source>the sigma of {row} is {sigma:n} m, and a surveyed point rarely has more than {LARGEST_SIGMA:n} m{others}; the file&apos;s sigmas are read in metres, 3 mm is 0.003: correct the list if they are in millimetres</source>
        <translation>l&apos;écart-type de {row} est de {sigma} m, et un point levé a rarement plus de {LARGEST_SIGMA} m{others} ; les écarts-types du fichier sont lus en mètres, 3 mm font 0.003 : corrigez la liste s&apos;ils sont en millimètres</translation>
    </message>
    <message>
        <source>{path:file}: the points of the plane {name:kept} lie on one straight line; survey one beside it.</source>
        <translation>{path} : les points du plan {name} sont alignés ; levez-en un à côté.</translation>
    </message>
    <message>
        <source>plane {name:kept}: a point lies {worst:n} mm off the plane through all of them, with a sigma of {worst2:n} mm</source>
        <translation>plan {name} : un point est à {worst} mm du plan qui passe par tous, avec un écart-type de {worst2} mm</translation>
    </message>
    <message>
        <source>Reading {name:kept}, {done:n} points</source>
        <translation>Lecture de {name}, {done} points</translation>
    </message>
    <message>
        <source>{path:file}: no point of this scan lies within {reach:n} m of what the lines have seen; check its coordinate system.</source>
        <translation>{path} : aucun point de ce balayage n&apos;est à moins de {reach} m de ce que les lignes ont vu ; vérifiez son système de coordonnées.</translation>
    </message>
    <message>
        <source>{name:file}: {done:n} points, of which {kept:n} lie where the lines have been</source>
        <translation>{name} : {done} points, dont {kept} là où les lignes sont passées</translation>
    </message>
    <message>
        <source>and are one in {halvings} of those there</source>
        <translation>, un sur {halvings} de ceux qui s&apos;y trouvent</translation>
    </message>
    <message>
        <source>{folder:file}: this project is given twice.</source>
        <translation>{folder} : ce projet est donné deux fois.</translation>
    </message>
    <message>
        <source>{names:kept} rests on the same lines as {first:kept}: the two are not independent, and all together counts them once.</source>
        <translation>{names} repose sur les mêmes lignes que {first} : les deux ne sont pas indépendants, et l&apos;ensemble ne les compte qu&apos;une fois.</translation>
    </message>
    <message>
        <source>{name:kept} rests on {len:n} of the lines of {names:kept}: the two are not independent. They agree better than two surveys would, and are less certain together than it is said.</source>
        <translation>{name} repose sur {len} des lignes de {names} : les deux ne sont pas indépendants. Ils concordent mieux que ne le feraient deux levés, et sont ensemble moins sûrs qu&apos;il n&apos;est dit.</translation>
    </message>
    <message>
        <source>{name:kept} has another lever arm than {names:kept}: part of the difference may come from it.</source>
        <translation>{name} a un autre bras de levier que {names} : une part de la différence peut en venir.</translation>
    </message>
    <message>
        <source>{name:kept} and {names:kept} have different models of the POS errors: their sigmas are not of one kind.</source>
        <translation>{name} et {names} ont des modèles différents des erreurs du POS : leurs écarts-types ne sont pas de même nature.</translation>
    </message>
    <message>
        <source>{name:kept} has no {what} of this plan; targets go by their names ({targets:kept}), lines by their headings.</source>
        <translation>{name} n&apos;a pas ceci de ce plan : {what} ; les cibles se retrouvent par leur nom ({targets}), les lignes par leur cap.</translation>
    </message>
    <message>
        <source>Line {x} ({name:kept}) was sailed at {distance:n} m.</source>
        <translation>La ligne {x} ({name}) a été parcourue à {distance} m.</translation>
    </message>
    <message>
        <source>with it the boresight would be determined</source>
        <translation>avec cela, les angles de visée seraient déterminés</translation>
    </message>
    <message>
        <source>more is missing</source>
        <translation>il manque autre chose</translation>
    </message>
    <message>
        <source>{what} was not {verb}: with it the sigma of {angles} would be {np:n} instead of {np2:n} deg.</source>
        <translation>{what} n&apos;a pas servi ({verb}) : avec cela, l&apos;écart-type du {angles} serait de {np}° au lieu de {np2}°.</translation>
    </message>
    <message>
        <source>report template</source>
        <translation>modèle de rapport</translation>
    </message>
    <message>
        <source>{path:file}: this report template is no TOML file ({error:foreign}); it holds lines such as company = &quot;Levés du Fleuve&quot;.</source>
        <translation>{path} : ce modèle de rapport n&apos;est pas un fichier TOML ({error}) ; il contient des lignes telles que company = &quot;Levés du Fleuve&quot;.</translation>
    </message>
    <message>
        <source>{path:file}: a report template has no {key:kept}; it can have {KEYS:kept}.</source>
        <translation>{path} : un modèle de rapport n&apos;a pas de {key} ; il peut avoir {KEYS}.</translation>
    </message>
    <message>
        <source>There is no page {text:kept}; choose one of {PAGES:kept}.</source>
        <translation>Il n&apos;y a pas de page {text} ; choisissez parmi : {PAGES}.</translation>
    </message>
    <message>
        <source>Selecting the points of {name:kept} again</source>
        <translation>Nouvelle sélection des points de {name}</translation>
    </message>
    <message>
        <source>{path:file}: this part of the imported line {name:kept} is missing</source>
        <translation>{path} : cette partie de la ligne importée {name} manque</translation>
    </message>
    <message>
        <source>{path:file}: this part of the imported line {name:kept} is missing; import the line again.</source>
        <translation>{path} : cette partie de la ligne importée {name} manque ; importez la ligne de nouveau.</translation>
    </message>
    <message>
        <source>{path:file}: this part of the imported line {name:kept} has changed since (its checksum does not hold)</source>
        <translation>{path} : cette partie de la ligne importée {name} a changé depuis (sa somme de contrôle n&apos;est plus la bonne)</translation>
    </message>
    <message>
        <source>{path:file}: this part of the imported line {name:kept} has changed since (its checksum does not hold); import the line again.</source>
        <translation>{path} : cette partie de la ligne importée {name} a changé depuis (sa somme de contrôle n&apos;est plus la bonne) ; importez la ligne de nouveau.</translation>
    </message>
    <message>
        <source>{name:kept} has no points on any line; there is nothing to cut through.</source>
        <translation>{name} n&apos;a de points sur aucune ligne ; il n&apos;y a rien à couper.</translation>
    </message>
    <message>
        <source>Searching for {name:kept} ({x} of {len:n})</source>
        <translation>Recherche de {name} ({x} sur {len})</translation>
    </message>
    <message>
        <source>{path:file}: no target was found at any of the {len:n} seeds; {name:kept} (row {row}): {reason}</source>
        <translation>{path} : aucune cible n&apos;a été trouvée à aucun des {len} points initiaux ; {name} (rangée {row}) : {reason}</translation>
    </message>
    <message>
        <source>{path:file}: no target was found at {len:n} of the {len2:n} seeds: {named:list}; the table says why. The others are saved.</source>
        <translation>{path} : aucune cible n&apos;a été trouvée à {len} des {len2} points initiaux : {named} ; le tableau dit pourquoi. Les autres sont enregistrés.</translation>
    </message>
    <message>
        <source>the local frame, metres</source>
        <translation>le repère local, en mètres</translation>
    </message>
    <message>
        <source>{name:kept} is a {shape} already; pick it in the same shape, or give another name.</source>
        <translation>{name} existe déjà et a une autre forme ({shape}) ; désignez-la avec la même forme, ou donnez un autre nom.</translation>
    </message>
    <message>
        <source>{name:kept} has {radius_in_words}; pick it with the same, or give another name.</source>
        <translation>{name} a {radius_in_words} ; désignez-la avec le même, ou donnez un autre nom.</translation>
    </message>
    <message>
        <source>{name:kept} on {line:kept}: there are more than {MOST:n} points about the seed; one in {one_in} of them, fairly drawn, was used</source>
        <translation>{name} sur {line} : il y a plus de {MOST} points autour du point initial ; un sur {one_in}, tiré équitablement, a servi</translation>
    </message>
    <message>
        <source>an unknown radius</source>
        <translation>un rayon inconnu</translation>
    </message>
    <message>
        <source>Line {name:kept} sees nothing of the scene: bring its course nearer, or widen the scanner&apos;s window.</source>
        <translation>La ligne {name} ne voit rien de la scène : rapprochez sa route, ou élargissez la fenêtre du scanneur.</translation>
    </message>
    <message>
        <source>{folder:file}: this is a file; choose a folder for the {marker} survey.</source>
        <translation>{folder} : c&apos;est un fichier ; choisissez un dossier pour le levé ({marker}).</translation>
    </message>
    <message>
        <source>There is no {kind} named {word:kept}: give one of {known:kept}, or a file that ends in .toml.</source>
        <translation>Il n&apos;y a pas ceci : {kind} nommé {word} ; donnez l&apos;un de {known}, ou un fichier qui se termine par .toml.</translation>
    </message>
    <message>
        <source>{file:file}: its lines are headings to be sailed, so {recorded:kept} cannot be replayed; give each of its [[lines]] start_s, stop_s and side instead, in the trajectory&apos;s time.</source>
        <translation>{file} : ses lignes sont des caps à parcourir, {recorded} ne peut donc être rejoué ; donnez à chacune de ses [[lines]] start_s, stop_s et side, dans le temps de la trajectoire.</translation>
    </message>
    <message>
        <source>{file:file}: the origin of the scene lies {farthest:n} km from {recorded:kept}; correct [origin], or leave it out for the mean of the trajectory.</source>
        <translation>{file} : l&apos;origine de la scène est à {farthest} km de {recorded} ; corrigez [origin], ou omettez-la pour la moyenne de la trajectoire.</translation>
    </message>
    <message>
        <source>{name:file}: the file does not say what its times count; they are taken to be the trajectory&apos;s {words}</source>
        <translation>{name} : le fichier ne dit pas ce que comptent ses temps ; ils sont supposés être ceux de la trajectoire : {words}</translation>
    </message>
    <message>
        <source>{path:file}: a shift of {typed:n} s is given, but {shift:n} s bring its times from {words} to the trajectory&apos;s {words2}; give either the shift or the time base.</source>
        <translation>{path} : un décalage de {typed} s est donné, mais {shift} s font passer ses temps de {words} à ceux de la trajectoire : {words2} ; donnez soit le décalage, soit la base de temps.</translation>
    </message>
    <message>
        <source>Give the subsampling distances in metres, 0 for all points.</source>
        <translation>Donnez les pas de sous-échantillonnage en mètres, 0 pour tous les points.</translation>
    </message>
    <message>
        <source>{name:kept}: there is no target yet; pick targets first.</source>
        <translation>{name} : il n&apos;y a pas encore de cible ; désignez d&apos;abord des cibles.</translation>
    </message>
    <message>
        <source>Adjusting with {distance:n} m between the points</source>
        <translation>Compensation avec {distance} m entre les points</translation>
    </message>
    <message>
        <source>Adjusted {len:n} times</source>
        <translation>Compensé {len} fois</translation>
    </message>
    <message>
        <source>Survey loaded</source>
        <translation>Levé chargé</translation>
    </message>
    <message>
        <source>{path:file}: these are not the points {name:kept} was picked on (or the trajectory covers others of them now); bring the file back, or make a new project.</source>
        <translation>{path} : ce ne sont pas les points sur lesquels {name} a été désigné (ou la trajectoire en couvre d&apos;autres maintenant) ; remettez le fichier en place, ou faites un nouveau projet.</translation>
    </message>
    <message>
        <source>{path:file}: its times ({time:n} to {time2:n} s) do not meet those of the trajectory ({time3:n} to {time4:n} s); give the accuracy file that belongs to it.</source>
        <translation>{path} : ses temps (de {time} à {time2} s) ne rencontrent pas ceux de la trajectoire (de {time3} à {time4} s) ; donnez le fichier de précision qui va avec elle.</translation>
    </message>
    <message>
        <source>the times of the lines count seconds of a day or a week and do not tell the date; type it.</source>
        <translation>les temps des lignes comptent les secondes d&apos;un jour ou d&apos;une semaine et ne disent pas la date ; saisissez-la.</translation>
    </message>
    <message>
        <source>The epoch {epoch:n} changes nothing without the datum of the trajectory: give that as well (EPSG:7912 for ITRF2014, say), or leave the epoch out.</source>
        <translation>L&apos;époque {epoch} ne change rien sans le référentiel de la trajectoire : donnez-le aussi (EPSG:7912 pour ITRF2014 par exemple), ou n&apos;indiquez pas d&apos;époque.</translation>
    </message>
    <message>
        <source>The lines are read with different datums of the trajectory ({words:foreign}); say which datum and epoch to use.</source>
        <translation>Les lignes sont lues avec différents référentiels de la trajectoire ({words}) ; dites quel référentiel et quelle époque employer.</translation>
    </message>
    <message>
        <source>The local frame has heights and a datum of its own; give a coordinate system, or neither heights nor a datum nor an epoch.</source>
        <translation>Le repère local a ses propres hauteurs et son propre référentiel ; donnez un système de coordonnées, ou ni hauteurs, ni référentiel, ni époque.</translation>
    </message>
    <message>
        <source>No coordinate system is given and the lines name none; give its EPSG code ({utm_zone:kept} is the UTM zone of the trajectory), or {LOCAL:kept} for the local frame (North, West, Up).</source>
        <translation>Aucun système de coordonnées n&apos;est donné et les lignes n&apos;en nomment pas ; donnez son code EPSG ({utm_zone} est la zone UTM de la trajectoire), ou {LOCAL} pour le repère local (nord, ouest, haut).</translation>
    </message>
    <message>
        <source>The lines are in different coordinate systems ({values:foreign}); say which one to write.</source>
        <translation>Les lignes sont dans des systèmes de coordonnées différents ({values}) ; dites lequel écrire.</translation>
    </message>
    <message>
        <source>{name:kept}: there is no validation plane; pick planes that took no part in the adjustment.</source>
        <translation>{name} : il n&apos;y a pas de plan de validation ; désignez des plans étrangers à la compensation.</translation>
    </message>
    <message>
        <source>Comparing the lines on {name:kept}</source>
        <translation>Comparaison des lignes sur {name}</translation>
    </message>
    <message>
        <source>About {n:n} % of the points</source>
        <translation>Environ {n} % des points</translation>
    </message>
    <message>
        <source>about {n:n} % of the points</source>
        <translation>environ {n} % des points</translation>
    </message>
    <message>
        <source>{n:n} % of the points</source>
        <translation>{n} % des points</translation>
    </message>
    <message>
        <source>{said:list}: these points will be left out.</source>
        <translation>{said} : ces points seront laissés de côté.</translation>
    </message>
    <message>
        <source>a gap</source>
        <translation>une lacune</translation>
    </message>
    <message>
        <source>gaps</source>
        <translation>des lacunes</translation>
    </message>
    <message>
        <source>its points</source>
        <translation>de ses points</translation>
    </message>
    <message>
        <source>the points of {name:kept}</source>
        <translation>des points de {name}</translation>
    </message>
    <message>
        <source>of {vessel:kept}</source>
        <translation>pour {vessel}</translation>
    </message>
    <message>
        <source>tick</source>
        <translation>cochez</translation>
    </message>
    <message>
        <source>on no line</source>
        <translation>sur aucune ligne</translation>
    </message>
    <message>
        <source>LISPAC {version:kept}</source>
        <translation>LISPAC {version}</translation>
    </message>
    <message>
        <source>a radius of {radius:n} m</source>
        <translation>un rayon de {radius} m</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>non employée</translation>
    </message>
    <message>
        <source>used</source>
        <translation>employée</translation>
    </message>
    <message>
        <source>sailed</source>
        <translation>parcourue</translation>
    </message>
    <message>
        <source>Line {n:n} ({name:kept}) was not sailed; {told}.</source>
        <translation>La ligne {n} ({name}) n&apos;a pas été parcourue ; {told}.</translation>
    </message>
    <message>
        <source>Line {n:n} ({name:kept}) was not sailed: with it the sigma of {angle} would be {a:n} instead of {b:n} deg.</source>
        <translation>La ligne {n} ({name}) n&apos;a pas été parcourue : avec elle, l&apos;écart-type du {angle} serait de {a}° au lieu de {b}°.</translation>
    </message>
    <message>
        <source>Target {name:kept} was not used; {told}.</source>
        <translation>La cible {name} n&apos;a pas été employée ; {told}.</translation>
    </message>
    <message>
        <source>Target {name:kept} was not used: with it the sigma of {angle} would be {a:n} instead of {b:n} deg.</source>
        <translation>La cible {name} n&apos;a pas été employée : avec elle, l&apos;écart-type du {angle} serait de {a}° au lieu de {b}°.</translation>
    </message>
    <message>
        <source>{a:n} to {b:n} s</source>
        <translation>{a} à {b} s</translation>
    </message>
    <message>
        <source>{name:kept} (row {row:n})</source>
        <translation>{name} (rangée {row})</translation>
    </message>
    <message>
        <source>Add {shift:n} s</source>
        <translation>Ajouter {shift} s</translation>
    </message>
    <message>
        <source>{name:kept}: {done:n} points, of which {kept:n} lie where the lines have been and are one in {n:n} of those there</source>
        <translation>{name} : {done} points, dont {kept} là où les lignes sont passées, un sur {n} de ceux qui s&apos;y trouvent</translation>
    </message>
    <message>
        <source>the local frame</source>
        <translation>le repère local</translation>
    </message>
    <message>
        <source>not flat</source>
        <translation>non planes</translation>
    </message>
    <message>
        <source>{file:file}: {said}</source>
        <translation>{file} : {said}</translation>
    </message>
    <message>
        <source>Mistyped?</source>
        <translation>Mal saisi ?</translation>
    </message>
    <message>
        <source>{share} of points lie before or after the trajectory</source>
        <translation>{share} des points sont avant ou après la trajectoire</translation>
    </message>
    <message>
        <source>they lie outside {where:kept}</source>
        <translation>elles sont hors de {where}</translation>
    </message>
    <message>
        <source>in {where:kept} they are {distance:n} km from the trajectory</source>
        <translation>en {where}, elles sont à {distance} km de la trajectoire</translation>
    </message>
    <message>
        <source>{DOUBT}: {name:kept} is meant for {elsewhere:foreign}, and the trajectory is at latitude {latitude:n}, longitude {longitude:n} deg; {utm_zone:kept} is the UTM zone there</source>
        <translation>{DOUBT} : {name} est prévu pour {elsewhere}, et la trajectoire est à la latitude {latitude}°, longitude {longitude}° ; {utm_zone} y est la zone UTM</translation>
    </message>
    <message>
        <source>No column is the {missing:either} yet; choose in the head of the preview what each column is.</source>
        <translation>Il manque encore une colonne : {missing}. Choisissez en tête de l&apos;aperçu ce qu&apos;est chaque colonne.</translation>
    </message>
    <message>
        <source>its points ({first:n} to {last:n} s) lie outside the trajectory ({track:n} to {track2:n} s); check the date and the time base, or leave the line out. {sentence}</source>
        <translation>ses points (de {first} à {last} s) sont hors de la trajectoire (de {track} à {track2} s) ; vérifiez la date et la base de temps, ou écartez la ligne. {sentence}</translation>
    </message>
    <message>
        <source>shifted by {shift:n} s, its points ({first:n} to {last:n} s) lie outside the trajectory ({track:n} to {track2:n} s); check the shift: {remedy}.</source>
        <translation>décalés de {shift} s, ses points (de {first} à {last} s) sont hors de la trajectoire (de {track} à {track2} s) ; vérifiez le décalage : {remedy}.</translation>
    </message>
    <message>
        <source>without it they lie inside</source>
        <translation>sans lui, ils sont dedans</translation>
    </message>
    <message>
        <source>give another, or leave the line out</source>
        <translation>donnez-en un autre, ou écartez la ligne</translation>
    </message>
    <message>
        <source>{path:file}: its points have no times, so it is no line: export it with the time of each point. As it is it serves as a reference that the lines are checked against (Validate &gt; Check against a reference…, lispac check).</source>
        <translation>{path} : ses points n&apos;ont pas de temps, ce n&apos;est donc pas une ligne : exportez-le avec le temps de chaque point. Tel quel, il sert de référence pour contrôler les lignes (Validation &gt; Contrôler par une référence…, lispac check).</translation>
    </message>
    <message>
        <source>{said}; {first} comes first, then {second}: exchange the two</source>
        <translation>{said} ; {first} vient d&apos;abord, puis {second} : échangez les deux</translation>
    </message>
    <message>
        <source>{file:file}, row {row:n}: {name:kept}: the coordinates {numbers:kept} cannot be used: {said}.</source>
        <translation>{file}, rangée {row} : {name} : les coordonnées {numbers} ne peuvent servir : {said}.</translation>
    </message>
    <message>
        <source>A process of this run ended from outside, perhaps for want of memory; close other programs, or use fewer processes (--workers), and start again.</source>
        <translation>Un processus de ce calcul a été arrêté de l&apos;extérieur, peut-être faute de mémoire ; fermez d&apos;autres programmes, ou employez moins de processus (--workers), et recommencez.</translation>
    </message>
    <message>
        <source>Line {k:n} would run through the wall, to {off:n} m behind it: sail it farther off, or turn it.</source>
        <translation>La ligne {k} traverserait le mur, jusqu&apos;à {off} m derrière lui : parcourez-la plus loin, ou tournez-la.</translation>
    </message>
    <message>
        <source>Line {k:n} comes within {off:n} m of the wall where it is straight: sail it farther off, or turn it.</source>
        <translation>La ligne {k} passe à {off} m du mur là où elle est droite : parcourez-la plus loin, ou tournez-la.</translation>
    </message>
    <message>
        <source>{one:kept} and {other:kept} hang over each other: move one of them.</source>
        <translation>{one} et {other} se recouvrent : déplacez l&apos;un des deux.</translation>
    </message>
    <message>
        <source>{name:kept} {same}: {share:n} % of {whose} on {line:kept} are the same. Keep one of the two: they would count twice.</source>
        <translation>{name} {same} : {share} % {whose} sur {line} sont les mêmes. Gardez-en un seul : ils compteraient deux fois.</translation>
    </message>
    <message>
        <source>{name:kept} {same}: {share:n} % of {whose} on {line:kept} are the same. Keep one of the two: a validation plane on a target checks nothing.</source>
        <translation>{name} {same} : {share} % {whose} sur {line} sont les mêmes. Gardez-en un seul : un plan de validation sur une cible ne contrôle rien.</translation>
    </message>
    <message>
        <source>roll {n:n}°</source>
        <translation>roulis {n}°</translation>
    </message>
    <message>
        <source>pitch {n:n}°</source>
        <translation>tangage {n}°</translation>
    </message>
    <message>
        <source>yaw {n:n}°</source>
        <translation>lacet {n}°</translation>
    </message>
    <message>
        <source>{name:kept}: no flat surface is seen on two lines or more; set seeds on the targets, put up boards, or use the targetless method.</source>
        <translation>{name} : aucune surface plane n&apos;est vue sur deux lignes ou plus ; placez des points initiaux sur les cibles, installez des panneaux ou utilisez la méthode sans cible.</translation>
    </message>
    <message>
        <source>{name:kept}: no flat surface is seen on two lines or more ({others:list}); set seeds on the targets, put up boards, or use the targetless method.</source>
        <translation>{name} : aucune surface plane n&apos;est vue sur deux lignes ou plus ({others}) ; placez des points initiaux sur les cibles, installez des panneaux ou utilisez la méthode sans cible.</translation>
    </message>
    <message>
        <source>{name:kept}: only {few:n} flat surfaces are seen on two lines or more ({others:list}); set seeds on the targets, put up boards, or use the targetless method.</source>
        <translation>{name} : seules {few} surfaces planes sont vues sur deux lignes ou plus ({others}) ; placez des points initiaux sur les cibles, installez des panneaux ou utilisez la méthode sans cible.</translation>
    </message>
    <message>
        <source>{name:kept}: only {few:n} flat surface is seen on two lines or more ({others:list}); set seeds on the targets, put up boards, or use the targetless method.</source>
        <translation>{name} : seule {few} surface plane est vue sur deux lignes ou plus ({others}) ; placez des points initiaux sur les cibles, installez des panneaux ou utilisez la méthode sans cible.</translation>
    </message>
    <message>
        <source>{n:n} more are not flat</source>
        <translation>{n} autres ne sont pas planes</translation>
    </message>
    <message>
        <source>{n:n} more is not flat</source>
        <translation>{n} autre n&apos;est pas plane</translation>
    </message>
    <message>
        <source>{n:n} more are seen poorly</source>
        <translation>{n} autres sont mal vues</translation>
    </message>
    <message>
        <source>{n:n} more is seen poorly</source>
        <translation>{n} autre est mal vue</translation>
    </message>
    <message>
        <source>No point lies within the trajectory: the line is {span}, the trajectory {reach}, {apart:n} s {where}.</source>
        <translation>Aucun point n&apos;est dans la trajectoire : la ligne va de {span}, la trajectoire de {reach} ; la ligne est {apart} s {where}.</translation>
    </message>
    <message>
        <source>No point lies within the trajectory (line {span}, trajectory {reach}).</source>
        <translation>Aucun point n&apos;est dans la trajectoire (ligne {span}, trajectoire {reach}).</translation>
    </message>
    <message>
        <source>{file:file}: {said} ({more:n} more files have errors.)</source>
        <translation>{file} : {said} ({more} autres fichiers ont des erreurs.)</translation>
    </message>
    <message>
        <source>{file:file}: {said} ({more:n} more file has errors.)</source>
        <translation>{file} : {said} ({more} autre fichier a des erreurs.)</translation>
    </message>
    <message>
        <source>name</source>
        <translation>nom</translation>
    </message>
    <message>
        <source>coordinates in the local frame</source>
        <translation>coordonnées : repère local</translation>
    </message>
    <message>
        <source>coordinates in the local frame, metres</source>
        <translation>coordonnées : repère local, en mètres</translation>
    </message>
    <message>
        <source>coordinates in {words:kept}</source>
        <translation>coordonnées : {words}</translation>
    </message>
    <message>
        <source>No such file or directory.</source>
        <translation>fichier ou dossier introuvable.</translation>
    </message>
    <message>
        <source>Permission denied.</source>
        <translation>accès refusé.</translation>
    </message>
    <message>
        <source>No space left on device.</source>
        <translation>le disque est plein.</translation>
    </message>
    <message>
        <source>Is a directory.</source>
        <translation>c&apos;est un dossier.</translation>
    </message>
    <message>
        <source>Not a directory.</source>
        <translation>ce n&apos;est pas un dossier.</translation>
    </message>
    <message>
        <source>File name too long.</source>
        <translation>nom de fichier trop long.</translation>
    </message>
    <message>
        <source>Read-only file system.</source>
        <translation>disque en lecture seule.</translation>
    </message>
    <message>
        <source>Input/output error.</source>
        <translation>erreur d&apos;entrée-sortie.</translation>
    </message>
    <message>
        <source>Disk quota exceeded.</source>
        <translation>quota de disque dépassé.</translation>
    </message>
    <message>
        <source>Scenario: {what}</source>
        <translation>Scénario : {what}</translation>
    </message>
    <message>
        <source>Writing {name:kept}</source>
        <translation>Écriture de {name}</translation>
    </message>
    <message>
        <source>Copying {name:kept}</source>
        <translation>Copie de {name}</translation>
    </message>
    <message>
        <source>Cutting {name:kept}</source>
        <translation>Coupe de {name}</translation>
    </message>
    <message>
        <source>Georeferencing {name:kept}</source>
        <translation>Géoréférencement de {name}</translation>
    </message>
    <message>
        <source>Placing {name:kept}</source>
        <translation>Mise en place de {name}</translation>
    </message>
    <message>
        <source>Reading {name:kept}</source>
        <translation>Lecture de {name}</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>Simulé</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>dessin</translation>
    </message>
    <message>
        <source>Scenario: lines</source>
        <translation>Scénario : lignes</translation>
    </message>
    <message>
        <source>Scenario: inclination</source>
        <translation>Scénario : inclinaison</translation>
    </message>
    <message>
        <source>Scenario: size</source>
        <translation>Scénario : taille</translation>
    </message>
    <message>
        <source>Scenario: targets</source>
        <translation>Scénario : cibles</translation>
    </message>
    <message>
        <source>Scenario: distance</source>
        <translation>Scénario : distance</translation>
    </message>
    <message>
        <source>Scenario: height</source>
        <translation>Scénario : hauteur</translation>
    </message>
    <message>
        <source>Scenario: repeats</source>
        <translation>Scénario : répétitions</translation>
    </message>
    <message>
        <source>Scenario: speed</source>
        <translation>Scénario : vitesse</translation>
    </message>
    <message>
        <source>Scenario: POS</source>
        <translation>Scénario : POS</translation>
    </message>
    <message>
        <source>A report is written as {known:kept}, not as {form:kept}.</source>
        <translation>Un rapport s&apos;écrit en {known}, et non en {form}.</translation>
    </message>
    <message>
        <source>There is not enough memory; use shorter lines.</source>
        <translation>Il n&apos;y a pas assez de mémoire ; employez des lignes plus courtes.</translation>
    </message>
    <message>
        <source>A target needs a name; {old:kept} keeps its own.</source>
        <translation>Une cible a besoin d&apos;un nom ; {old} garde le sien.</translation>
    </message>
    <message>
        <source>There is a {new:kept} already; give {old:kept} another name.</source>
        <translation>{new} existe déjà ; donnez un autre nom à {old}.</translation>
    </message>
    <message>
        <source>{name:kept}: its points on {line:kept} were chosen in another file, or the trajectory covers others of them now; bring the file back, or pick it again.</source>
        <translation>{name} : ses points sur {line} ont été choisis dans un autre fichier, ou la trajectoire en couvre d&apos;autres maintenant ; remettez le fichier en place, ou désignez de nouveau.</translation>
    </message>
    <message>
        <source>{what:kept}: {line:kept} has points 0 to {last:n}, and number {asked:n} is asked for.</source>
        <translation>{what} : {line} a les points 0 à {last}, et le numéro {asked} est demandé.</translation>
    </message>
    <message>
        <source>Numbers of points: these are more than {most:n}; correct them.</source>
        <translation>Numéros de points : il y en a plus de {most} ; corrigez-les.</translation>
    </message>
    <message>
        <source>Numbers of points: {text:foreign} is neither a number nor a first number and how many follow, such as 12+40.</source>
        <translation>Numéros de points : {text} n&apos;est ni un numéro, ni un premier numéro et combien le suivent, comme 12+40.</translation>
    </message>
    <message>
        <source>Trying the seed of {name:kept}</source>
        <translation>Essai du point initial de {name}</translation>
    </message>
    <message>
        <source>Script made</source>
        <translation>Script établi</translation>
    </message>
    <message>
        <source>{file:file}: with {title:kept} the survey takes {takes:n} hours, and no more than {most:n} are simulated; correct run_in_m and run_out_m, or the vessel&apos;s speed_m_s, transit_s and wait_s.</source>
        <translation>{file} : avec {title}, le levé prend {takes} heures, et l&apos;on n&apos;en simule pas plus de {most} ; corrigez run_in_m et run_out_m, ou speed_m_s, transit_s et wait_s du navire.</translation>
    </message>
    <message>
        <source>The script needs what is not there now: {gone:foreign}.</source>
        <translation>Le script a besoin de ce qui n&apos;est pas là maintenant : {gone}.</translation>
    </message>
    <message>
        <source>The project has angles, but estimating them is refused now: {why}</source>
        <translation>Le projet a des angles, mais leur estimation est refusée maintenant : {why}</translation>
    </message>
    <message>
        <source>The angles of the project differ from those of this script, by up to {n:n} deg ({angles:foreign}): after a sighting was left out they followed with the points as they were selected before, or another version found them. Estimate again in the project to have those of the script.</source>
        <translation>Les angles du projet diffèrent de ceux de ce script, jusqu&apos;à {n}° ({angles}) : après la mise à l&apos;écart d&apos;une observation, ils ont suivi avec les points tels qu&apos;ils étaient choisis avant, ou une autre version les a trouvés. Estimez de nouveau dans le projet pour avoir ceux du script.</translation>
    </message>
    <message>
        <source>The reference {name:kept} was not found beside the lines: put its path into the step project.check, with its sigma and crs where they were chosen, and take the # away.</source>
        <translation>La référence {name} n&apos;a pas été trouvée à côté des lignes : mettez son chemin dans l&apos;étape project.check, avec sigma et crs s&apos;ils ont été choisis, et enlevez le #.</translation>
    </message>
    <message>
        <source>The check against {name:kept} gives other numbers so: its coordinates were taken to be in {system:kept}. Put crs, sigma and what else was chosen then into the step project.check.</source>
        <translation>Le contrôle avec {name} donne ainsi d&apos;autres chiffres : ses coordonnées ont été supposées en {system}. Mettez crs, sigma et ce qui avait été choisi d&apos;autre dans l&apos;étape project.check.</translation>
    </message>
    <message>
        <source>{title:kept}: {done:n} surveys simulated and adjusted</source>
        <translation>{title} : {done} levés simulés et compensés</translation>
    </message>
    <message>
        <source>{title:kept}: cancelled after {done:n} of {asked:n} surveys</source>
        <translation>{title} : annulé après {done} levés sur {asked}</translation>
    </message>
    <message>
        <source>What was sailed of the plan does not determine the boresight, as far as is foretold.</source>
        <translation>Ce qui a été parcouru du plan ne détermine pas les angles de visée, d&apos;après la prévision.</translation>
    </message>
    <message>
        <source>the plan, foretold</source>
        <translation>le plan, prévu</translation>
    </message>
    <message>
        <source>what was sailed of it</source>
        <translation>ce qui en a été parcouru</translation>
    </message>
    <message>
        <source>with targets as flat as found</source>
        <translation>avec des cibles aussi planes que trouvées</translation>
    </message>
    <message>
        <source>stated by the adjustment</source>
        <translation>annoncé par la compensation</translation>
    </message>
    <message>
        <source>stated over foretold</source>
        <translation>annoncé sur prévu</translation>
    </message>
    <message>
        <source>Targets were planned to be flat to {planned:n} mm; the survey found {came:n} mm.</source>
        <translation>Les cibles étaient prévues planes à {planned} mm près ; le levé a trouvé {came} mm.</translation>
    </message>
    <message>
        <source>There is no boresight any more: an edit changed what it rested on. Press Estimate for it.</source>
        <translation>Il n&apos;y a plus d&apos;angles de visée : une modification a changé ce sur quoi ils reposaient. Cliquez sur Estimer.</translation>
    </message>
    <message>
        <source>{path:file}: the folder of the project is no longer there; bring it back to this place and name, then save.</source>
        <translation>{path} : le dossier du projet n&apos;est plus là ; remettez-le à cet endroit et sous ce nom, puis enregistrez.</translation>
    </message>
</context>
<context>
    <name>sensors</name>
    <message>
        <source>{word:kept}: say with which GNSS solution its sigmas are to be taken: {known:kept}.</source>
        <translation>{word} : dites avec quelle solution GNSS prendre ses sigmas : {known}.</translation>
    </message>
    <message>
        <source>There is no scanner named {name:kept} in the library; give one of {known:kept}.</source>
        <translation>Aucun scanneur de la bibliothèque ne s&apos;appelle {name} ; donnez l&apos;un de {known}.</translation>
    </message>
    <message>
        <source>There is no POS named {name:kept} in the library; give one of {known:kept}.</source>
        <translation>Aucune INS/GNSS de la bibliothèque ne s&apos;appelle {name} ; donnez l&apos;un de {known}.</translation>
    </message>
    <message>
        <source>There is no {kind} named {name:kept} in the library; give one of {known:kept}.</source>
        <translation>Aucun capteur {kind} de la bibliothèque ne s&apos;appelle {name} ; donnez l&apos;un de {known}.</translation>
    </message>
    <message>
        <source>State where the figures come from: a data sheet with its date, say.</source>
        <translation>Indiquez d&apos;où viennent les valeurs : une fiche technique avec sa date, par exemple.</translation>
    </message>
    <message>
        <source>A title or a source has one line of {most:kept} letters at most.</source>
        <translation>Un titre ou une source tient sur une ligne de {most} lettres au plus.</translation>
    </message>
    <message>
        <source>There is a sensor {title:kept} already; give another title.</source>
        <translation>Il y a déjà un capteur {title} ; donnez un autre titre.</translation>
    </message>
    <message>
        <source>{path:file}: {key:kept} holds zero; nothing is known exactly, give more than 0.</source>
        <translation>{path} : {key} contient zéro ; rien n&apos;est connu exactement, donnez plus que 0.</translation>
    </message>
    <message>
        <source>from memory, check against the data sheet</source>
        <translation>de mémoire, à vérifier sur la fiche technique</translation>
    </message>
</context>
<context>
    <name>caches</name>
</context>
<context>
    <name>manual</name>
    <message>
        <source>The manual cannot be built here, since {missing:kept} is not installed; start the program with installer/bootstrap.py run, or read the texts in {folder:file}.</source>
        <translation>Le manuel ne peut pas être produit ici : {missing} n&apos;est pas installé ; démarrez le programme par installer/bootstrap.py run, ou lisez les textes dans {folder}.</translation>
    </message>
    <message>
        <source>building the pages in {language:kept}</source>
        <translation>production des pages en {language}</translation>
    </message>
</context>
<context>
    <name>project_file</name>
    <message>
        <source>it cannot be read from line {lineno:n} on</source>
        <translation>illisible à partir de la ligne {lineno}</translation>
    </message>
    <message>
        <source>it is not text</source>
        <translation>ce n&apos;est pas du texte</translation>
    </message>
    <message>
        <source>{args:kept} is missing in it</source>
        <translation>{args} y manque</translation>
    </message>
    <message>
        <source>it cannot be read</source>
        <translation>illisible</translation>
    </message>
    <message>
        <source>something in it is of the wrong kind</source>
        <translation>un élément n&apos;y est pas de la bonne sorte</translation>
    </message>
    <message>
        <source>its {in_words:kept} cannot be read</source>
        <translation>sa partie « {in_words} » est illisible</translation>
    </message>
    <message>
        <source>its {in_words:kept} cannot be read: {reason}</source>
        <translation>sa partie « {in_words} » est illisible : {reason}</translation>
    </message>
    <message>
        <source>{name:kept} has the role {role:kept}</source>
        <translation>{name} a le rôle {role}</translation>
    </message>
    <message>
        <source>{name:kept} has the shape {shape:kept}</source>
        <translation>{name} a la forme {shape}</translation>
    </message>
    <message>
        <source>seed, threshold or radius of {name:kept}</source>
        <translation>point initial, seuil ou rayon de {name}</translation>
    </message>
    <message>
        <source>{name:kept} is on a line {line:kept} that is not listed</source>
        <translation>{name} est sur une ligne {line} qui n&apos;est pas dans la liste</translation>
    </message>
    <message>
        <source>{names:kept} is not known</source>
        <translation>{names} n&apos;est pas connu</translation>
    </message>
</context>
<context>
    <name>moved</name>
    <message>
        <source>{folder:file}: none of the missing files is in this folder or in one below it ({named:kept}); choose the folder that they are in now.</source>
        <translation>{folder} : aucun des fichiers manquants n&apos;est dans ce dossier ni plus bas ({named}) ; choisissez le dossier où ils sont maintenant.</translation>
    </message>
    <message>
        <source>{first:file}: there is no such file; bring it back, or say where it is now: lispac locate, or open the project in the window.</source>
        <translation>{first} : ce fichier n&apos;existe pas ; remettez-le, ou dites où il est maintenant : lispac locate, ou ouvrez le projet dans la fenêtre.</translation>
    </message>
    <message>
        <source>{first:file}: there is no such file, nor {named:kept}; bring them back, or say where they are now: lispac locate, or open the project in the window.</source>
        <translation>{first} : ce fichier n&apos;existe pas, ni {named} ; remettez-les, ou dites où ils sont maintenant : lispac locate, ou ouvrez le projet dans la fenêtre.</translation>
    </message>
    <message>
        <source>{name:kept} was moved: it is read from {parent:kept}</source>
        <translation>{name} a été déplacé : il est lu dans {parent}</translation>
    </message>
</context>
<context>
    <name>targetless</name>
    <message>
        <source>The answer rests on {a:n} of {b:n} natural surfaces that lines share; rounds of matching: {c:n}.</source>
        <translation>La réponse repose sur {a} des {b} surfaces naturelles que les lignes partagent ; tours d&apos;appariement : {c}.</translation>
    </message>
    <message>
        <source>Lines that do not agree with the others: {lines:list}.</source>
        <translation>Lignes en désaccord avec les autres : {lines}.</translation>
    </message>
    <message>
        <source>{project}: one line meets nothing; add lines in other directions over the same scene.</source>
        <translation>{project} : une ligne seule ne recoupe rien ; ajoutez des lignes d&apos;autres directions au-dessus de la même scène.</translation>
    </message>
    <message>
        <source>{project}: the lines share only {a:n} flat surfaces, and at least {b:n} are needed; add lines that overlap, or hang targets.</source>
        <translation>{project} : les lignes ne partagent que {a} surfaces planes, il en faut au moins {b} ; ajoutez des lignes qui se recouvrent, ou posez des cibles.</translation>
    </message>
    <message>
        <source>Aligning the lines</source>
        <translation>Alignement des lignes</translation>
    </message>
    <message>
        <source>Matching the lines, round {a:n}</source>
        <translation>Appariement des lignes, tour {a}</translation>
    </message>
    <message>
        <source>The angles still moved by more than {setting:n} % of their sigmas in the last round of matching.</source>
        <translation>Au dernier tour d&apos;appariement, les angles bougeaient encore de plus de {setting} % de leurs écarts-types.</translation>
    </message>
    <message>
        <source>Targets adjusted with them: {n:n}.</source>
        <translation>Cibles compensées avec elles : {n}.</translation>
    </message>
    <message>
        <source>{project:name}: there is no target to adjust with the scene; pick one, or leave the targets out.</source>
        <translation>{project} : il n’y a pas de cible à compenser avec la scène ; en choisir une, ou laisser les cibles de côté.</translation>
    </message>
</context>
<context>
    <name>patchtest</name>
    <message>
        <source>The answer rests on {a:n} objects and {b:n} lines.</source>
        <translation>La réponse repose sur {a} objets et {b} lignes.</translation>
    </message>
    <message>
        <source>The mismatch (robust RMS distance between lines, at most {a:n} mm) is {b:n} mm; with the prior boresight the lines do not meet there.</source>
        <translation>L&apos;écart (distance RMS robuste entre lignes, {a} mm au plus) est de {b} mm ; avec les angles de visée a priori, les lignes ne s&apos;y recoupent pas.</translation>
    </message>
    <message>
        <source>The mismatch (robust RMS distance between lines, at most {a:n} mm) falls from {b:n} mm with the prior boresight to {c:n} mm.</source>
        <translation>L&apos;écart (distance RMS robuste entre lignes, {a} mm au plus) passe de {b} mm avec les angles de visée a priori à {c} mm.</translation>
    </message>
    <message>
        <source>A sigma cannot be stated: {a:n} objects are too few to tell how far the answer would move with others; at least {b:n} are needed.</source>
        <translation>Aucun écart-type ne peut être donné : {a} objets ne suffisent pas pour dire de combien la réponse changerait avec d&apos;autres ; il en faut au moins {b}.</translation>
    </message>
    <message>
        <source>The angles still moved when the search ended.</source>
        <translation>Les angles bougeaient encore à la fin de la recherche.</translation>
    </message>
    <message>
        <source>Turned one after another, the angles end elsewhere: the {angle} by {a:n} deg.</source>
        <translation>Tournés l&apos;un après l&apos;autre, les angles aboutissent ailleurs : le {angle} de {a}°.</translation>
    </message>
    <message>
        <source>{object:kept} does not agree: its own minimum of the {angle} is off by {a:n} deg, and {b:n} deg would be usual.</source>
        <translation>{object} est en désaccord : son propre minimum du {angle} est décalé de {a}°, alors que {b}° serait habituel.</translation>
    </message>
    <message>
        <source>No two of the lines meet at: {names:list}.</source>
        <translation>Aucune paire de lignes ne se recoupe à : {names}.</translation>
    </message>
    <message>
        <source>{object:kept}: the box&apos;s centre or turn is not a number; correct it.</source>
        <translation>{object} : le centre ou l&apos;orientation de la boîte n&apos;est pas un nombre ; corrigez-le.</translation>
    </message>
    <message>
        <source>{object:kept}: a side of the box is not between {a:n} and {b:n} m; correct it.</source>
        <translation>{object} : un côté de la boîte n&apos;est pas compris entre {a} et {b} m ; corrigez-le.</translation>
    </message>
    <message>
        <source>Turning the angles</source>
        <translation>Rotation des angles</translation>
    </message>
    <message>
        <source>Turning the {angle}</source>
        <translation>Rotation du {angle}</translation>
    </message>
    <message>
        <source>No two of the chosen lines meet at any of the objects; tick objects that both lines of a pair see.</source>
        <translation>Aucune paire des lignes choisies ne se recoupe à l&apos;un des objets ; cochez des objets que voient les deux lignes d&apos;une paire.</translation>
    </message>
    <message>
        <source>same direction</source>
        <translation>même sens</translation>
    </message>
    <message>
        <source>reciprocal</source>
        <translation>réciproques</translation>
    </message>
    <message>
        <source>crossing</source>
        <translation>croisées</translation>
    </message>
    <message>
        <source>oblique</source>
        <translation>obliques</translation>
    </message>
    <message>
        <source>Looking for objects that lines share</source>
        <translation>Recherche d&apos;objets communs aux lignes</translation>
    </message>
    <message>
        <source>Taking the points about the objects</source>
        <translation>Extraction des points autour des objets</translation>
    </message>
    <message>
        <source>{project}: the lines share no flat surface; lay boxes about objects that two lines see.</source>
        <translation>{project} : les lignes ne partagent aucune surface plane ; placez des boîtes autour d&apos;objets que voient deux lignes.</translation>
    </message>
    <message>
        <source>The patch test has no sigma, so its answer cannot be held against others; add objects, and find all three angles again.</source>
        <translation>Le patch test n&apos;a pas d&apos;écart-type : sa réponse ne peut être comparée à d&apos;autres ; ajoutez des objets et cherchez de nouveau les trois angles.</translation>
    </message>
</context>
<context>
    <name>line differences</name>
    <message>
        <source>{a:name} and {b:name} share no flat place.</source>
        <translation>{a} et {b} n’ont en commun aucun endroit plan.</translation>
    </message>
    <message>
        <source>{project:name}: no two lines share a flat place within {n:n} m of each other; widen the reach, or add lines over the same scene.</source>
        <translation>{project} : aucune paire de lignes n’a d’endroit plan commun à moins de {n} m ; élargir la portée, ou ajouter des lignes sur la même scène.</translation>
    </message>
    <message>
        <source>Comparing {a:name} with {b:name}</source>
        <translation>Comparaison de {a} avec {b}</translation>
    </message>
    <message>
        <source>Compared {n:n} pairs of lines</source>
        <translation>{n} paires de lignes comparées</translation>
    </message>
    <message>
        <source>Distance between two lines (mm)</source>
        <translation>Distance entre deux lignes (mm)</translation>
    </message>
</context>
<context>
    <name>points of a line</name>
    <message>
        <source>{line:kept}: point times are in steps of {step:n} ms, with {points:n} points to each step. Positions of points are off by up to {shift:n} mm and attitudes by up to {turn:n} deg, which does not average out. Export the line with exact times (64 bits).</source>
        <translation>{line} : les temps des points progressent par pas de {step} ms, avec {points} points par pas. Les points sont décalés de {shift} mm au plus et l&apos;attitude de {turn} deg au plus, ce que la moyenne ne compense pas. Exportez la ligne avec des temps exacts (64 bits).</translation>
    </message>
    <message>
        <source>{line:kept}: {count:n} points ({share:n} %) lie beyond the largest range of the scanner. They are excluded.</source>
        <translation>{line} : {count} points ({share} %) se trouvent au-delà de la portée maximale du scanneur. Ils sont exclus.</translation>
    </message>
    <message>
        <source>{line:kept}: {count:n} points ({share:n} %) are exact copies of other points. They are excluded.</source>
        <translation>{line} : {count} points ({share} %) sont des copies exactes d&apos;autres points. Ils sont exclus.</translation>
    </message>
    <message>
        <source>{line:kept}: {count:n} points ({share:n} %) do not meet the conditions given for the line. They are excluded.</source>
        <translation>{line} : {count} points ({share} %) ne remplissent pas les conditions données pour la ligne. Ils sont exclus.</translation>
    </message>
    <message>
        <source>{line:kept} was imported by an earlier version, which did not check its points. Import the line again.</source>
        <translation>{line} a été importée par une version antérieure, qui n&apos;a pas contrôlé ses points. Importez la ligne de nouveau.</translation>
    </message>
    <message>
        <source>{line:kept}: {count:n} points are classified as noise (class {classes:kept}). They may lie off the targets. Exclude these classes.</source>
        <translation>{line} : {count} points sont classés comme bruit (classe {classes}). Ils peuvent se trouver hors des cibles. Excluez ces classes.</translation>
    </message>
    <message>
        <source>{line:kept}: the file holds points of {count:n} scanners ({attribute:kept} {values:kept}). Each scanner has its own boresight and lever arm, so one boresight for all is wrong. Split the line, or use one scanner.</source>
        <translation>{line} : le fichier contient les points de {count} scanneurs ({attribute} {values}). Chaque scanneur a ses propres angles de visée et son bras de levier : des angles communs à tous sont faux. Divisez la ligne, ou n&apos;utilisez qu&apos;un scanneur.</translation>
    </message>
    <message>
        <source>{line:kept}: the file holds points of {count:n} sources ({attribute:kept} {values:kept}): several passes or several scanners. Passes that count as one line are not compared with each other, and one boresight does not fit several scanners. Split the line, or use one source.</source>
        <translation>{line} : le fichier contient les points de {count} sources ({attribute} {values}) : plusieurs passages ou plusieurs scanneurs. Des passages réunis en une ligne ne sont pas comparés entre eux, et des angles communs ne conviennent pas à plusieurs scanneurs. Divisez la ligne, ou n&apos;utilisez qu&apos;une source.</translation>
    </message>
    <message>
        <source>{line:kept}: the file holds {count:n} passes, separated by pauses in which the vessel turned. They count as one line and are not compared with each other. Split the line.</source>
        <translation>{line} : le fichier contient {count} passages, séparés par des pauses pendant lesquelles le navire a tourné. Ils comptent pour une ligne et ne sont pas comparés entre eux. Divisez la ligne.</translation>
    </message>
    <message>
        <source>{line:kept} and {other:kept} hold points of the same {seconds:n} s. Of one scanner, one of them is a copy and makes the standard deviations too small; of two scanners, each has a boresight of its own. Exclude one of them.</source>
        <translation>{line} et {other} ont des points des mêmes {seconds} s. D&apos;un même scanner, l&apos;une est une copie et rend les écarts-types trop petits ; de deux scanners, chacun a ses propres angles de visée. Excluez l&apos;une des deux.</translation>
    </message>
    <message>
        <source>{line:kept} and {other:kept} have points in common ({share:n} % of the smaller line). Points that count twice make the standard deviations too small. Exclude {smaller:kept}.</source>
        <translation>{line} et {other} ont des points en commun ({share} % de la plus petite ligne). Des points comptés deux fois donnent des écarts-types trop petits. Excluez {smaller}.</translation>
    </message>
    <message>
        <source>Exclude {line:kept}</source>
        <translation>Exclure {line}</translation>
    </message>
    <message>
        <source>Split {line:kept} into lines by {by:kept}</source>
        <translation>Diviser {line} en lignes selon {by}</translation>
    </message>
    <message>
        <source>{text:kept}: not a list of classes; give numbers, 7 18 for example.</source>
        <translation>{text} : ce n&apos;est pas une liste de classes ; donnez des nombres, 7 18 par exemple.</translation>
    </message>
    <message>
        <source>{path:file}: none of its {read:n} points can be used: {nan:n} are not numbers, {none:n} have no range, {far:n} are too far, {withheld:n} are withheld, {others:n} are not selected; check the options of the line or export it again.</source>
        <translation>{path} : aucun de ses {read} points n&apos;est utilisable : {nan} ne sont pas des nombres, {none} n&apos;ont pas de distance, {far} sont trop loin, {withheld} sont retenus (« withheld »), {others} ne sont pas choisis ; vérifiez les options de la ligne ou exportez-la de nouveau.</translation>
    </message>
    <message>
        <source>Points with the withheld flag: excluded or used</source>
        <translation>Points portant l&apos;indicateur « withheld » : exclus ou utilisés</translation>
    </message>
    <message>
        <source>Classes of points to exclude, 7 18 for noise; empty: none</source>
        <translation>Classes de points à exclure, 7 18 pour le bruit ; vide : aucune</translation>
    </message>
    <message>
        <source>Use only points with these attributes, scanner_channel=0 or time=1200:1260 for example; empty: all</source>
        <translation>N&apos;utiliser que les points ayant ces attributs, par exemple scanner_channel=0 ou time=1200:1260 ; vide : tous</translation>
    </message>
    <message>
        <source>Largest range of the scanner in metres; empty: 10000</source>
        <translation>Portée maximale du scanneur en mètres ; vide : 10000</translation>
    </message>
</context>
<context>
    <name>recovery of a line</name>
    <message>
        <source>{line:kept}: the heights less those of the trajectory are {offset:n} m, as with heights above sea level and an ellipsoidal trajectory. The recovered points do not lie on the beams of the scanner (off by {misfit:n} mm), and the angles will be wrong. Give the height system, or {value:n} m to be added.</source>
        <translation>{line} : les hauteurs moins celles de la trajectoire font {offset} m, comme pour des altitudes avec une trajectoire ellipsoïdale. Les points reconstitués ne se trouvent pas sur les faisceaux du scanner (écart {misfit} mm), et les angles seront faux. Indiquez le système d&apos;altitude, ou {value} m à ajouter.</translation>
    </message>
    <message>
        <source>{line:kept}: the points fit the beams of the scanner only with {value:n} s added to their times. The recovered points are off by {misfit:n} mm, and the angles will be wrong. Check the time base of the line.</source>
        <translation>{line} : les points ne sont sur les faisceaux du scanner qu&apos;avec {value} s ajoutées à leurs temps. Les points reconstitués s&apos;en écartent de {misfit} mm, et les angles seront faux. Vérifiez la base de temps de la ligne.</translation>
    </message>
    <message>
        <source>{line:kept}: the points fit the beams of the scanner only with {value:n} m added to the lever arm forward. The cloud was made with another lever arm (recovered points are off by {misfit:n} mm). Give the lever arm that made the cloud.</source>
        <translation>{line} : les points ne sont sur les faisceaux du scanner qu&apos;avec {value} m ajoutés au bras de levier vers l&apos;avant. Le nuage a été calculé avec un autre bras de levier (écart {misfit} mm). Indiquez celui qui a servi au nuage.</translation>
    </message>
    <message>
        <source>{line:kept}: the points fit the beams of the scanner only with {value:n} m added to the lever arm to the left. The cloud was made with another lever arm (recovered points are off by {misfit:n} mm). Give the lever arm that made the cloud.</source>
        <translation>{line} : les points ne sont sur les faisceaux du scanner qu&apos;avec {value} m ajoutés au bras de levier vers la gauche. Le nuage a été calculé avec un autre bras de levier (écart {misfit} mm). Indiquez celui qui a servi au nuage.</translation>
    </message>
    <message>
        <source>{line:kept}: the points fit the beams of the scanner only with {value:n} m added to the lever arm up. The cloud was made with another lever arm (recovered points are off by {misfit:n} mm). Give the lever arm that made the cloud.</source>
        <translation>{line} : les points ne sont sur les faisceaux du scanner qu&apos;avec {value} m ajoutés au bras de levier vers le haut. Le nuage a été calculé avec un autre bras de levier (écart {misfit} mm). Indiquez celui qui a servi au nuage.</translation>
    </message>
    <message>
        <source>{line:kept}: the points fit the beams of the scanner only with the opposite sign of roll (off by {misfit:n} mm otherwise). The angles will be wrong. Check the signs of the trajectory.</source>
        <translation>{line} : les points ne sont sur les faisceaux du scanner qu&apos;avec le signe opposé du roulis (sinon écart {misfit} mm). Les angles seront faux. Vérifiez les signes de la trajectoire.</translation>
    </message>
    <message>
        <source>{line:kept}: the points fit the beams of the scanner only with the opposite sign of pitch (off by {misfit:n} mm otherwise). The angles will be wrong. Check the signs of the trajectory.</source>
        <translation>{line} : les points ne sont sur les faisceaux du scanner qu&apos;avec le signe opposé du tangage (sinon écart {misfit} mm). Les angles seront faux. Vérifiez les signes de la trajectoire.</translation>
    </message>
    <message>
        <source>{line:kept}: the points fit the beams of the scanner only with the opposite signs of roll and pitch (off by {misfit:n} mm otherwise). The angles will be wrong. Check the signs of the trajectory.</source>
        <translation>{line} : les points ne sont sur les faisceaux du scanner qu&apos;avec les signes opposés du roulis et du tangage (sinon écart {misfit} mm). Les angles seront faux. Vérifiez les signes de la trajectoire.</translation>
    </message>
    <message>
        <source>{line:kept}: the recovered points do not lie on the beams of the scanner (off by {misfit:n} mm), and the angles will be wrong. Several causes explain it: {causes:list}. Check them.</source>
        <translation>{line} : les points reconstitués ne se trouvent pas sur les faisceaux du scanner (écart {misfit} mm), et les angles seront faux. Plusieurs causes l&apos;expliquent : {causes}. Vérifiez-les.</translation>
    </message>
    <message>
        <source>{line:kept}: the recovered points do not lie on the beams of the scanner (off by {misfit:n} mm). No single error of heights, time, lever arm or signs explains it: the cloud may have been made with another trajectory, or adjusted. The angles may be wrong.</source>
        <translation>{line} : les points reconstitués ne se trouvent pas sur les faisceaux du scanner (écart {misfit} mm). Aucune erreur isolée de hauteur, de temps, de bras de levier ou de signe ne l&apos;explique : le nuage a pu être calculé avec une autre trajectoire, ou compensé. Les angles peuvent être faux.</translation>
    </message>
    <message>
        <source>{line:kept}: the recovered beams lie in a plane turned by {turn:n} deg from the axes of the scanner. If the scanner measures along its axes, the cloud was made with another boresight than the prior one. Give that boresight as the prior.</source>
        <translation>{line} : les faisceaux reconstitués sont dans un plan tourné de {turn} deg par rapport aux axes du scanneur. Si le scanneur mesure selon ses axes, le nuage a été calculé avec d&apos;autres angles de visée que les angles a priori. Indiquez-les comme a priori.</translation>
    </message>
    <message>
        <source>heights</source>
        <translation>hauteurs</translation>
    </message>
    <message>
        <source>sign of roll</source>
        <translation>signe du roulis</translation>
    </message>
    <message>
        <source>sign of pitch</source>
        <translation>signe du tangage</translation>
    </message>
    <message>
        <source>signs of roll and pitch</source>
        <translation>signes du roulis et du tangage</translation>
    </message>
    <message>
        <source>{offset:n} m are added to heights</source>
        <translation>{offset} m sont ajoutés aux hauteurs</translation>
    </message>
</context>
<context>
    <name>columns of text</name>
    <message>
        <source>degrees and minutes without a sign between them</source>
        <translation>degrés et minutes sans signe entre les deux</translation>
    </message>
    <message>
        <source>degrees and minutes without a sign between them, positive to the west</source>
        <translation>degrés et minutes sans signe entre les deux, positifs vers l&apos;ouest</translation>
    </message>
    <message>
        <source>degrees, positive to the west</source>
        <translation>degrés, positifs vers l&apos;ouest</translation>
    </message>
    <message>
        <source>radians, positive to the west</source>
        <translation>radians, positifs vers l&apos;ouest</translation>
    </message>
    <message>
        <source>degrees, minutes and seconds, positive to the west</source>
        <translation>degrés, minutes et secondes, positifs vers l&apos;ouest</translation>
    </message>
    <message>
        <source>{unit}, positive to the west</source>
        <translation>{unit}, positif vers l&apos;ouest</translation>
    </message>
    <message>
        <source>{path:file}, row {row:n}: the {place} has both a minus sign and a hemisphere; export one of them, or name the column of the hemisphere -.</source>
        <translation>{path}, ligne {row} : la valeur ({place}) porte un signe moins et un hémisphère ; exportez l&apos;un des deux, ou nommez - la colonne de l&apos;hémisphère.</translation>
    </message>
    <message>
        <source>The velocities or angular rates of the trajectory contradict its states in {names:list}. These are interpolated linearly. Check the export of velocities and rates.</source>
        <translation>Les vitesses ou les vitesses angulaires de la trajectoire contredisent ses états en : {names}. Ces composantes sont interpolées linéairement. Vérifiez l&apos;export des vitesses.</translation>
    </message>
    <message>
        <source>{line:kept}: the cloud says how it was made (boresight roll {roll:n}, pitch {pitch:n}, yaw {yaw:n} deg). The points of the scanner are recovered with these values.</source>
        <translation>{line} : le nuage indique comment il a été calculé (angles de visée : roulis {roll}, tangage {pitch}, lacet {yaw}°). Les points du scanner sont reconstitués avec ces valeurs.</translation>
    </message>
    <message>
        <source>{line:kept}: the cloud was made with the lever arm {x:n}, {y:n}, {z:n} m, which differs by {off:n} mm from the prior one. The points are recovered with the former, but the estimate uses the latter. Correct the lever arm if it was the same scanner.</source>
        <translation>{line} : le nuage a été calculé avec le bras de levier {x}, {y}, {z} m, qui diffère de {off} mm du bras de levier a priori. Les points sont reconstitués avec le premier, mais l&apos;estimation utilise le second. Corrigez le bras de levier s&apos;il s&apos;agissait du même scanner.</translation>
    </message>
    <message>
        <source>coordinates in the local frame of the cloud</source>
        <translation>coordonnées dans le repère local du nuage</translation>
    </message>
    <message>
        <source>{path:file}: this cloud was written in the local frame of a project (north, west, up), and does not say where that is; write it again, or with a coordinate system (georeference --crs), to use it as a line.</source>
        <translation>{path} : ce nuage a été écrit dans le repère local d&apos;un projet (nord, ouest, haut) et n&apos;indique pas où il se trouve ; écrivez-le de nouveau, ou avec un système de coordonnées (georeference --crs), pour l&apos;utiliser comme ligne.</translation>
    </message>
    <message>
        <source>{text:kept}: a local frame needs latitude, longitude and height of its origin (local:46.8,-71.2,20 for example).</source>
        <translation>{text} : un repère local demande la latitude, la longitude et la hauteur de son origine (local:46.8,-71.2,20 par exemple).</translation>
    </message>
    <message>
        <source>{line:kept}: point times are in steps of {step:n} ms, with {points:n} points to each step. Positions and attitudes of points are off by the motion within half a step, which does not average out. Export the line with exact times (64 bits).</source>
        <translation>{line} : les temps des points vont par pas de {step} ms, avec {points} points par pas. Positions et attitudes des points sont décalées du mouvement pendant un demi-pas, ce qui ne se compense pas. Exportez la ligne avec des temps exacts (64 bits).</translation>
    </message>
    <message>
        <source>{file:kept}: the first {count:n} points were checked. The import checks all of them.</source>
        <translation>{file} : les {count} premiers points ont été contrôlés. L&apos;importation les contrôle tous.</translation>
    </message>
    <message>
        <source>The file becomes {count:n} lines: {lines:list}.</source>
        <translation>Le fichier devient {count} lignes : {lines}.</translation>
    </message>
    <message>
        <source>{file:kept}: column {column:kept} is a magnetic heading by its title. All headings are off by the magnetic declination. Export the true heading.</source>
        <translation>{file} : la colonne {column} est un cap magnétique d&apos;après son titre. Tous les caps sont décalés de la déclinaison magnétique. Exportez le cap vrai.</translation>
    </message>
    <message>
        <source>{path:file}: the rows have {n:n} columns, but the header names {names:n}; degrees, minutes and seconds between blanks count as three columns. Export decimal degrees, or state the columns.</source>
        <translation>{path} : les lignes ont {n} colonnes, mais l&apos;en-tête en nomme {names} ; degrés, minutes et secondes séparés par des blancs comptent pour trois colonnes. Exportez des degrés décimaux ou indiquez les colonnes.</translation>
    </message>
    <message>
        <source>{path:file}: column {name:kept} is not in degrees that count to the east or north; export it so.</source>
        <translation>{path} : la colonne {name} n&apos;est pas en degrés comptés vers l&apos;est ou le nord ; exportez-la ainsi.</translation>
    </message>
    <message>
        <source>{count:n} states of the trajectory have no position (latitude and longitude are 0, as before the GNSS has a fix). They are excluded. Start the export at the first fix.</source>
        <translation>{count} états de la trajectoire n&apos;ont pas de position (latitude et longitude nulles, comme avant le premier point GNSS). Ils sont exclus. Faites commencer l&apos;export au premier point.</translation>
    </message>
    <message>
        <source>{file:kept}: the columns {columns:list} have the same meaning. {used:kept} is used. State the columns if that is the wrong one.</source>
        <translation>{file} : les colonnes {columns} ont le même sens. {used} est utilisée. Indiquez les colonnes si ce n&apos;est pas la bonne.</translation>
    </message>
    <message>
        <source>{file:kept}: the unit in the title of column {column:kept} is not known. {used} are taken. Check it.</source>
        <translation>{file} : l&apos;unité dans le titre de la colonne {column} est inconnue. Unité retenue : {used}. Vérifiez-la.</translation>
    </message>
    <message>
        <source>{path:file}: the header states {stated:kept} for column {name:kept}, which is not a known unit or has two meanings; set the unit, or mend the header.</source>
        <translation>{path} : l&apos;en-tête indique {stated} pour la colonne {name}, ce qui n&apos;est pas une unité connue ou a deux sens ; choisissez l&apos;unité ou corrigez l&apos;en-tête.</translation>
    </message>
    <message>
        <source>{path:file}: the titles of the columns do not state one unit of length for x, y and z ({words:list}); export them in one unit, or set the unit (option unit).</source>
        <translation>{path} : les titres des colonnes n&apos;indiquent pas une seule unité de longueur pour x, y et z ({words}) ; exportez-les dans une seule unité ou choisissez l&apos;unité (option unit).</translation>
    </message>
    <message>
        <source>{axis:kept} in {unit}</source>
        <translation>{axis} en {unit}</translation>
    </message>
    <message>
        <source>a unit that is not known</source>
        <translation>une unité inconnue</translation>
    </message>
    <message>
        <source>{path:file}: column {title:kept} should be {wanted}, in a unit that is known; correct its title or its values.</source>
        <translation>{path} : la colonne {title} devrait être {wanted}, dans une unité connue ; corrigez son titre ou ses valeurs.</translation>
    </message>
    <message>
        <source>kilometres</source>
        <translation>kilomètres</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>pouces</translation>
    </message>
    <message>
        <source>yards</source>
        <translation>yards</translation>
    </message>
    <message>
        <source>fathoms</source>
        <translation>brasses</translation>
    </message>
    <message>
        <source>milliradians</source>
        <translation>milliradians</translation>
    </message>
    <message>
        <source>gons</source>
        <translation>grades</translation>
    </message>
    <message>
        <source>arc seconds</source>
        <translation>secondes d&apos;arc</translation>
    </message>
    <message>
        <source>minutes of time</source>
        <translation>minutes de temps</translation>
    </message>
    <message>
        <source>hours</source>
        <translation>heures</translation>
    </message>
    <message>
        <source>radians, positive to the south</source>
        <translation>radians, positifs vers le sud</translation>
    </message>
    <message>
        <source>degrees, positive to the south</source>
        <translation>degrés, positifs vers le sud</translation>
    </message>
    <message>
        <source>milliradians, positive to the west</source>
        <translation>milliradians, positifs vers l&apos;ouest</translation>
    </message>
    <message>
        <source>milliradians, positive to the south</source>
        <translation>milliradians, positifs vers le sud</translation>
    </message>
    <message>
        <source>gons, positive to the west</source>
        <translation>grades, positifs vers l&apos;ouest</translation>
    </message>
    <message>
        <source>gons, positive to the south</source>
        <translation>grades, positifs vers le sud</translation>
    </message>
    <message>
        <source>arc minutes, positive to the west</source>
        <translation>minutes d&apos;arc, positifs vers l&apos;ouest</translation>
    </message>
    <message>
        <source>arc minutes, positive to the south</source>
        <translation>minutes d&apos;arc, positifs vers le sud</translation>
    </message>
    <message>
        <source>arc seconds, positive to the west</source>
        <translation>secondes d&apos;arc, positifs vers l&apos;ouest</translation>
    </message>
    <message>
        <source>arc seconds, positive to the south</source>
        <translation>secondes d&apos;arc, positifs vers le sud</translation>
    </message>
    <message>
        <source>degrees, minutes and seconds, positive to the south</source>
        <translation>degrés, minutes et secondes, positifs vers le sud</translation>
    </message>
    <message>
        <source>degrees and minutes without a sign between them, positive to the south</source>
        <translation>degrés et minutes sans signe entre eux, positifs vers le sud</translation>
    </message>
    <message>
        <source>None of the states of the trajectory has a position (latitude and longitude are 0 everywhere); export it from where the GNSS has a fix.</source>
        <translation>Aucun état de la trajectoire n&apos;a de position (latitude et longitude sont nulles partout) ; exportez-la à partir du premier point GNSS.</translation>
    </message>
</context>
<context>
    <name>steep pitch</name>
    <message>
        <source>The pitch of the boresight is steep, where roll and yaw can hardly be told apart: the standard deviations are those of small rotations about the body axes. Use the rotation matrix rather than the three angles.</source>
        <translation>Le tangage des angles de visée est proche de la verticale, où le roulis et le lacet se distinguent à peine : les écarts-types sont ceux de petites rotations autour des axes du navire. Utilisez la matrice de rotation plutôt que les trois angles.</translation>
    </message>
</context>
<context>
    <name>rate of a trajectory</name>
    <message>
        <source>{line:kept}: the trajectory has {rate:n} states a second, too few for its motion. Between the states the interpolation is off by up to {shift:n} mm and {turn:n} deg, {share:n} % of the stated accuracy. Export the trajectory at a higher rate.</source>
        <translation>{line} : la trajectoire a {rate} états par seconde, trop peu pour son mouvement. Entre les états, l&apos;interpolation s&apos;écarte de {shift} mm et de {turn} deg au plus, soit {share} % de la précision indiquée. Exportez la trajectoire à une cadence plus élevée.</translation>
    </message>
</context>
<context>
    <name>splitting</name>
    <message>
        <source>{path:file}: its points have no attribute {by:kept} to split by; they have {names:kept}.</source>
        <translation>{path} : ses points n&apos;ont pas d&apos;attribut {by} selon lequel diviser ; ils ont {names}.</translation>
    </message>
</context>
<context>
    <name>time bases</name>
    <message>
        <source>TAI seconds since 1970-01-01 (PTP)</source>
        <translation>secondes TAI depuis le 1970-01-01 (PTP)</translation>
    </message>
    <message>
        <source>UTC seconds of the hour</source>
        <translation>secondes UTC de l&apos;heure</translation>
    </message>
    <message>
        <source>the full hour</source>
        <translation>l&apos;heure pleine</translation>
    </message>
</context>
<context>
    <name>cache folder</name>
    <message>
        <source>{folder:file} cannot be written, so the cache is kept in {used:file}. Compiled code, the settings of the window and recent projects may be lost when the computer restarts. Make the folder writable, or choose another cache folder in the settings.</source>
        <translation>{folder} n&apos;est pas accessible en écriture ; le cache est donc conservé dans {used}. Le code compilé, les préférences de la fenêtre et les projets récents peuvent être perdus au redémarrage de l&apos;ordinateur. Rendez le dossier accessible en écriture, ou choisissez un autre dossier de cache dans les préférences.</translation>
    </message>
</context>
<context>
    <name>targets in CSV</name>
    <message>
        <source>target as CSV</source>
        <translation>cible en CSV</translation>
    </message>
    <message>
        <source>{path:file}: the first row does not name the columns of an exported target; export it again.</source>
        <translation>{path} : la première rangée ne nomme pas les colonnes d&apos;une cible exportée ; exportez-la de nouveau.</translation>
    </message>
    <message>
        <source>a target as CSV</source>
        <translation>une cible en CSV</translation>
    </message>
    <message>
        <source>LiDAR coordinates are taken; points and trajectory share one time base</source>
        <translation>Les coordonnées du LiDAR sont prises ; points et trajectoire ont la même base de temps</translation>
    </message>
    <message>
        <source>A target holds its points on all lines, not one line.</source>
        <translation>Une cible contient ses points sur toutes les lignes, pas sur une seule.</translation>
    </message>
    <message>
        <source>{path:file}: row {number:n} has {count:n} columns, not {all:n} as the head of the file; export it again.</source>
        <translation>{path} : la rangée {number} a {count} colonnes, pas {all} comme l&apos;en-tête du fichier ; exportez-le de nouveau.</translation>
    </message>
</context>
<context>
    <name>local frame</name>
</context>
<context>
    <name>several lines</name>
    <message>
        <source>The same applies to {lines:list}.</source>
        <translation>Il en va de même pour {lines}.</translation>
    </message>
</context>
</TS>
