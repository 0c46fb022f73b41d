<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR" sourcelanguage="en">
<context>
    <name>patching</name>
    <message>
        <source>LiDAR &amp;patch test</source>
        <translation>&amp;Patch test LiDAR</translation>
    </message>
    <message>
        <source>Align lines on objects: an alternative method for the boresight</source>
        <translation>Aligner les lignes sur des objets : une méthode alternative pour les angles de visée</translation>
    </message>
    <message>
        <source>Object &amp;for the patch test</source>
        <translation>Objet pour le patc&amp;h test</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Lay a box of the patch test about the next point that is clicked</source>
        <translation>Placer une boîte du patch test autour du prochain point cliqué</translation>
    </message>
    <message>
        <source>Ctrl + T, Ctrl + Shift + T</source>
        <translation>Ctrl + T, Ctrl + Maj + T</translation>
    </message>
    <message>
        <source>patch test, box about an object for it</source>
        <translation>patch test, boîte autour d&apos;un objet</translation>
    </message>
    <message>
        <source>Turn the {angle}</source>
        <translation>Tourner le {angle}</translation>
    </message>
    <message>
        <source>Drag, or arrows for 0.001° and Page up and down for 0.01°</source>
        <translation>Glisser, ou flèches pour 0,001° et Page préc. et suiv. pour 0,01°</translation>
    </message>
    <message>
        <source>{angle} with which the lines are placed in the pictures</source>
        <translation>{angle} avec lequel les lignes sont placées dans les images</translation>
    </message>
    <message>
        <source>Find this angle</source>
        <translation>Chercher</translation>
    </message>
    <message>
        <source>Turn the {angle} alone to where the mismatch of all ticked objects is smallest</source>
        <translation>Tourner le {angle} seul jusqu&apos;au plus petit écart de tous les objets cochés</translation>
    </message>
    <message>
        <source>found {value:n}°, no sigma</source>
        <translation>trouvé {value}°, sans écart-type</translation>
    </message>
    <message>
        <source>found {value:n} ± {sigma:n}°</source>
        <translation>trouvé {value} ± {sigma}°</translation>
    </message>
    <message>
        <source>Section of the lines about the object</source>
        <translation>Coupe des lignes autour de l&apos;objet</translation>
    </message>
    <message>
        <source>Mismatch over the angle</source>
        <translation>Écart en fonction de l&apos;angle</translation>
    </message>
    <message>
        <source>Click to turn the angle to there</source>
        <translation>Cliquer pour tourner l&apos;angle jusque-là</translation>
    </message>
    <message>
        <source>minimum {value:n}°</source>
        <translation>minimum {value}°</translation>
    </message>
    <message>
        <source>The patch test lays lines onto each other about objects that they share: an edge, a pillar, a pole. Turn roll, pitch and yaw until the colours fall together; where the mismatch is smallest, the boresight is right. Let objects be found, or click one in the view. Objects far and high above the vessel tell most; under bridges the position may be off.</source>
        <translation>Le patch test superpose les lignes autour d&apos;objets qu&apos;elles ont en commun : une arête, un pilier, un poteau. Tournez roulis, tangage et lacet jusqu&apos;à ce que les couleurs se confondent ; là où l&apos;écart est le plus petit, les angles de visée sont justes. Laissez chercher des objets, ou cliquez-en un dans la vue. Les objets éloignés et bien au-dessus du navire en disent le plus ; sous les ponts, la position peut être fausse.</translation>
    </message>
    <message>
        <source>Open a project with two lines or more to lay them onto each other.</source>
        <translation>Ouvrez un projet de deux lignes ou plus pour les superposer.</translation>
    </message>
    <message>
        <source>Ahead of the box</source>
        <translation>De face</translation>
    </message>
    <message>
        <source>From its left</source>
        <translation>De sa gauche</translation>
    </message>
    <message>
        <source>Object shown</source>
        <translation>Objet affiché</translation>
    </message>
    <message>
        <source>All ticked</source>
        <translation>Tous les cochés</translation>
    </message>
    <message>
        <source>Objects: tick those that count</source>
        <translation>Objets : cocher ceux qui comptent</translation>
    </message>
    <message>
        <source>Pairs of lines: tick those that count</source>
        <translation>Paires de lignes : cocher celles qui comptent</translation>
    </message>
    <message>
        <source>From where the object is looked at</source>
        <translation>D&apos;où l&apos;objet est regardé</translation>
    </message>
    <message>
        <source>Whose mismatch is drawn: of one object, or of all ticked</source>
        <translation>Écart tracé : d&apos;un objet, ou de tous les objets cochés</translation>
    </message>
    <message>
        <source>Find objects</source>
        <translation>Chercher des objets</translation>
    </message>
    <message>
        <source>Find objects that lines share, and lay boxes about them</source>
        <translation>Chercher des objets communs aux lignes et les entourer de boîtes</translation>
    </message>
    <message>
        <source>Click one</source>
        <translation>Cliquer</translation>
    </message>
    <message>
        <source>Lay a box about the next point that is clicked in the view</source>
        <translation>Placer une boîte autour du prochain point cliqué dans la vue</translation>
    </message>
    <message>
        <source>Lay a box about the selected target</source>
        <translation>Placer une boîte autour de la cible choisie</translation>
    </message>
    <message>
        <source>Take the clip box as it lies in the view</source>
        <translation>Prendre la boîte de découpe telle qu&apos;elle est dans la vue</translation>
    </message>
    <message>
        <source>Take the object off the list</source>
        <translation>Retirer l&apos;objet de la liste</translation>
    </message>
    <message>
        <source>Go to</source>
        <translation>Y aller</translation>
    </message>
    <message>
        <source>Bring the object into view</source>
        <translation>Amener l&apos;objet dans la vue</translation>
    </message>
    <message>
        <source>Find all three</source>
        <translation>Chercher les trois</translation>
    </message>
    <message>
        <source>Turn all angles to where the mismatch of all ticked objects is smallest, and say how well they are known</source>
        <translation>Tourner tous les angles jusqu&apos;au plus petit écart de tous les objets cochés, et dire leur précision</translation>
    </message>
    <message>
        <source>Start again from the prior</source>
        <translation>Repartir de l&apos;a priori</translation>
    </message>
    <message>
        <source>Turn all angles back to the prior boresight</source>
        <translation>Ramener tous les angles aux angles de visée a priori</translation>
    </message>
    <message>
        <source>Click an object that two lines see: a box is laid about it</source>
        <translation>Cliquer un objet que voient deux lignes : une boîte l&apos;entoure</translation>
    </message>
    <message>
        <source>Select a target to lay a box about it</source>
        <translation>Choisissez une cible pour l&apos;entourer d&apos;une boîte</translation>
    </message>
    <message>
        <source>Switch the clip box on (X) and lay it about an object</source>
        <translation>Activez la boîte de découpe (X) et placez-la autour d&apos;un objet</translation>
    </message>
    <message>
        <source>No two lines have points in the box; lay it about what two lines see.</source>
        <translation>Aucune paire de lignes n&apos;a de points dans la boîte ; placez-la autour de ce que voient deux lignes.</translation>
    </message>
    <message>
        <source>Looking for objects</source>
        <translation>Recherche d&apos;objets</translation>
    </message>
    <message>
        <source>Laying a box</source>
        <translation>Placement d&apos;une boîte</translation>
    </message>
    <message>
        <source>Mismatch over the {angle}: {object:kept}</source>
        <translation>Écart selon le {angle} : {object}</translation>
    </message>
    <message>
        <source>Mismatch over the {angle}: all ticked objects</source>
        <translation>Écart selon le {angle} : tous les objets cochés</translation>
    </message>
    <message>
        <source>all ticked objects</source>
        <translation>tous les objets cochés</translation>
    </message>
    <message>
        <source>{angle} alone: the mismatch is smallest at {value:n}°.</source>
        <translation>{angle} seul : l&apos;écart est le plus petit à {value}°.</translation>
    </message>
    <message>
        <source>Working out the curve</source>
        <translation>Calcul de la courbe</translation>
    </message>
    <message>
        <source>Keep this answer</source>
        <translation>Garder cette réponse</translation>
    </message>
    <message>
        <source>Keep the result in the project as an alternative method</source>
        <translation>Garder le résultat dans le projet comme méthode alternative</translation>
    </message>
    <message>
        <source>keep the patch test</source>
        <translation>garder le patch test</translation>
    </message>
    <message>
        <source>The answer of the patch test is kept in the project</source>
        <translation>La réponse du patch test est gardée dans le projet</translation>
    </message>
</context>
<context>
    <name>panels</name>
    <message>
        <source>Targets by lines</source>
        <translation>Cibles par ligne</translation>
    </message>
    <message>
        <source>Workflow</source>
        <translation>Étapes</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Résultats</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>The window changes when the running task has ended</source>
        <translation>La fenêtre changera quand la tâche en cours sera terminée</translation>
    </message>
    <message>
        <source>What the program does, takes for granted and cannot do is noted here, with the time.</source>
        <translation>Ce que le programme fait, tient pour acquis ou ne peut pas faire est noté ici, avec l&apos;heure.</translation>
    </message>
</context>
<context>
    <name>questions</name>
    <message>
        <source>{name} has work that was not saved when the program ended.</source>
        <translation>{name} contient du travail qui n&apos;était pas enregistré quand le programme s&apos;est arrêté.</translation>
    </message>
    <message>
        <source>It was written down last on {when}. One undo step takes it back again.</source>
        <translation>Il a été noté pour la dernière fois le {when}. Une seule annulation le retire.</translation>
    </message>
    <message>
        <source>{when}; the project was saved later, at {saved}</source>
        <translation>{when} ; le projet a été enregistré plus tard, le {saved}</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Restaurer</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>{name} is open in another window already.</source>
        <translation>{name} est déjà ouvert dans une autre fenêtre.</translation>
    </message>
    <message>
        <source>{host:kept}, process {process:kept}</source>
        <translation>{host}, processus {process}</translation>
    </message>
    <message>
        <source>It is open in {where}. Of two windows the one that saves last overwrites the other, and unsaved work of the second is not kept against a crash.</source>
        <translation>Il est ouvert ailleurs : {where}. De deux fenêtres, celle qui enregistre en dernier écrase l&apos;autre, et le travail non enregistré de la seconde n&apos;est pas protégé contre un plantage.</translation>
    </message>
    <message>
        <source>0.01 deg error = {parted} misalignment</source>
        <translation>0,01° d&apos;erreur = {parted} de décalage</translation>
    </message>
    <message>
        <source>another inclination is missing</source>
        <translation>il manque une autre inclinaison</translation>
    </message>
    <message>
        <source>This target faces the same way as the other, so the angles stay open. Take it back with Ctrl+Z, then Ctrl+click the board that leans back and press Return.</source>
        <translation>Cette cible fait face au même côté que l&apos;autre, et les angles restent indéterminés. Annulez-la par Ctrl+Z, puis faites Ctrl+clic sur le panneau incliné et appuyez sur Entrée.</translation>
    </message>
    <message>
        <source>Unsaved work of this window is not kept against a crash: another window has the project open.</source>
        <translation>Le travail non enregistré de cette fenêtre n&apos;est pas protégé contre un plantage : une autre fenêtre a le projet ouvert.</translation>
    </message>
    <message>
        <source>Close it here</source>
        <translation>Le fermer ici</translation>
    </message>
    <message>
        <source>Leave without these files?</source>
        <translation>Quitter sans ces fichiers ?</translation>
    </message>
    <message>
        <source>What was set for them here is forgotten. The files themselves stay as they are.</source>
        <translation>Ce qui a été réglé ici pour eux est oublié. Les fichiers eux-mêmes restent tels quels.</translation>
    </message>
    <message>
        <source>Stay here</source>
        <translation>Rester ici</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>Open it all the same</source>
        <translation>L&apos;ouvrir quand même</translation>
    </message>
    <message>
        <source>{name} was written by another program since it was opened here.</source>
        <translation>{name} a été modifié par un autre programme depuis son ouverture ici.</translation>
    </message>
    <message>
        <source>Saving overwrites that. File &gt; Save as… keeps both, in another folder.</source>
        <translation>Enregistrer écraserait cette version. Fichier &gt; Enregistrer sous… garde les deux, dans un autre dossier.</translation>
    </message>
    <message>
        <source>Overwrite it</source>
        <translation>L&apos;écraser</translation>
    </message>
    <message>
        <source>recovery of unsaved work</source>
        <translation>récupération du travail non enregistré</translation>
    </message>
    <message>
        <source>What was not saved is back; save the project to keep it</source>
        <translation>Le travail non enregistré est de retour ; enregistrez le projet pour le garder</translation>
    </message>
    <message>
        <source>Unsaved work is not kept against a crash: {error}</source>
        <translation>Le travail non enregistré n&apos;est pas protégé contre un plantage : {error}</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>un autre programme</translation>
    </message>
    <message>
        <source>Add the files to {name}?</source>
        <translation>Ajouter les fichiers à {name} ?</translation>
    </message>
    <message>
        <source>Add to {name}</source>
        <translation>Ajouter à {name}</translation>
    </message>
    <message>
        <source>Save the changes to {name}?</source>
        <translation>Enregistrer les modifications de {name} ?</translation>
    </message>
    <message>
        <source>{name} was found and is not accepted yet.</source>
        <translation>{name} a été trouvé et n&apos;est pas encore accepté.</translation>
    </message>
    <message>
        <source>Do not save</source>
        <translation>Ne pas enregistrer</translation>
    </message>
    <message>
        <source>Unsaved changes will be lost.</source>
        <translation>Les modifications non enregistrées seront perdues.</translation>
    </message>
    <message>
        <source>{name:kept} cannot find {counted} it was made from.</source>
        <translation>{name} ne trouve pas {counted} dont il est fait.</translation>
    </message>
    <message>
        <source>Choose the folder that they are in now, or one above it.</source>
        <translation>Choisissez le dossier où ils sont maintenant, ou un dossier plus haut.</translation>
    </message>
    <message>
        <source>Choose the folder…</source>
        <translation>Choisir le dossier…</translation>
    </message>
    <message>
        <source>Folder with the files of the project</source>
        <translation>Dossier des fichiers du projet</translation>
    </message>
    <message>
        <source>and {more:n} more</source>
        <translation>et {more} autres</translation>
    </message>
    <message>
        <source>{name:kept} was not opened: its files are missing</source>
        <translation>{name} n&apos;a pas été ouvert : ses fichiers manquent</translation>
    </message>
    <message>
        <source>The files were found; save the project to keep where they are</source>
        <translation>Les fichiers sont trouvés ; enregistrez le projet pour garder où ils sont</translation>
    </message>
</context>
<context>
    <name>logbook</name>
    <message>
        <source>Open the &amp;log file</source>
        <translation>Ouvrir le fichier &amp;journal</translation>
    </message>
    <message>
        <source>Log file</source>
        <translation>Fichier journal</translation>
    </message>
    <message>
        <source>What happened and when, with the details of every error</source>
        <translation>Ce qui s&apos;est passé et quand, avec les détails de chaque erreur</translation>
    </message>
    <message>
        <source>No program is set up to open {file:kept}</source>
        <translation>Aucun programme n&apos;est prévu pour ouvrir {file}</translation>
    </message>
    <message>
        <source>{title}: done after {time}</source>
        <translation>{title} : terminé après {time}</translation>
    </message>
    <message>
        <source>{title}: failed after {time}</source>
        <translation>{title} : échec après {time}</translation>
    </message>
</context>
<context>
    <name>menus</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>&amp;Inspect</source>
        <translation>&amp;Examen</translation>
    </message>
    <message>
        <source>&amp;Targets</source>
        <translation>&amp;Cibles</translation>
    </message>
    <message>
        <source>&amp;Adjust</source>
        <translation>Co&amp;mpensation</translation>
    </message>
    <message>
        <source>Va&amp;lidate</source>
        <translation>&amp;Validation</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;ide</translation>
    </message>
    <message>
        <source>Toolbar</source>
        <translation>Barre d&apos;outils</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nouveau</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Demo</source>
        <translation>Démo</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation>Coordonnées</translation>
    </message>
    <message>
        <source>Propose</source>
        <translation>Proposer</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Accepter</translation>
    </message>
    <message>
        <source>Reject</source>
        <translation>Rejeter</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>Estimer</translation>
    </message>
    <message>
        <source>Validate</source>
        <translation>Valider</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Contrôler</translation>
    </message>
    <message>
        <source>Budget</source>
        <translation>Bilan</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>Visibility</source>
        <translation>Visibilité</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>Conception</translation>
    </message>
    <message>
        <source>Switch</source>
        <translation>Basculer</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>About</source>
        <translation>À propos</translation>
    </message>
    <message>
        <source>Add lines</source>
        <translation>Ajouter des lignes</translation>
    </message>
    <message>
        <source>&amp;New project…</source>
        <translation>&amp;Nouveau projet…</translation>
    </message>
    <message>
        <source>Make a project from a trajectory and raw lines</source>
        <translation>Créer un projet à partir d&apos;une trajectoire et de lignes brutes</translation>
    </message>
    <message>
        <source>&amp;Open project…</source>
        <translation>&amp;Ouvrir un projet…</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>Ouvrir un projet</translation>
    </message>
    <message>
        <source>Open &amp;demo survey</source>
        <translation>Ouvrir le levé de &amp;démonstration</translation>
    </message>
    <message>
        <source>Open the built-in simulated survey</source>
        <translation>Ouvrir le levé simulé fourni avec le programme</translation>
    </message>
    <message>
        <source>Add &amp;lines…</source>
        <translation>Ajouter des &amp;lignes…</translation>
    </message>
    <message>
        <source>Add more lines to the open project</source>
        <translation>Ajouter d&apos;autres lignes au projet ouvert</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Enregistrer le projet</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Enregistrer sous</translation>
    </message>
    <message>
        <source>Save the project in another folder and go on there</source>
        <translation>Enregistrer le projet dans un autre dossier et y continuer</translation>
    </message>
    <message>
        <source>&amp;Export report…</source>
        <translation>E&amp;xporter le rapport…</translation>
    </message>
    <message>
        <source>Write the report as PDF, HTML, JSON or tables (CSV in a ZIP)</source>
        <translation>Écrire le rapport en PDF, HTML, JSON ou tableaux (CSV dans un ZIP)</translation>
    </message>
    <message>
        <source>Export &amp;georeferenced lines…</source>
        <translation>Exporter les lignes &amp;géoréférencées…</translation>
    </message>
    <message>
        <source>Write every line as LAZ or LAS in a coordinate system of your choice</source>
        <translation>Écrire chaque ligne en LAZ ou LAS dans le système de coordonnées de votre choix</translation>
    </message>
    <message>
        <source>Export &amp;targets…</source>
        <translation>Exporter les &amp;cibles…</translation>
    </message>
    <message>
        <source>Write the points of targets and validation planes, or plane files</source>
        <translation>Écrire les points des cibles et des plans de validation, ou des fichiers de plans</translation>
    </message>
    <message>
        <source>Export tra&amp;jectory…</source>
        <translation>Exporter la tra&amp;jectoire…</translation>
    </message>
    <message>
        <source>Write the trajectory as SBET or text</source>
        <translation>Écrire la trajectoire en SBET ou en texte</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>Close the program</source>
        <translation>Fermer le programme</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Projets &amp;récents</translation>
    </message>
    <message>
        <source>No project yet</source>
        <translation>Aucun projet pour l&apos;instant</translation>
    </message>
    <message>
        <source>Clear recent projects</source>
        <translation>Effacer les projets récents</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Undo {text}</source>
        <translation>&amp;Annuler : {text}</translation>
    </message>
    <message>
        <source>Take the last edit back</source>
        <translation>Annuler la dernière modification</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>&amp;Redo {text}</source>
        <translation>&amp;Rétablir : {text}</translation>
    </message>
    <message>
        <source>Make the edit again</source>
        <translation>Rétablir la modification annulée</translation>
    </message>
    <message>
        <source>Seed an adjustment &amp;target</source>
        <translation>Désigner une &amp;cible</translation>
    </message>
    <message>
        <source>The next Ctrl+click picks an adjustment target</source>
        <translation>Le prochain Ctrl+clic désigne une cible de la compensation</translation>
    </message>
    <message>
        <source>Seed a &amp;validation plane</source>
        <translation>Désigner un plan de &amp;validation</translation>
    </message>
    <message>
        <source>The next Ctrl+click picks a validation plane</source>
        <translation>Le prochain Ctrl+clic désigne un plan de validation</translation>
    </message>
    <message>
        <source>Seed at &amp;coordinates…</source>
        <translation>Désigner par c&amp;oordonnées…</translation>
    </message>
    <message>
        <source>Type the coordinates of a seed, in the local frame or on the map</source>
        <translation>Saisir les coordonnées d&apos;un point initial, dans le repère local ou sur la carte</translation>
    </message>
    <message>
        <source>Seeds &amp;from a file…</source>
        <translation>Points initiaux d&apos;un &amp;fichier…</translation>
    </message>
    <message>
        <source>Seed list</source>
        <translation>Liste de points initiaux</translation>
    </message>
    <message>
        <source>Pick all targets of a list of coordinates, from a total station for example</source>
        <translation>Désigner toutes les cibles d&apos;une liste de coordonnées, d&apos;une station totale par exemple</translation>
    </message>
    <message>
        <source>&amp;Propose targets</source>
        <translation>&amp;Proposer des cibles</translation>
    </message>
    <message>
        <source>Find flat surfaces on all lines and propose targets and validation planes</source>
        <translation>Chercher des surfaces planes sur toutes les lignes et proposer des cibles et des plans de validation</translation>
    </message>
    <message>
        <source>F&amp;ind again with other settings…</source>
        <translation>Chercher de &amp;nouveau avec d&apos;autres réglages…</translation>
    </message>
    <message>
        <source>Find again</source>
        <translation>Chercher de nouveau</translation>
    </message>
    <message>
        <source>Seek the selected target with another threshold or search radius</source>
        <translation>Chercher la cible sélectionnée avec un autre seuil ou un autre rayon de recherche</translation>
    </message>
    <message>
        <source>&amp;Accept the plane found</source>
        <translation>&amp;Accepter le plan trouvé</translation>
    </message>
    <message>
        <source>Accept the detected plane</source>
        <translation>Accepter le plan détecté</translation>
    </message>
    <message>
        <source>Re&amp;ject the plane found</source>
        <translation>Re&amp;jeter le plan trouvé</translation>
    </message>
    <message>
        <source>Discard the detected plane</source>
        <translation>Abandonner le plan détecté</translation>
    </message>
    <message>
        <source>&amp;Estimate boresight</source>
        <translation>&amp;Estimer les angles de visée</translation>
    </message>
    <message>
        <source>Adjust boresight and planes together</source>
        <translation>Compenser ensemble les angles de visée et les plans</translation>
    </message>
    <message>
        <source>&amp;Validate</source>
        <translation>&amp;Valider</translation>
    </message>
    <message>
        <source>Compare the lines on the validation planes</source>
        <translation>Comparer les lignes sur les plans de validation</translation>
    </message>
    <message>
        <source>Check against a &amp;reference…</source>
        <translation>Contrôler par une &amp;référence…</translation>
    </message>
    <message>
        <source>Compare the lines with a static scan or surveyed points</source>
        <translation>Comparer les lignes à un balayage statique ou à des points levés</translation>
    </message>
    <message>
        <source>Error &amp;budget…</source>
        <translation>&amp;Bilan d&apos;erreurs…</translation>
    </message>
    <message>
        <source>What each source of error does to a point at a distance</source>
        <translation>Ce que chaque source d&apos;erreur fait à un point à une distance donnée</translation>
    </message>
    <message>
        <source>Calibrations over the &amp;years…</source>
        <translation>Étalonnages au fil des &amp;ans…</translation>
    </message>
    <message>
        <source>All calibrations of a vessel&apos;s system: has its mounting moved?</source>
        <translation>Tous les étalonnages du système d&apos;un navire : son montage a-t-il bougé ?</translation>
    </message>
    <message>
        <source>&amp;Subsampling study…</source>
        <translation>Étude du &amp;sous-échantillonnage…</translation>
    </message>
    <message>
        <source>Adjust with points nearer together and farther apart, and compare</source>
        <translation>Compenser avec des points plus rapprochés et plus espacés, et comparer</translation>
    </message>
    <message>
        <source>&amp;Visibility of errors…</source>
        <translation>&amp;Visibilité des erreurs…</translation>
    </message>
    <message>
        <source>Which board and which lines show which systematic error</source>
        <translation>Quel panneau et quelles lignes montrent quelle erreur systématique</translation>
    </message>
    <message>
        <source>&amp;Design a site…</source>
        <translation>&amp;Concevoir un site…</translation>
    </message>
    <message>
        <source>Which boards, where, and which lines: see what they will give before surveying</source>
        <translation>Quels panneaux, où, et quelles lignes : voir ce qu&apos;ils donneront avant le levé</translation>
    </message>
    <message>
        <source>&amp;Cancel the running task</source>
        <translation>&amp;Annuler la tâche en cours</translation>
    </message>
    <message>
        <source>Stop; nothing is changed</source>
        <translation>Arrêter ; rien n&apos;est modifié</translation>
    </message>
    <message>
        <source>&amp;Before (prior boresight)</source>
        <translation>A&amp;vant (angles de visée a priori)</translation>
    </message>
    <message>
        <source>Show the lines placed with the prior boresight</source>
        <translation>Montrer les lignes placées avec les angles de visée a priori</translation>
    </message>
    <message>
        <source>&amp;After (estimated boresight)</source>
        <translation>&amp;Après (angles de visée estimés)</translation>
    </message>
    <message>
        <source>Show the lines placed with the estimated boresight</source>
        <translation>Montrer les lignes placées avec les angles de visée estimés</translation>
    </message>
    <message>
        <source>&amp;Switch before / after</source>
        <translation>&amp;Basculer avant / après</translation>
    </message>
    <message>
        <source>Switch the view between prior and estimated boresight</source>
        <translation>Basculer la vue 3D entre les angles de visée a priori et estimés</translation>
    </message>
    <message>
        <source>&amp;Mouse and keys</source>
        <translation>&amp;Souris et clavier</translation>
    </message>
    <message>
        <source>What mouse and keys do</source>
        <translation>Ce que font la souris et les touches</translation>
    </message>
    <message>
        <source>&amp;About LISPAC</source>
        <translation>À &amp;propos de LISPAC</translation>
    </message>
    <message>
        <source>Version and conventions</source>
        <translation>Version et conventions</translation>
    </message>
    <message>
        <source>&amp;Fit all</source>
        <translation>&amp;Tout montrer</translation>
    </message>
    <message>
        <source>Fit all</source>
        <translation>Tout montrer</translation>
    </message>
    <message>
        <source>Bring everything into view</source>
        <translation>Faire entrer tout dans la vue 3D</translation>
    </message>
    <message>
        <source>Fit s&amp;election</source>
        <translation>Montrer la &amp;sélection</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Sélection</translation>
    </message>
    <message>
        <source>Bring the selected target or sighting into view</source>
        <translation>Faire entrer la cible ou l&apos;observation sélectionnée dans la vue 3D</translation>
    </message>
    <message>
        <source>&amp;Isometric</source>
        <translation>&amp;Isométrique</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isométrique</translation>
    </message>
    <message>
        <source>Look from above at an angle</source>
        <translation>Regarder d&apos;en haut, en biais</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Dessus</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>Look straight down, north up</source>
        <translation>Regarder d&apos;aplomb, le nord en haut</translation>
    </message>
    <message>
        <source>F&amp;ront</source>
        <translation>De &amp;face</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Face</translation>
    </message>
    <message>
        <source>Look from the vessel</source>
        <translation>Regarder depuis le navire</translation>
    </message>
    <message>
        <source>From the &amp;left</source>
        <translation>De la &amp;gauche</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Look from the left, as the vessel sees</source>
        <translation>Regarder de la gauche, vue du navire</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>De l&apos;&amp;arrière</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Arrière</translation>
    </message>
    <message>
        <source>Look towards the vessel</source>
        <translation>Regarder vers le navire</translation>
    </message>
    <message>
        <source>From the ri&amp;ght</source>
        <translation>De la d&amp;roite</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Look from the right, as the vessel sees</source>
        <translation>Regarder de la droite, vue du navire</translation>
    </message>
    <message>
        <source>Along the target&apos;s &amp;normal</source>
        <translation>Le long de la &amp;normale de la cible</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Look squarely at the selected target</source>
        <translation>Regarder la cible sélectionnée bien en face</translation>
    </message>
    <message>
        <source>&amp;Orthographic</source>
        <translation>&amp;Orthographique</translation>
    </message>
    <message>
        <source>Ortho</source>
        <translation>Ortho</translation>
    </message>
    <message>
        <source>Draw without perspective: equal lengths look equal at every distance</source>
        <translation>Dessiner sans perspective : des longueurs égales paraissent égales à toute distance</translation>
    </message>
    <message>
        <source>La&amp;rger points</source>
        <translation>Points plus &amp;gros</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Plus gros</translation>
    </message>
    <message>
        <source>Draw larger points</source>
        <translation>Dessiner des points plus gros</translation>
    </message>
    <message>
        <source>S&amp;maller points</source>
        <translation>Points plus &amp;petits</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Plus petits</translation>
    </message>
    <message>
        <source>Draw smaller points</source>
        <translation>Dessiner des points plus petits</translation>
    </message>
    <message>
        <source>&amp;Next colouring</source>
        <translation>Coloration &amp;suivante</translation>
    </message>
    <message>
        <source>Colour the points by line, height, intensity, range, time, residual, in turn</source>
        <translation>Colorer les points par ligne, hauteur, intensité, distance, temps, résidu, tour à tour</translation>
    </message>
    <message>
        <source>Colour by &amp;line</source>
        <translation>Par &amp;ligne</translation>
    </message>
    <message>
        <source>Each line in its own colour</source>
        <translation>Chaque ligne dans sa couleur</translation>
    </message>
    <message>
        <source>Colour by &amp;height</source>
        <translation>Par &amp;hauteur</translation>
    </message>
    <message>
        <source>Colour the points by height</source>
        <translation>Colorer les points par hauteur</translation>
    </message>
    <message>
        <source>Colour by &amp;intensity</source>
        <translation>Par &amp;intensité</translation>
    </message>
    <message>
        <source>Colour the points by the intensity in their file</source>
        <translation>Colorer les points par l&apos;intensité de leur fichier</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>Intensité</translation>
    </message>
    <message>
        <source>Colour by &amp;range</source>
        <translation>Par &amp;distance</translation>
    </message>
    <message>
        <source>Colour the points by their distance from the scanner</source>
        <translation>Colorer les points par leur distance au scanneur</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>Colour by ti&amp;me</source>
        <translation>Par &amp;temps</translation>
    </message>
    <message>
        <source>Colour the points by the time they were measured</source>
        <translation>Colorer les points par le temps de leur mesure</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Sa&amp;ve the picture…</source>
        <translation>Enregistrer l&apos;i&amp;mage…</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Write what the view shows as PNG</source>
        <translation>Écrire en PNG ce que montre la vue 3D</translation>
    </message>
    <message>
        <source>Cop&amp;y the picture</source>
        <translation>Copier l&apos;imag&amp;e</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copy what the view shows, to be pasted elsewhere</source>
        <translation>Copier ce que montre la vue 3D, pour le coller ailleurs</translation>
    </message>
    <message>
        <source>Colour by r&amp;esidual</source>
        <translation>Par &amp;résidu</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Résidu</translation>
    </message>
    <message>
        <source>Colour targets by the distance from the adjusted surface, and validation planes by that from the plane of all lines as they are shown</source>
        <translation>Colorer les cibles par la distance à la surface compensée, et les plans de validation par celle au plan de toutes les lignes telles qu&apos;elles sont montrées</translation>
    </message>
    <message>
        <source>&amp;Section across the target</source>
        <translation>&amp;Coupe en travers de la cible</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>Lay a strip across the selected target: all lines side by side at true scale</source>
        <translation>Poser une bande en travers de la cible sélectionnée : toutes les lignes côte à côte, à l&apos;échelle vraie</translation>
    </message>
    <message>
        <source>Section &amp;between two points</source>
        <translation>Coupe &amp;entre deux points</translation>
    </message>
    <message>
        <source>Cut through the lines from one clicked point to another</source>
        <translation>Couper les lignes d&apos;un point cliqué à un autre</translation>
    </message>
    <message>
        <source>Save the section&apos;s &amp;picture…</source>
        <translation>Enregistrer l&apos;&amp;image de la coupe…</translation>
    </message>
    <message>
        <source>Write the section as it is shown, as PNG, SVG or PDF</source>
        <translation>Écrire la coupe telle qu&apos;elle est montrée, en PNG, SVG ou PDF</translation>
    </message>
    <message>
        <source>Cop&amp;y the section&apos;s picture</source>
        <translation>Co&amp;pier l&apos;image de la coupe</translation>
    </message>
    <message>
        <source>Copy the section as it is shown, to be pasted elsewhere</source>
        <translation>Copier la coupe telle qu&apos;elle est montrée, pour la coller ailleurs</translation>
    </message>
    <message>
        <source>Measure a &amp;distance</source>
        <translation>Mesurer une &amp;distance</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>Click two points: slope, horizontal and vertical distance</source>
        <translation>Cliquer deux points : distance suivant la pente, horizontale et verticale</translation>
    </message>
    <message>
        <source>Measure an &amp;angle</source>
        <translation>Mesurer un &amp;angle</translation>
    </message>
    <message>
        <source>Click a point, the corner and another point</source>
        <translation>Cliquer un point, le sommet et un autre point</translation>
    </message>
    <message>
        <source>&amp;Clip box</source>
        <translation>&amp;Boîte de découpe</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Découpe</translation>
    </message>
    <message>
        <source>Clip box</source>
        <translation>Boîte de découpe</translation>
    </message>
    <message>
        <source>Draw only what lies in a box about the selected target</source>
        <translation>Ne dessiner que ce qui est dans une boîte autour de la cible sélectionnée</translation>
    </message>
    <message>
        <source>Before and after in o&amp;ne picture</source>
        <translation>Avant et après en &amp;une image</translation>
    </message>
    <message>
        <source>Wipe</source>
        <translation>Volet</translation>
    </message>
    <message>
        <source>Before on the left, after on the right of a line that the mouse moves</source>
        <translation>Avant à gauche, après à droite d&apos;un trait que la souris déplace</translation>
    </message>
    <message>
        <source>S&amp;how what a click would take</source>
        <translation>&amp;Montrer ce qu&apos;un clic prendrait</translation>
    </message>
    <message>
        <source>Hover</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Outline the plane under the resting mouse</source>
        <translation>Tracer le contour du plan sous la souris au repos</translation>
    </message>
    <message>
        <source>A&amp;dd points with a lasso</source>
        <translation>Ajouter des points au &amp;lasso</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Draw around points near the selected target to add them to it</source>
        <translation>Entourer des points près de la cible sélectionnée pour les lui ajouter</translation>
    </message>
    <message>
        <source>Re&amp;move points with a lasso</source>
        <translation>Reti&amp;rer des points au lasso</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Draw around points of the selected target to take them from it</source>
        <translation>Entourer des points de la cible sélectionnée pour les lui retirer</translation>
    </message>
    <message>
        <source>Change the &amp;role</source>
        <translation>Changer le r&amp;ôle</translation>
    </message>
    <message>
        <source>Make a validation plane of the selected target, or a target of it</source>
        <translation>Faire de la cible sélectionnée un plan de validation, ou l&apos;inverse</translation>
    </message>
    <message>
        <source>&amp;End the tool</source>
        <translation>&amp;Quitter l&apos;outil</translation>
    </message>
    <message>
        <source>Give the mouse back to the view</source>
        <translation>Rendre la souris à la vue 3D</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>&amp;Regarder depuis</translation>
    </message>
    <message>
        <source>&amp;Colour by</source>
        <translation>&amp;Colorer par</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>Pa&amp;nneaux</translation>
    </message>
    <message>
        <source>&amp;Arrange as at first</source>
        <translation>&amp;Disposer comme au début</translation>
    </message>
    <message>
        <source>Arrange</source>
        <translation>Disposer</translation>
    </message>
    <message>
        <source>Put every panel back in its place, also those that float or were closed</source>
        <translation>Remettre chaque panneau à sa place, même flottant ou fermé</translation>
    </message>
</context>
<context>
    <name>keys</name>
    <message>
        <source>Mouse and keys</source>
        <translation>Souris et clavier</translation>
    </message>
    <message>
        <source>The view</source>
        <translation>La vue 3D</translation>
    </message>
    <message>
        <source>Drag, arrows</source>
        <translation>Glisser, flèches</translation>
    </message>
    <message>
        <source>rotate about what is under the mouse, about the middle</source>
        <translation>tourner autour de ce qui est sous la souris, autour du milieu</translation>
    </message>
    <message>
        <source>Shift + drag, Shift + arrows</source>
        <translation>Maj + glisser, Maj + flèches</translation>
    </message>
    <message>
        <source>move; so does a drag with the right or middle button</source>
        <translation>déplacer, comme glisser avec le bouton droit ou central</translation>
    </message>
    <message>
        <source>Wheel, Page up and down</source>
        <translation>Molette, Page préc. et suiv.</translation>
    </message>
    <message>
        <source>closer and farther</source>
        <translation>plus près, plus loin</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Double-clic</translation>
    </message>
    <message>
        <source>look at the point there</source>
        <translation>regarder ce point</translation>
    </message>
    <message>
        <source>fit everything, fit the selected target</source>
        <translation>tout montrer, montrer la cible sélectionnée</translation>
    </message>
    <message>
        <source>look isometric, from the top, front, left, back, right</source>
        <translation>vue isométrique, de dessus, de face, de gauche, de l&apos;arrière, de droite</translation>
    </message>
    <message>
        <source>look along the normal of the selected target</source>
        <translation>regarder le long de la normale de la cible sélectionnée</translation>
    </message>
    <message>
        <source>orthographic or perspective</source>
        <translation>orthographique ou en perspective</translation>
    </message>
    <message>
        <source>larger, smaller points</source>
        <translation>points plus gros, plus petits</translation>
    </message>
    <message>
        <source>colour by line, height, intensity, range, time, residual</source>
        <translation>colorer par ligne, hauteur, intensité, distance, temps, résidu</translation>
    </message>
    <message>
        <source>switch between before and after</source>
        <translation>basculer entre avant et après</translation>
    </message>
    <message>
        <source>before and after in one picture: drag the line, or Ctrl + arrows</source>
        <translation>avant et après en une image : glisser le trait, ou Ctrl + flèches</translation>
    </message>
    <message>
        <source>save the picture of the view, copy it</source>
        <translation>enregistrer l&apos;image de la vue 3D, la copier</translation>
    </message>
    <message>
        <source>Designing a site (Ctrl + Shift + D)</source>
        <translation>Concevoir un site (Ctrl + Maj + D)</translation>
    </message>
    <message>
        <source>Drag a line, its arrow</source>
        <translation>Glisser une ligne, sa flèche</translation>
    </message>
    <message>
        <source>nearer or farther, turn it; Shift: not in steps</source>
        <translation>plus près ou plus loin, la tourner ; Maj : sans pas</translation>
    </message>
    <message>
        <source>Drag a target</source>
        <translation>Glisser une cible</translation>
    </message>
    <message>
        <source>along the wall and up; in 3D its dots, off the wall too</source>
        <translation>le long du mur et en hauteur ; en 3D par ses points, hors du mur aussi</translation>
    </message>
    <message>
        <source>Page up and down</source>
        <translation>Page préc. et suiv.</translation>
    </message>
    <message>
        <source>choose a line or target</source>
        <translation>choisir une ligne ou une cible</translation>
    </message>
    <message>
        <source>Arrows, Shift + arrows</source>
        <translation>Flèches, Maj + flèches</translation>
    </message>
    <message>
        <source>move or turn it, in fine steps</source>
        <translation>la déplacer ou la tourner, par pas fins</translation>
    </message>
    <message>
        <source>Insert, Delete</source>
        <translation>Inser, Suppr</translation>
    </message>
    <message>
        <source>add one, remove it</source>
        <translation>en ajouter une, la retirer</translation>
    </message>
    <message>
        <source>Ctrl + D, Alt + Up, Down</source>
        <translation>Ctrl + D, Alt + Haut, Bas</translation>
    </message>
    <message>
        <source>line again, a turn earlier, later</source>
        <translation>même ligne encore, un tour plus tôt, plus tard</translation>
    </message>
    <message>
        <source>Ctrl + L, Ctrl + B</source>
        <translation>Ctrl + L, Ctrl + B</translation>
    </message>
    <message>
        <source>add a line, a board</source>
        <translation>ajouter une ligne, un panneau</translation>
    </message>
    <message>
        <source>Ctrl + Shift + B</source>
        <translation>Ctrl + Maj + B</translation>
    </message>
    <message>
        <source>add a ball</source>
        <translation>ajouter une sphère</translation>
    </message>
    <message>
        <source>Looking into it</source>
        <translation>Examiner</translation>
    </message>
    <message>
        <source>section across the selected target, between two points</source>
        <translation>coupe en travers de la cible sélectionnée, entre deux points</translation>
    </message>
    <message>
        <source>Ctrl + P, Ctrl + Shift + P</source>
        <translation>Ctrl + P, Ctrl + Maj + P</translation>
    </message>
    <message>
        <source>save the picture of the section, copy it</source>
        <translation>enregistrer l&apos;image de la coupe, la copier</translation>
    </message>
    <message>
        <source>measure a distance, an angle</source>
        <translation>mesurer une distance, un angle</translation>
    </message>
    <message>
        <source>clip box about the selected target, or none</source>
        <translation>boîte de découpe autour de la cible, ou aucune</translation>
    </message>
    <message>
        <source>show what a click would take under the resting mouse</source>
        <translation>montrer ce que prendrait un clic sous la souris au repos</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Échap</translation>
    </message>
    <message>
        <source>end measuring or the lasso</source>
        <translation>terminer la mesure ou le lasso</translation>
    </message>
    <message>
        <source>Ctrl + click</source>
        <translation>Ctrl + clic</translation>
    </message>
    <message>
        <source>set a seed on a target</source>
        <translation>poser un point initial sur une cible</translation>
    </message>
    <message>
        <source>type the coordinates of a seed, read a list of them</source>
        <translation>saisir les coordonnées d&apos;un point initial, lire une liste de points initiaux</translation>
    </message>
    <message>
        <source>Enter, Esc</source>
        <translation>Entrée, Échap</translation>
    </message>
    <message>
        <source>accept or reject the plane just found</source>
        <translation>accepter ou rejeter le plan qui vient d&apos;être trouvé</translation>
    </message>
    <message>
        <source>propose targets, find the selected one again</source>
        <translation>proposer des cibles, chercher de nouveau celle qui est sélectionnée</translation>
    </message>
    <message>
        <source>next seed is an adjustment target, a validation plane</source>
        <translation>le prochain point initial est celui d&apos;une cible, d&apos;un plan de validation</translation>
    </message>
    <message>
        <source>target to validation plane, or the other way round</source>
        <translation>de cible à plan de validation, ou l&apos;inverse</translation>
    </message>
    <message>
        <source>lasso: add points to the selected target, remove points</source>
        <translation>lasso : ajouter des points à la cible sélectionnée, en retirer</translation>
    </message>
    <message>
        <source>The project</source>
        <translation>Le projet</translation>
    </message>
    <message>
        <source>estimate, validate</source>
        <translation>estimer, valider</translation>
    </message>
    <message>
        <source>study the distance between points</source>
        <translation>étudier la distance entre les points</translation>
    </message>
    <message>
        <source>check against a reference, calibrations over the years</source>
        <translation>contrôler par une référence, étalonnages au fil des ans</translation>
    </message>
    <message>
        <source>cancel the running task</source>
        <translation>annuler la tâche en cours</translation>
    </message>
    <message>
        <source>Ctrl + E, Ctrl + Shift + E</source>
        <translation>Ctrl + E, Ctrl + Maj + E</translation>
    </message>
    <message>
        <source>export the report, the georeferenced lines</source>
        <translation>exporter le rapport, les lignes géoréférencées</translation>
    </message>
    <message>
        <source>Ctrl + Z, Ctrl + Y</source>
        <translation>Ctrl + Z, Ctrl + Y</translation>
    </message>
    <message>
        <source>undo, redo</source>
        <translation>annuler, rétablir</translation>
    </message>
    <message>
        <source>Ctrl + N, Ctrl + O, Ctrl + S</source>
        <translation>Ctrl + N, Ctrl + O, Ctrl + S</translation>
    </message>
    <message>
        <source>new project, open, save</source>
        <translation>nouveau projet, ouvrir, enregistrer</translation>
    </message>
    <message>
        <source>F, Shift + F</source>
        <translation>F, Maj + F</translation>
    </message>
    <message>
        <source>O</source>
        <translation>O</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>P, Shift + P</source>
        <translation>P, Maj + P</translation>
    </message>
    <message>
        <source>F9</source>
        <translation>F9</translation>
    </message>
    <message>
        <source>scenarios</source>
        <translation>scénarios</translation>
    </message>
    <message>
        <source>S, Shift + S</source>
        <translation>S, Maj + S</translation>
    </message>
    <message>
        <source>M, Shift + M</source>
        <translation>M, Maj + M</translation>
    </message>
    <message>
        <source>F3, Shift + F3</source>
        <translation>F3, Maj + F3</translation>
    </message>
    <message>
        <source>F5, Shift + F5</source>
        <translation>F5, Maj + F5</translation>
    </message>
    <message>
        <source>F6, F7</source>
        <translation>F6, F7</translation>
    </message>
    <message>
        <source>F8</source>
        <translation>F8</translation>
    </message>
    <message>
        <source>L, Shift + L</source>
        <translation>L, Maj + L</translation>
    </message>
    <message>
        <source>F9, F10</source>
        <translation>F9, F10</translation>
    </message>
    <message>
        <source>Shift + F9</source>
        <translation>Maj + F9</translation>
    </message>
    <message>
        <source>Shift + F10, F11</source>
        <translation>Maj + F10, F11</translation>
    </message>
    <message>
        <source>Ctrl + .</source>
        <translation>Ctrl + .</translation>
    </message>
    <message>
        <source>Phoenix SpatialExplorer 6 and later</source>
        <translation>Phoenix SpatialExplorer 6 et suivants</translation>
    </message>
    <message>
        <source>Phoenix SpatialExplorer 1 to 5</source>
        <translation>Phoenix SpatialExplorer 1 à 5</translation>
    </message>
    <message>
        <source>This program (iXblue)</source>
        <translation>Ce programme (iXblue)</translation>
    </message>
    <message>
        <source>{program:foreign} (verified)</source>
        <translation>{program} (vérifiée)</translation>
    </message>
    <message>
        <source>{program:foreign} (partly verified)</source>
        <translation>{program} (partiellement vérifiée)</translation>
    </message>
    <message>
        <source>{program:foreign} (not verified)</source>
        <translation>{program} (non vérifiée)</translation>
    </message>
    <message>
        <source>Present {turn} in {program:foreign}, degrees, {meaning}</source>
        <translation>{turn} actuel dans {program}, en degrés, {meaning}</translation>
    </message>
    <message>
        <source>Scanner to body there, with the lever arm ({name:foreign})</source>
        <translation>Du scanneur au navire là-bas, avec le bras de levier ({name})</translation>
    </message>
    <message>
        <source>Advanced: {what:kept}</source>
        <translation>Avancé : {what}</translation>
    </message>
    <message>
        <source>Additional parameters: {what:kept}</source>
        <translation>Paramètres supplémentaires : {what}</translation>
    </message>
    <message>
        <source>More: {what:kept}</source>
        <translation>Plus : {what}</translation>
    </message>
    <message>
        <source>F12</source>
        <translation>F12</translation>
    </message>
</context>
<context>
    <name>about</name>
    <message>
        <source>About LISPAC</source>
        <translation>À propos de LISPAC</translation>
    </message>
    <message>
        <source>Boresight calibration of a LiDAR and an INS/GNSS on a vessel, with honest uncertainties.</source>
        <translation>Étalonnage des angles de visée d&apos;un LiDAR et d&apos;un INS/GNSS sur un navire, avec des incertitudes honnêtes.</translation>
    </message>
    <message>
        <source>Local coordinates are North, West, Up in metres.</source>
        <translation>Les coordonnées locales sont nord, ouest, haut, en mètres.</translation>
    </message>
    <message>
        <source>Qt {qt:kept}, Python {python:kept}. BSD 3-clause licence.</source>
        <translation>Qt {qt}, Python {python}. Licence BSD à trois clauses.</translation>
    </message>
    <message>
        <source>Boresight calibration of a LiDAR and an INS/GNSS.</source>
        <translation>Étalonnage des angles de visée d&apos;un LiDAR et d&apos;un INS/GNSS.</translation>
    </message>
</context>
<context>
    <name>messages</name>
    <message>
        <source>Time since the first line began (s)</source>
        <translation>Temps depuis le début de la première ligne (s)</translation>
    </message>
    <message>
        <source>{name} has no intensities; choose another colouring</source>
        <translation>{name} n&apos;a pas d&apos;intensités ; choisissez une autre coloration</translation>
    </message>
    <message>
        <source>Estimate first; then before and after can be compared</source>
        <translation>Estimez d&apos;abord ; avant et après pourront ensuite être comparés</translation>
    </message>
    <message>
        <source>Counting points</source>
        <translation>Comptage des points</translation>
    </message>
    <message>
        <source>validation, {model}</source>
        <translation>validation, {model}</translation>
    </message>
    <message>
        <source>Compared the lines on {n:n} validation planes</source>
        <translation>Lignes comparées sur {n} plans de validation</translation>
    </message>
    <message>
        <source>Compared the lines on 1 validation plane</source>
        <translation>Lignes comparées sur 1 plan de validation</translation>
    </message>
    <message>
        <source>Validating</source>
        <translation>Validation en cours</translation>
    </message>
    <message>
        <source>Placing the lines with the estimated boresight</source>
        <translation>Placement des lignes avec les angles de visée estimés</translation>
    </message>
    <message>
        <source>Wrote {path:kept} ({n:n} files)</source>
        <translation>{path} écrit ({n} fichiers)</translation>
    </message>
    <message>
        <source>Wrote {path:kept}</source>
        <translation>{path} écrit</translation>
    </message>
    <message>
        <source>Writing {what}</source>
        <translation>Écriture : {what}</translation>
    </message>
    <message>
        <source>the lines</source>
        <translation>les lignes</translation>
    </message>
    <message>
        <source>the targets</source>
        <translation>les cibles</translation>
    </message>
    <message>
        <source>the plane files</source>
        <translation>les fichiers de plans</translation>
    </message>
    <message>
        <source>the trajectory</source>
        <translation>la trajectoire</translation>
    </message>
    <message>
        <source>Opening {name:kept}</source>
        <translation>Ouverture de {name}</translation>
    </message>
    <message>
        <source>Making {name:kept}</source>
        <translation>Création de {name}</translation>
    </message>
    <message>
        <source>addition of {n:n} lines</source>
        <translation>ajout de {n} lignes</translation>
    </message>
    <message>
        <source>addition of {name:kept}</source>
        <translation>ajout de {name}</translation>
    </message>
    <message>
        <source>Added {n:n} lines to {name:kept}; save the project to keep them</source>
        <translation>{n} lignes ajoutées à {name} ; enregistrez le projet pour les garder</translation>
    </message>
    <message>
        <source>Added {what:kept} to {name:kept}; save the project to keep them</source>
        <translation>{what} ajoutée à {name} ; enregistrez le projet pour les garder</translation>
    </message>
    <message>
        <source>Adding {n:n} lines</source>
        <translation>Ajout de {n} lignes</translation>
    </message>
    <message>
        <source>Adding {name:kept}</source>
        <translation>Ajout de {name}</translation>
    </message>
    <message>
        <source>Opening the demo survey</source>
        <translation>Ouverture du levé de démonstration</translation>
    </message>
    <message>
        <source>File &gt; Save as… does that.</source>
        <translation>Utilisez Fichier &gt; Enregistrer sous…</translation>
    </message>
    <message>
        <source>Saved {name:kept}</source>
        <translation>{name} enregistré</translation>
    </message>
    <message>
        <source>Saved as {folder:kept}; {other:kept} stays as it was saved last</source>
        <translation>Enregistré sous {folder} ; {other} reste tel qu&apos;il a été enregistré la dernière fois</translation>
    </message>
    <message>
        <source>Saving as {name:kept}</source>
        <translation>Enregistrement sous {name}</translation>
    </message>
    <message>
        <source>Opened {path:kept}</source>
        <translation>{path} ouvert</translation>
    </message>
    <message>
        <source>Placing the lines</source>
        <translation>Placement des lignes</translation>
    </message>
    <message>
        <source>Searching for {name:kept} on every line</source>
        <translation>Recherche de {name} sur toutes les lignes</translation>
    </message>
    <message>
        <source>Searching for {name:kept} on {line:kept}</source>
        <translation>Recherche de {name} sur {line}</translation>
    </message>
    <message>
        <source>Wait until the running task has ended, then seed again</source>
        <translation>Attendez la fin de la tâche en cours, puis désignez de nouveau</translation>
    </message>
    <message>
        <source>pick of {name:kept}</source>
        <translation>désignation de {name}</translation>
    </message>
    <message>
        <source>{name:kept}: {some:n} of {all:n} lines</source>
        <translation>{name} : {some} lignes sur {all}</translation>
    </message>
    <message>
        <source>{name:kept} rejected</source>
        <translation>{name} rejetée</translation>
    </message>
    <message>
        <source>rename of {name:kept}</source>
        <translation>changement de nom de {name}</translation>
    </message>
    <message>
        <source>removal of {name:kept}</source>
        <translation>suppression de {name}</translation>
    </message>
    <message>
        <source>use of {name:kept}</source>
        <translation>emploi de {name}</translation>
    </message>
    <message>
        <source>leaving out {name:kept}</source>
        <translation>mise à l&apos;écart de {name}</translation>
    </message>
    <message>
        <source>use of {name:kept} on {line:kept}</source>
        <translation>emploi de {name} sur {line}</translation>
    </message>
    <message>
        <source>leaving out {name:kept} on {line:kept}</source>
        <translation>mise à l&apos;écart de {name} sur {line}</translation>
    </message>
    <message>
        <source>use of line {line:kept}</source>
        <translation>emploi de la ligne {line}</translation>
    </message>
    <message>
        <source>leaving out line {line:kept}</source>
        <translation>mise à l&apos;écart de la ligne {line}</translation>
    </message>
    <message>
        <source>change of the mounting</source>
        <translation>modification du montage</translation>
    </message>
    <message>
        <source>Estimating the boresight</source>
        <translation>Estimation des angles de visée</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>estimation</translation>
    </message>
    <message>
        <source>The adjustment was cancelled. Press Estimate for it.</source>
        <translation>La compensation a été annulée. Cliquez sur Estimer pour la faire.</translation>
    </message>
    <message>
        <source>The adjustment failed. Press Estimate to try again.</source>
        <translation>La compensation a échoué. Cliquez sur Estimer pour réessayer.</translation>
    </message>
    <message>
        <source>Estimating again</source>
        <translation>Nouvelle estimation</translation>
    </message>
    <message>
        <source>Looking for a further line</source>
        <translation>Recherche d&apos;une ligne supplémentaire</translation>
    </message>
    <message>
        <source>Cross-checking</source>
        <translation>Vérifications croisées en cours</translation>
    </message>
    <message>
        <source>Estimated on {points:n} points in {time:n} s; RMS {before:n} → {after:n} {unit:kept}</source>
        <translation>Estimé sur {points} points en {time} s ; RMS {before} → {after} {unit}</translation>
    </message>
    <message>
        <source>Estimated again on {points:n} points in {time:n} s; RMS {before:n} → {after:n} {unit:kept}</source>
        <translation>Estimé de nouveau sur {points} points en {time} s ; RMS {before} → {after} {unit}</translation>
    </message>
    <message>
        <source>Estimated again with the points as they were selected before on {points:n} points in {time:n} s; RMS {before:n} → {after:n} {unit:kept}</source>
        <translation>Estimé de nouveau, avec les points choisis auparavant, sur {points} points en {time} s ; RMS {before} → {after} {unit}</translation>
    </message>
    <message>
        <source>Preparing the preview</source>
        <translation>Préparation de l&apos;aperçu</translation>
    </message>
    <message>
        <source>About {a:n} × {b:n} m on {line:kept}</source>
        <translation>Environ {a} × {b} m sur {line}</translation>
    </message>
    <message>
        <source>Judging the sightings</source>
        <translation>Évaluation des observations</translation>
    </message>
    <message>
        <source>Judging {name:kept}</source>
        <translation>Évaluation de {name}</translation>
    </message>
    <message>
        <source>Taking the points of {name:kept}</source>
        <translation>Extraction des points de {name}</translation>
    </message>
    <message>
        <source>Draw around points to add to {what}</source>
        <translation>Entourez les points à ajouter à {what}</translation>
    </message>
    <message>
        <source>Draw around points to take from {what}</source>
        <translation>Entourez les points à retirer de {what}</translation>
    </message>
    <message>
        <source>{target:name} on {line:name}</source>
        <translation>{target} sur {line}</translation>
    </message>
    <message>
        <source>Select a target first; then draw around points of it</source>
        <translation>Sélectionnez d&apos;abord une cible ; puis entourez des points de celle-ci</translation>
    </message>
    <message>
        <source>{name:name} on {line:name}: no points of it there</source>
        <translation>{name} sur {line} : aucun de ses points à cet endroit</translation>
    </message>
    <message>
        <source>{name:name}: no points of it there</source>
        <translation>{name} : aucun de ses points à cet endroit</translation>
    </message>
    <message>
        <source>adding {n:n} points, {what}</source>
        <translation>ajout de {n} points, {what}</translation>
    </message>
    <message>
        <source>removal of {n:n} points, {what}</source>
        <translation>retrait de {n} points, {what}</translation>
    </message>
    <message>
        <source>{n:n} points added to {what}</source>
        <translation>{n} points ajoutés à {what}</translation>
    </message>
    <message>
        <source>{n:n} points taken from {what}</source>
        <translation>{n} points retirés de {what}</translation>
    </message>
    <message>
        <source>Wait until the running task has ended, then drop the files again</source>
        <translation>Attendez la fin de la tâche en cours, puis déposez de nouveau les fichiers</translation>
    </message>
    <message>
        <source>Select a target first: click it in the list of targets or in the table</source>
        <translation>Sélectionnez d&apos;abord une cible : cliquez-la dans la liste des cibles ou dans le tableau</translation>
    </message>
    <message>
        <source>No point under the cursor. Ctrl+click on a target.</source>
        <translation>Aucun point sous le curseur. Faites Ctrl+clic sur une cible.</translation>
    </message>
    <message>
        <source>{title}: cancelled</source>
        <translation>{title} : annulé</translation>
    </message>
    <message>
        <source>{title}: stopping …</source>
        <translation>{title} : arrêt en cours…</translation>
    </message>
    <message>
        <source>{title}: it was done before it could be cancelled</source>
        <translation>{title} : terminé avant d&apos;avoir pu être annulé</translation>
    </message>
    <message>
        <source>Click the first point</source>
        <translation>Cliquez le premier point</translation>
    </message>
    <message>
        <source>Click the second point</source>
        <translation>Cliquez le second point</translation>
    </message>
    <message>
        <source>Click a point on the first side</source>
        <translation>Cliquez un point du premier côté</translation>
    </message>
    <message>
        <source>Click the corner</source>
        <translation>Cliquez le sommet</translation>
    </message>
    <message>
        <source>Click a point on the second side</source>
        <translation>Cliquez un point du second côté</translation>
    </message>
    <message>
        <source>Click to measure again</source>
        <translation>Cliquez pour mesurer de nouveau</translation>
    </message>
    <message>
        <source>Slope distance {n:n} {unit:kept}</source>
        <translation>Distance suivant la pente {n} {unit}</translation>
    </message>
    <message>
        <source>Horizontal {n:n} {unit:kept}</source>
        <translation>Horizontale {n} {unit}</translation>
    </message>
    <message>
        <source>Vertical {n:n} {unit:kept}</source>
        <translation>Verticale {n} {unit}</translation>
    </message>
    <message>
        <source>Azimuth {n:n}°</source>
        <translation>Azimut {n}°</translation>
    </message>
    <message>
        <source>Angle {n:n}°</source>
        <translation>Angle {n}°</translation>
    </message>
    <message>
        <source>Sides {a:n} {unit:kept} and {b:n} {unit2:kept}</source>
        <translation>Côtés {a} {unit} et {b} {unit2}</translation>
    </message>
    <message>
        <source>There is no section to take a picture of: select a target and press S</source>
        <translation>Il n&apos;y a pas de coupe dont prendre l&apos;image : sélectionnez une cible et appuyez sur S</translation>
    </message>
    <message>
        <source>The picture of the view is in the clipboard</source>
        <translation>L&apos;image de la vue 3D est dans le presse-papiers</translation>
    </message>
    <message>
        <source>The picture of the section is in the clipboard</source>
        <translation>L&apos;image de la coupe est dans le presse-papiers</translation>
    </message>
    <message>
        <source>{text}   ·   Esc ends</source>
        <translation>{text}   ·   Échap pour terminer</translation>
    </message>
    <message>
        <source>details for the report</source>
        <translation>détails pour le rapport</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>Écriture du rapport</translation>
    </message>
    <message>
        <source>Distance from the surface (mm)</source>
        <translation>Distance à la surface (mm)</translation>
    </message>
    <message>
        <source>Select a target or validation plane first; then change its role</source>
        <translation>Sélectionnez d&apos;abord une cible ou un plan de validation ; puis changez son rôle</translation>
    </message>
    <message>
        <source>change of role of {name:kept}</source>
        <translation>changement de rôle de {name}</translation>
    </message>
    <message>
        <source>{name:kept} is a validation plane now</source>
        <translation>{name} est maintenant un plan de validation</translation>
    </message>
    <message>
        <source>{name:kept} is a target now</source>
        <translation>{name} est maintenant une cible</translation>
    </message>
    <message>
        <source>Click where the section begins</source>
        <translation>Cliquez où commence la coupe</translation>
    </message>
    <message>
        <source>Click where it ends</source>
        <translation>Cliquez où elle se termine</translation>
    </message>
    <message>
        <source>Between two points</source>
        <translation>Entre deux points</translation>
    </message>
    <message>
        <source>Across {name:kept}</source>
        <translation>En travers de {name}</translation>
    </message>
    <message>
        <source>Cutting the section</source>
        <translation>Calcul de la coupe</translation>
    </message>
    <message>
        <source>Picking 1 seed of {file:kept}</source>
        <translation>Recherche d&apos;un point initial de {file}</translation>
    </message>
    <message>
        <source>Picking {n:n} seeds of {file:kept}</source>
        <translation>Recherche de {n} points initiaux de {file}</translation>
    </message>
    <message>
        <source>seeds of {file:kept}</source>
        <translation>points initiaux de {file}</translation>
    </message>
    <message>
        <source>{some:n} of {all:n} seeds of {file:kept} led to a target</source>
        <translation>{some} points initiaux sur {all} de {file} ont donné une cible</translation>
    </message>
    <message>
        <source>All are searched for as planes on every line, with search radius, threshold and the rest as set in step 2.</source>
        <translation>Tous sont cherchés comme plans sur toutes les lignes, avec le rayon de recherche, le seuil et le reste réglés à l&apos;étape 2.</translation>
    </message>
    <message>
        <source>All are searched for as spheres, validation planes on every line, with search radius, threshold and the rest as set in step 2.</source>
        <translation>Tous sont cherchés comme sphères, les plans de validation comme plans, sur toutes les lignes, avec le rayon de recherche, le seuil et le reste réglés à l&apos;étape 2.</translation>
    </message>
    <message>
        <source>Reading the calibrations</source>
        <translation>Lecture des étalonnages</translation>
    </message>
    <message>
        <source>check against {name:kept}</source>
        <translation>contrôle par {name}</translation>
    </message>
    <message>
        <source>Checking against {name:kept}</source>
        <translation>Contrôle par {name}</translation>
    </message>
    <message>
        <source>Adding up the errors</source>
        <translation>Cumul des erreurs</translation>
    </message>
    <message>
        <source>Studying the distance between points</source>
        <translation>Étude de la distance entre les points</translation>
    </message>
    <message>
        <source>Simulating boards</source>
        <translation>Simulation de panneaux</translation>
    </message>
    <message>
        <source>Proposing targets</source>
        <translation>Recherche de cibles à proposer</translation>
    </message>
    <message>
        <source>Finding {name:kept} again</source>
        <translation>Nouvelle recherche de {name}</translation>
    </message>
    <message>
        <source>Nothing to propose that is not picked already</source>
        <translation>Rien à proposer qui ne soit déjà désigné</translation>
    </message>
    <message>
        <source>Proposal rejected</source>
        <translation>Proposition rejetée</translation>
    </message>
    <message>
        <source>proposal</source>
        <translation>proposition</translation>
    </message>
    <message>
        <source>Accepted {names:kept} of the proposal</source>
        <translation>Acceptés de la proposition : {names}</translation>
    </message>
    <message>
        <source>{left} left</source>
        <translation>encore {left}</translation>
    </message>
    <message>
        <source>{rate:n} %/s, {left} left</source>
        <translation>{rate} %/s, encore {left}</translation>
    </message>
    <message>
        <source>Taking pictures of the view</source>
        <translation>Prise d&apos;images de la vue</translation>
    </message>
    <message>
        <source>The clip box hid {what:kept}; it lies about it now</source>
        <translation>La boîte de découpe cachait {what} ; elle l&apos;entoure maintenant</translation>
    </message>
    <message>
        <source>{sentence}: second target required</source>
        <translation>{sentence} : seconde cible requise</translation>
    </message>
    <message>
        <source>a second target is missing</source>
        <translation>il manque une seconde cible</translation>
    </message>
    <message>
        <source>exported: {reported:kept}</source>
        <translation>exporté : {reported}</translation>
    </message>
    <message>
        <source>The report tells of the project as it stands; export it again in another form.</source>
        <translation>Le rapport décrit le projet tel qu&apos;il est ; l&apos;exporter de nouveau sous une autre forme.</translation>
    </message>
    <message>
        <source>Colours of measured values</source>
        <translation>Couleurs des valeurs mesurées</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Couleurs</translation>
    </message>
    <message>
        <source>Viridis: even, safe for the colour-blind</source>
        <translation>Viridis : régulière, lisible par les daltoniens</translation>
    </message>
    <message>
        <source>Cividis: blue to yellow, safe for the colour-blind</source>
        <translation>Cividis : du bleu au jaune, lisible par les daltoniens</translation>
    </message>
    <message>
        <source>Greys</source>
        <translation>Gris</translation>
    </message>
    <message>
        <source>Turbo: a rainbow, not safe for the colour-blind</source>
        <translation>Turbo : arc-en-ciel, trompeuse pour les daltoniens</translation>
    </message>
    <message>
        <source>Colours of the window; those of the lines are told apart on either ground, by the colour-blind too</source>
        <translation>Couleurs de la fenêtre ; celles des lignes se distinguent sur les deux fonds, aussi par les daltoniens</translation>
    </message>
    <message>
        <source>Colours of the points by height, intensity, range or time; residuals have their own</source>
        <translation>Couleurs des points par hauteur, intensité, distance ou temps ; les résidus ont les leurs</translation>
    </message>
    <message>
        <source>Copying the section</source>
        <translation>Copie de la coupe</translation>
    </message>
    <message>
        <source>Writing the picture</source>
        <translation>Écriture de l’image</translation>
    </message>
</context>
<context>
    <name>steps</name>
    <message>
        <source>Data</source>
        <translation>Données</translation>
    </message>
    <message>
        <source>Adjust</source>
        <translation>Compensation</translation>
    </message>
    <message>
        <source>no project</source>
        <translation>pas de projet</translation>
    </message>
    <message>
        <source>Open or make a project first.</source>
        <translation>Ouvrez ou créez d&apos;abord un projet.</translation>
    </message>
    <message>
        <source>no project open</source>
        <translation>aucun projet ouvert</translation>
    </message>
    <message>
        <source>Make a project from a trajectory and raw lines, or open the built-in demo survey.</source>
        <translation>Créez un projet à partir d&apos;une trajectoire et de lignes brutes, ou ouvrez le levé de démonstration.</translation>
    </message>
    <message>
        <source>{lines}, being read</source>
        <translation>{lines}, lecture en cours</translation>
    </message>
    <message>
        <source>The files are being read.</source>
        <translation>Les fichiers sont en cours de lecture.</translation>
    </message>
    <message>
        <source>Check the lever arm and its signs, then go on to the targets.</source>
        <translation>Vérifiez le bras de levier et ses signes, puis passez aux cibles.</translation>
    </message>
    <message>
        <source>{n:n} M points</source>
        <translation>{n} M points</translation>
    </message>
    <message>
        <source>{n:n} points</source>
        <translation>{n} points</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 point</translation>
    </message>
    <message>
        <source>1 plane</source>
        <translation>1 plan</translation>
    </message>
    <message>
        <source>{n:n} planes</source>
        <translation>{n} plans</translation>
    </message>
    <message>
        <source>1 validation plane</source>
        <translation>1 plan de validation</translation>
    </message>
    <message>
        <source>{n:n} validation planes</source>
        <translation>{n} plans de validation</translation>
    </message>
    <message>
        <source>data first</source>
        <translation>données d&apos;abord</translation>
    </message>
    <message>
        <source>Wait until the data are read.</source>
        <translation>Attendez que les données soient lues.</translation>
    </message>
    <message>
        <source>no targets yet</source>
        <translation>pas encore de cible</translation>
    </message>
    <message>
        <source>Hold Ctrl and click a target in the view.</source>
        <translation>Maintenez Ctrl et cliquez sur une cible dans la vue 3D.</translation>
    </message>
    <message>
        <source>{name:name} is seen on fewer than two lines: seed it on another, or leave it out.</source>
        <translation>{name} est vue sur moins de deux lignes : désignez-la sur une autre, ou écartez-la.</translation>
    </message>
    <message>
        <source>Nothing checks a single target: pick another that faces elsewhere.</source>
        <translation>Rien ne contrôle une cible unique : désignez-en une autre, orientée autrement.</translation>
    </message>
    <message>
        <source>Enough to adjust. Pick validation planes too, to show how well the lines agree.</source>
        <translation>Assez pour compenser. Désignez aussi des plans de validation, pour montrer combien les lignes concordent.</translation>
    </message>
    <message>
        <source>Enough to adjust and to validate.</source>
        <translation>Assez pour compenser et pour valider.</translation>
    </message>
    <message>
        <source>Do not use the angles before you have read the warnings on the right.</source>
        <translation>N&apos;utilisez pas les angles avant d&apos;avoir lu les avertissements à droite.</translation>
    </message>
    <message>
        <source>The result stands on the right.</source>
        <translation>Le résultat est à droite.</translation>
    </message>
    <message>
        <source>The residuals do not match the stated sigmas: see the test on the right.</source>
        <translation>Les résidus ne correspondent pas aux écarts-types déclarés : voyez le test à droite.</translation>
    </message>
    <message>
        <source>done: variance factor {n:n}</source>
        <translation>fait : facteur de variance {n}</translation>
    </message>
    <message>
        <source>done, in doubt: variance factor {n:n}</source>
        <translation>fait, douteux : facteur de variance {n}</translation>
    </message>
    <message>
        <source>not estimated</source>
        <translation>non estimé</translation>
    </message>
    <message>
        <source>estimating again</source>
        <translation>nouvelle estimation</translation>
    </message>
    <message>
        <source>The result follows at once.</source>
        <translation>Le résultat suit aussitôt.</translation>
    </message>
    <message>
        <source>pick targets first</source>
        <translation>désigner d&apos;abord des cibles</translation>
    </message>
    <message>
        <source>Pick at least two targets first.</source>
        <translation>Désignez d&apos;abord au moins deux cibles.</translation>
    </message>
    <message>
        <source>ready to estimate</source>
        <translation>prêt à estimer</translation>
    </message>
    <message>
        <source>Press Estimate.</source>
        <translation>Cliquez sur Estimer.</translation>
    </message>
    <message>
        <source>{some:n} of {all:n} plane closer than before</source>
        <translation>{some} plan sur {all} plus proche qu&apos;avant</translation>
    </message>
    <message>
        <source>{some:n} of {all:n} planes closer than before</source>
        <translation>{some} plans sur {all} plus proches qu&apos;avant</translation>
    </message>
    <message>
        <source>{some:n} of {all:n} plane closer than before, {n:n} not compared</source>
        <translation>{some} plan sur {all} plus proche qu&apos;avant, {n} non comparés</translation>
    </message>
    <message>
        <source>{some:n} of {all:n} planes closer than before, {n:n} not compared</source>
        <translation>{some} plans sur {all} plus proches qu&apos;avant, {n} non comparés</translation>
    </message>
    <message>
        <source>The histograms stand below.</source>
        <translation>Les histogrammes sont en bas.</translation>
    </message>
    <message>
        <source>no validation planes</source>
        <translation>aucun plan de validation</translation>
    </message>
    <message>
        <source>Pick planes that take no part in the adjustment: choose Validation plane in step 2, then Ctrl+click.</source>
        <translation>Désignez des plans qui ne servent pas à la compensation : choisissez Plan de validation à l&apos;étape 2, puis Ctrl+clic.</translation>
    </message>
    <message>
        <source>{planes}, estimate first</source>
        <translation>{planes}, estimer d&apos;abord</translation>
    </message>
    <message>
        <source>Estimate the boresight first; then the lines are compared before and after.</source>
        <translation>Estimez d&apos;abord les angles de visée ; les lignes sont ensuite comparées avant et après.</translation>
    </message>
    <message>
        <source>{planes} to compare</source>
        <translation>{planes} à comparer</translation>
    </message>
    <message>
        <source>Press Validate to compare the lines on each plane.</source>
        <translation>Cliquez sur Valider pour comparer les lignes sur chaque plan.</translation>
    </message>
    <message>
        <source>estimate first</source>
        <translation>estimer d&apos;abord</translation>
    </message>
    <message>
        <source>The report needs an estimated boresight.</source>
        <translation>Le rapport demande des angles de visée estimés.</translation>
    </message>
    <message>
        <source>It will have no validation: run step 4 for it.</source>
        <translation>Il sera sans validation : exécutez l&apos;étape 4 pour l&apos;avoir.</translation>
    </message>
    <message>
        <source>ready to export</source>
        <translation>prêt à exporter</translation>
    </message>
    <message>
        <source>ready, without validation</source>
        <translation>prêt, sans validation</translation>
    </message>
    <message>
        <source>Export the report as PDF or HTML, or its numbers as JSON.</source>
        <translation>Exportez le rapport en PDF ou HTML, ou ses chiffres en JSON.</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>pas encore</translation>
    </message>
    <message>
        <source>to do</source>
        <translation>à faire</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fait</translation>
    </message>
    <message>
        <source>look at this</source>
        <translation>à regarder</translation>
    </message>
    <message>
        <source>Nothing loaded yet</source>
        <translation>Rien de chargé pour l&apos;instant</translation>
    </message>
    <message>
        <source>Open or make a project to see its lines here</source>
        <translation>Ouvrez ou créez un projet pour voir ses lignes ici</translation>
    </message>
    <message>
        <source>Drag: rotate   ·   Shift+drag: move   ·   Wheel: zoom   ·   Ctrl+click: set a seed</source>
        <translation>Glisser : tourner · Maj : déplacer · Molette : zoom · Ctrl+clic : point initial</translation>
    </message>
    <message>
        <source>Histograms</source>
        <translation>Histogrammes</translation>
    </message>
    <message>
        <source>Diagnostics</source>
        <translation>Diagnostics</translation>
    </message>
</context>
<context>
    <name>counts</name>
    <message>
        <source>{n:n} lines, {k:n} M points</source>
        <translation>{n} lignes, {k} M points</translation>
    </message>
    <message>
        <source>1 line, {k:n} M points</source>
        <translation>1 ligne, {k} M points</translation>
    </message>
    <message>
        <source>{n:n} lines, {k:n} points</source>
        <translation>{n} lignes, {k} points</translation>
    </message>
    <message>
        <source>1 line, {k:n} points</source>
        <translation>1 ligne, {k} points</translation>
    </message>
    <message>
        <source>{n:n} targets in {lines}</source>
        <translation>{n} cibles sur {lines}</translation>
    </message>
    <message>
        <source>1 target in {lines}</source>
        <translation>1 cible sur {lines}</translation>
    </message>
    <message>
        <source>{n:n} targets in {k:n} lines, {planes}</source>
        <translation>{n} cibles sur {k} lignes, {planes}</translation>
    </message>
    <message>
        <source>1 target in {k:n} lines, {planes}</source>
        <translation>1 cible sur {k} lignes, {planes}</translation>
    </message>
    <message>
        <source>{n:n} targets in 1 line, {planes}</source>
        <translation>{n} cibles sur 1 ligne, {planes}</translation>
    </message>
    <message>
        <source>1 target in 1 line, {planes}</source>
        <translation>1 cible sur 1 ligne, {planes}</translation>
    </message>
    <message>
        <source>{n:n} file</source>
        <translation>{n} fichier</translation>
    </message>
    <message>
        <source>{n:n} files</source>
        <translation>{n} fichiers</translation>
    </message>
</context>
<context>
    <name>dialogs</name>
    <message>
        <source>Browse…</source>
        <translation>Parcourir…</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Heights</source>
        <translation>Hauteurs</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Chercher</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Désigner</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Seuil</translation>
    </message>
    <message>
        <source>Search radius</source>
        <translation>Rayon de recherche</translation>
    </message>
    <message>
        <source>LISPAC</source>
        <translation>LISPAC</translation>
    </message>
    <message>
        <source>PNG</source>
        <translation>PNG</translation>
    </message>
</context>
<context>
    <name>budget dialog</name>
    <message>
        <source>Horiz. {far:n} m (cm)</source>
        <translation>Horiz. {far} m (cm)</translation>
    </message>
    <message>
        <source>Vert. {far:n} m (cm)</source>
        <translation>Vert. {far} m (cm)</translation>
    </message>
    <message>
        <source>Across {far:n} m (cm)</source>
        <translation>Transv. {far} m (cm)</translation>
    </message>
    <message>
        <source>In the plane of north and west, 1 sigma, {far:n} m from the scanner</source>
        <translation>Dans le plan nord-ouest, 1 sigma, à {far} m du scanneur</translation>
    </message>
    <message>
        <source>Upwards, 1 sigma, {far:n} m from the scanner</source>
        <translation>Vers le haut, 1 sigma, à {far} m du scanneur</translation>
    </message>
    <message>
        <source>Across the beam, 1 sigma, {far:n} m from the scanner</source>
        <translation>En travers du faisceau, 1 sigma, à {far} m du scanneur</translation>
    </message>
    <message>
        <source>What makes a point uncertain</source>
        <translation>Ce qui rend un point incertain</translation>
    </message>
    <message>
        <source>Error budget</source>
        <translation>Bilan d&apos;erreurs</translation>
    </message>
    <message>
        <source>What each source of error does to a point, as a standard deviation in centimetres, by the derivatives of the adjustment.</source>
        <translation>Ce que chaque source d&apos;erreur fait à un point, en écart-type et en centimètres, d&apos;après les dérivées de la compensation.</translation>
    </message>
    <message>
        <source>Beam {beam}</source>
        <translation>Faisceau {beam}</translation>
    </message>
    <message>
        <source>Where the beam points</source>
        <translation>Où pointe le faisceau</translation>
    </message>
    <message>
        <source>How well it is known is not stated</source>
        <translation>Sa précision n&apos;est pas déclarée</translation>
    </message>
</context>
<context>
    <name>check dialog</name>
    <message>
        <source>As the file says, else the local frame</source>
        <translation>Comme l&apos;indique le fichier, sinon le repère local</translation>
    </message>
    <message>
        <source>Each line that saw the reference, and all of them</source>
        <translation>Chaque ligne qui a vu la référence, et l&apos;ensemble</translation>
    </message>
    <message>
        <source>Where line and reference were compared, the same before and after</source>
        <translation>Où ligne et référence ont été comparées, les mêmes avant et après</translation>
    </message>
    <message>
        <source>Mean before (mm)</source>
        <translation>Moyenne avant (mm)</translation>
    </message>
    <message>
        <source>Mean after (mm)</source>
        <translation>Moyenne après (mm)</translation>
    </message>
    <message>
        <source>± 95 % before (mm)</source>
        <translation>± 95 % avant (mm)</translation>
    </message>
    <message>
        <source>± 95 % after (mm)</source>
        <translation>± 95 % après (mm)</translation>
    </message>
    <message>
        <source>RMS before (mm)</source>
        <translation>RMS avant (mm)</translation>
    </message>
    <message>
        <source>RMS after (mm)</source>
        <translation>RMS après (mm)</translation>
    </message>
    <message>
        <source>Mean distance from the reference, positive towards the vessel, before the calibration, millimetres</source>
        <translation>Distance moyenne à la référence, positive vers le navire, avant l&apos;étalonnage, en millimètres</translation>
    </message>
    <message>
        <source>Mean distance from the reference, positive towards the vessel, after the calibration, millimetres</source>
        <translation>Distance moyenne à la référence, positive vers le navire, après l&apos;étalonnage, en millimètres</translation>
    </message>
    <message>
        <source>What the mean may be off by, with POS, reference and boresight, before the calibration, millimetres</source>
        <translation>Erreur possible de la moyenne, avec POS, référence et angles de visée, avant l&apos;étalonnage, en millimètres</translation>
    </message>
    <message>
        <source>What the mean may be off by, with POS, reference and boresight, after the calibration, millimetres</source>
        <translation>Erreur possible de la moyenne, avec POS, référence et angles de visée, après l&apos;étalonnage, en millimètres</translation>
    </message>
    <message>
        <source>Root mean square distance, before the calibration, millimetres</source>
        <translation>Distance quadratique moyenne, avant l&apos;étalonnage, en millimètres</translation>
    </message>
    <message>
        <source>Root mean square distance, after the calibration, millimetres</source>
        <translation>Distance quadratique moyenne, après l&apos;étalonnage, en millimètres</translation>
    </message>
    <message>
        <source>Whether the mean after the calibration is within its 95 %</source>
        <translation>Si la moyenne après l&apos;étalonnage est dans ses 95 %</translation>
    </message>
    <message>
        <source>Check against a reference</source>
        <translation>Contrôler par une référence</translation>
    </message>
    <message>
        <source>The lines are compared with a static scan of the site, or with surveyed points: a list with name, three coordinates, and perhaps the sigma and the plane that each point lies on with others.</source>
        <translation>Les lignes sont comparées à un balayage statique du site, ou à des points levés : une liste avec nom, trois coordonnées, et éventuellement l&apos;écart-type et le plan que chaque point partage avec d&apos;autres.</translation>
    </message>
    <message>
        <source>LAS, LAZ, E57, PTS or text</source>
        <translation>LAS, LAZ, E57, PTS ou texte</translation>
    </message>
    <message>
        <source>Choose the reference</source>
        <translation>Choisir la référence</translation>
    </message>
    <message>
        <source>1 sigma of the reference: of a scan what all its points share (registration and control), of a list that of each point it states none for</source>
        <translation>1 sigma de la référence : pour un balayage, ce que tous ses points partagent (recalage et canevas) ; pour une liste, celui de chaque point qui n&apos;en indique pas</translation>
    </message>
    <message>
        <source>How far from the reference a line is looked for: more than the prior boresight puts it off</source>
        <translation>Jusqu&apos;où une ligne est cherchée autour de la référence : plus que l&apos;écart dû aux angles de visée a priori</translation>
    </message>
    <message>
        <source>Reference ± 1 sigma</source>
        <translation>Référence ± 1 sigma</translation>
    </message>
    <message>
        <source>Looked for within</source>
        <translation>Cherchée à moins de</translation>
    </message>
    <message>
        <source>Scans and lists of points (*.las *.laz *.e57 *.txt *.csv *.asc *.xyz *.pts);;All files (*)</source>
        <translation>Balayages et listes de points (*.las *.laz *.e57 *.txt *.csv *.asc *.xyz *.pts);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Lines against the reference</source>
        <translation>Lignes par rapport à la référence</translation>
    </message>
    <message>
        <source>Check against {file:kept}</source>
        <translation>Contrôle par {file}</translation>
    </message>
    <message>
        <source>Distances of the lines from the reference along its normal, positive towards the vessel. The report has them too.</source>
        <translation>Distances des lignes à la référence le long de sa normale, positives vers le navire. Le rapport les donne aussi.</translation>
    </message>
    <message>
        <source>Not compared: {reason}</source>
        <translation>Non comparée : {reason}</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>diffère</translation>
    </message>
</context>
<context>
    <name>error dialog</name>
    <message>
        <source>There is not enough memory for this; close other programs or use fewer lines.</source>
        <translation>Il n&apos;y a pas assez de mémoire pour cela ; fermez d&apos;autres programmes ou prenez moins de lignes.</translation>
    </message>
    <message>
        <source>Something went wrong that the program did not foresee. Your project is as it was before this step; save it, and send the details to the program&apos;s maintainers.</source>
        <translation>Il s&apos;est produit une erreur que le programme n&apos;avait pas prévue. Votre projet est tel qu&apos;avant cette étape ; enregistrez-le et envoyez les détails aux responsables du programme.</translation>
    </message>
    <message>
        <source>Copy details</source>
        <translation>Copier les détails</translation>
    </message>
    <message>
        <source>A file</source>
        <translation>Un fichier</translation>
    </message>
</context>
<context>
    <name>export dialog</name>
    <message>
        <source>Georeferenced lines, all attributes kept</source>
        <translation>Lignes géoréférencées, avec tous leurs attributs</translation>
    </message>
    <message>
        <source>Points of targets and validation planes</source>
        <translation>Points des cibles et des plans de validation</translation>
    </message>
    <message>
        <source>Plane files of the targets (25 columns)</source>
        <translation>Fichiers de plans des cibles (25 colonnes)</translation>
    </message>
    <message>
        <source>LAZ (compressed)</source>
        <translation>LAZ (compressé)</translation>
    </message>
    <message>
        <source>CSV</source>
        <translation>CSV</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>SBET (.out)</source>
        <translation>SBET (.out)</translation>
    </message>
    <message>
        <source>Text (.txt)</source>
        <translation>Texte (.txt)</translation>
    </message>
    <message>
        <source>What to write</source>
        <translation>Ce qu&apos;il faut écrire</translation>
    </message>
    <message>
        <source>Boresight the points are placed with</source>
        <translation>Angles de visée avec lesquels placer les points</translation>
    </message>
    <message>
        <source>EPSG code of a vertical system, path of a geoid grid (.gtx, .tif), or ellipsoid</source>
        <translation>Code EPSG d&apos;un système vertical, chemin d&apos;une grille de géoïde (.gtx, .tif), ou « ellipsoid »</translation>
    </message>
    <message>
        <source>As the coordinate system says, else above the ellipsoid</source>
        <translation>Comme le dit le système de coordonnées, sinon au-dessus de l&apos;ellipsoïde</translation>
    </message>
    <message>
        <source>As the coordinate system, nothing is shifted</source>
        <translation>Comme le système de coordonnées, rien n&apos;est décalé</translation>
    </message>
    <message>
        <source>Geographic system of the trajectory: EPSG:7912 for ITRF2014, say</source>
        <translation>Système géographique de la trajectoire : EPSG:7912 pour ITRF2014, par exemple</translation>
    </message>
    <message>
        <source>Where datums drift apart: 2024.5, say</source>
        <translation>Là où les référentiels dérivent : 2024,5, par exemple</translation>
    </message>
    <message>
        <source>Date of the survey as a decimal year (yr)</source>
        <translation>Date du levé en année décimale (a)</translation>
    </message>
    <message>
        <source>Trajectory datum</source>
        <translation>Référentiel de la trajectoire</translation>
    </message>
    <message>
        <source>Epoch (yr)</source>
        <translation>Époque (a)</translation>
    </message>
    <message>
        <source>File format</source>
        <translation>Format de fichier</translation>
    </message>
    <message>
        <source>Nothing is estimated yet</source>
        <translation>Rien n&apos;est encore estimé</translation>
    </message>
    <message>
        <source>Metres North, West and Up from the project&apos;s origin.</source>
        <translation>Mètres vers le nord, l&apos;ouest et le haut depuis l&apos;origine du projet.</translation>
    </message>
    <message>
        <source>Folder to export to</source>
        <translation>Dossier où exporter</translation>
    </message>
    <message>
        <source>{text:kept}: not a date as a decimal year; 2024.5 for example.</source>
        <translation>{text} : ce n&apos;est pas une date en année décimale ; 2024,5 par exemple.</translation>
    </message>
</context>
<context>
    <name>find again dialog</name>
    <message>
        <source>Find {name:kept} again</source>
        <translation>Chercher de nouveau {name}</translation>
    </message>
    <message>
        <source>{name:kept} is searched for at its seed on every line with these settings. What is found is offered in place of the present one.</source>
        <translation>{name} est cherchée à son point initial sur toutes les lignes avec ces réglages. Ce qui est trouvé est proposé à la place de l&apos;actuelle.</translation>
    </message>
    <message>
        <source>Farthest a point may lie from its plane or sphere: less keeps rough edges out, more takes in a rough or smeared surface</source>
        <translation>Distance maximale d&apos;un point à son plan ou à sa sphère : moins écarte les bords rugueux, plus admet une surface rugueuse ou étalée</translation>
    </message>
    <message>
        <source>Only points this near to the seed can belong to the target</source>
        <translation>Seuls des points à cette distance du point initial au plus peuvent appartenir à la cible</translation>
    </message>
</context>
<context>
    <name>history dialog</name>
    <message>
        <source>First day of the survey</source>
        <translation>Premier jour du levé</translation>
    </message>
    <message>
        <source>Its project</source>
        <translation>Son projet</translation>
    </message>
    <message>
        <source>Day</source>
        <translation>Jour</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Étalonnage</translation>
    </message>
    <message>
        <source>Roll (deg)</source>
        <translation>Roulis (°)</translation>
    </message>
    <message>
        <source>Pitch (deg)</source>
        <translation>Tangage (°)</translation>
    </message>
    <message>
        <source>Yaw (deg)</source>
        <translation>Lacet (°)</translation>
    </message>
    <message>
        <source>Roll ± (deg)</source>
        <translation>Roulis ± (°)</translation>
    </message>
    <message>
        <source>Pitch ± (deg)</source>
        <translation>Tangage ± (°)</translation>
    </message>
    <message>
        <source>Yaw ± (deg)</source>
        <translation>Lacet ± (°)</translation>
    </message>
    <message>
        <source>Estimated value of roll, degrees</source>
        <translation>Valeur estimée du roulis, en degrés</translation>
    </message>
    <message>
        <source>Estimated value of pitch, degrees</source>
        <translation>Valeur estimée du tangage, en degrés</translation>
    </message>
    <message>
        <source>Estimated value of yaw, degrees</source>
        <translation>Valeur estimée du lacet, en degrés</translation>
    </message>
    <message>
        <source>1 sigma of roll, degrees</source>
        <translation>1 sigma du roulis, en degrés</translation>
    </message>
    <message>
        <source>1 sigma of pitch, degrees</source>
        <translation>1 sigma du tangage, en degrés</translation>
    </message>
    <message>
        <source>1 sigma of yaw, degrees</source>
        <translation>1 sigma du lacet, en degrés</translation>
    </message>
    <message>
        <source>Δ roll (sigmas)</source>
        <translation>Δ roulis (sigmas)</translation>
    </message>
    <message>
        <source>Δ pitch (sigmas)</source>
        <translation>Δ tangage (sigmas)</translation>
    </message>
    <message>
        <source>Δ yaw (sigmas)</source>
        <translation>Δ lacet (sigmas)</translation>
    </message>
    <message>
        <source>{angle} less the mean of the calibrations before, over the sigma of that difference</source>
        <translation>{angle} moins la moyenne des étalonnages antérieurs, rapporté à l&apos;écart-type de cette différence</translation>
    </message>
    <message>
        <source>Moves at {n:n} m (cm)</source>
        <translation>Déplacement à {n} m (cm)</translation>
    </message>
    <message>
        <source>How far a point is from where the mean of the calibrations before puts it, at most</source>
        <translation>Distance maximale d&apos;un point à l&apos;endroit où le met la moyenne des étalonnages antérieurs</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>Beyond three sigmas, the angles taken together, the mounting has moved</source>
        <translation>Au-delà de trois sigmas, les angles pris ensemble, le montage a bougé</translation>
    </message>
    <message>
        <source>Calibrations over the years</source>
        <translation>Étalonnages au fil des ans</translation>
    </message>
    <message>
        <source>Each calibration is held against the mean of those before it. A system is a vessel with its scanner and INS/GNSS, as named in the details for the report.</source>
        <translation>Chaque étalonnage est comparé à la moyenne de ceux qui le précèdent. Un système est un navire avec son scanneur et son INS/GNSS, tels que nommés dans les détails pour le rapport.</translation>
    </message>
    <message>
        <source>Whose calibrations are shown</source>
        <translation>De quel système sont montrés les étalonnages</translation>
    </message>
    <message>
        <source>Control chart of {system:kept}</source>
        <translation>Carte de contrôle de {system}</translation>
    </message>
    <message>
        <source>has moved</source>
        <translation>a bougé</translation>
    </message>
    <message>
        <source>first</source>
        <translation>premier</translation>
    </message>
</context>
<context>
    <name>identity dialog</name>
    <message>
        <source>Details for the report</source>
        <translation>Détails pour le rapport</translation>
    </message>
    <message>
        <source>Details for the report…</source>
        <translation>Détails pour le rapport…</translation>
    </message>
    <message>
        <source>What is left blank is printed as a line to be filled in by hand.</source>
        <translation>Ce qui reste vide est imprimé comme une ligne à remplir à la main.</translation>
    </message>
    <message>
        <source>From the lines</source>
        <translation>D&apos;après les lignes</translation>
    </message>
    <message>
        <source>The days (UTC) that the times of the lines tell</source>
        <translation>Les jours (UTC) que donnent les temps des lignes</translation>
    </message>
</context>
<context>
    <name>import</name>
    <message>
        <source>Add lines to {name:kept}</source>
        <translation>Ajouter des lignes à {name}</translation>
    </message>
    <message>
        <source>Add to project</source>
        <translation>Ajouter au projet</translation>
    </message>
    <message>
        <source>Add the scan files of the lines: drop them here, or press Add files.</source>
        <translation>Ajoutez les fichiers de balayage des lignes : déposez-les ici, ou cliquez sur Ajouter des fichiers.</translation>
    </message>
    <message>
        <source>Lines on the map are taken back to the scanner with the project&apos;s lever arm and prior boresight: they have to be those the lines were made with.</source>
        <translation>Les lignes sur la carte sont ramenées au scanneur avec le bras de levier et les angles de visée a priori du projet : ils doivent être ceux avec lesquels les lignes ont été faites.</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>Tous les fichiers</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>Nouveau projet</translation>
    </message>
    <message>
        <source>Selected file</source>
        <translation>Fichier sélectionné</translation>
    </message>
    <message>
        <source>Trajectory quality</source>
        <translation>Qualité de la trajectoire</translation>
    </message>
    <message>
        <source>Mounting and accuracies</source>
        <translation>Montage et précisions</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Chronologie</translation>
    </message>
    <message>
        <source>Timeline ({n:n} to look at)</source>
        <translation>Chronologie ({n} à regarder)</translation>
    </message>
    <message>
        <source>Add files…</source>
        <translation>Ajouter des fichiers…</translation>
    </message>
    <message>
        <source>Add folder…</source>
        <translation>Ajouter un dossier…</translation>
    </message>
    <message>
        <source>Add the files that lie directly in a folder</source>
        <translation>Ajouter les fichiers qui se trouvent directement dans un dossier</translation>
    </message>
    <message>
        <source>Take the selected file off the list (Delete)</source>
        <translation>Retirer le fichier sélectionné de la liste (Suppr)</translation>
    </message>
    <message>
        <source>Files looked into</source>
        <translation>Fichiers examinés</translation>
    </message>
    <message>
        <source>Look into no more files</source>
        <translation>Ne plus examiner de fichiers</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>Réexaminer</translation>
    </message>
    <message>
        <source>Look into the files that were passed over</source>
        <translation>Examiner les fichiers laissés de côté</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Project folder</source>
        <translation>Dossier du projet</translation>
    </message>
    <message>
        <source>Where the project is kept; the survey&apos;s files stay where they are</source>
        <translation>Où le projet est gardé ; les fichiers du levé restent où ils sont</translation>
    </message>
    <message>
        <source>Create project</source>
        <translation>Créer le projet</translation>
    </message>
    <message>
        <source>Survey files</source>
        <translation>Fichiers de levé</translation>
    </message>
    <message>
        <source>Folder with survey files</source>
        <translation>Dossier contenant les fichiers de levé</translation>
    </message>
    <message>
        <source>SBET, POSPac or Exail (iXblue) text, or any text with columns</source>
        <translation>SBET, texte POSPac ou Exail (iXblue), ou tout texte en colonnes</translation>
    </message>
    <message>
        <source>Its accuracies, if there are any</source>
        <translation>Ses précisions, s&apos;il y en a</translation>
    </message>
    <message>
        <source>smrmsg, or a text export of them</source>
        <translation>smrmsg, ou un export texte de celles-ci</translation>
    </message>
    <message>
        <source>A scan file for each line</source>
        <translation>Un fichier de balayage par ligne</translation>
    </message>
    <message>
        <source>LAS, LAZ, E57, PLY, PCD, text or CIDCO; in the scanner&apos;s frame or on the map</source>
        <translation>LAS, LAZ, E57, PLY, PCD, texte ou CIDCO ; dans le repère du scanneur ou sur la carte</translation>
    </message>
    <message>
        <source>Drop the survey&apos;s files or their folder here</source>
        <translation>Déposez ici les fichiers du levé ou leur dossier</translation>
    </message>
    <message>
        <source>Nothing is copied or changed: each file is looked into, and you see what it is before the project is made.</source>
        <translation>Rien n&apos;est copié ni modifié : chaque fichier est examiné, et vous voyez ce qu&apos;il est avant que le projet ne soit créé.</translation>
    </message>
    <message>
        <source>Select a file above to see what is in it.</source>
        <translation>Sélectionnez un fichier ci-dessus pour voir ce qu&apos;il contient.</translation>
    </message>
    <message>
        <source>First rows</source>
        <translation>Premières rangées</translation>
    </message>
    <message>
        <source>How it is read</source>
        <translation>Comment il est lu</translation>
    </message>
    <message>
        <source>What is in it</source>
        <translation>Ce qu&apos;il contient</translation>
    </message>
    <message>
        <source>How the file is read, and what is in it</source>
        <translation>Comment le fichier est lu, et ce qu&apos;il contient</translation>
    </message>
    <message>
        <source>No problems found.</source>
        <translation>Aucun problème constaté.</translation>
    </message>
    <message>
        <source>First rows – choose over each column what it is</source>
        <translation>Premières rangées – choisissez au-dessus de chaque colonne ce qu&apos;elle est</translation>
    </message>
    <message>
        <source>Time span (s)</source>
        <translation>Durée couverte (s)</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Repère</translation>
    </message>
    <message>
        <source>Name of the file; its folder is in the tip of each row</source>
        <translation>Nom du fichier ; son dossier est dans l&apos;infobulle de chaque rangée</translation>
    </message>
    <message>
        <source>What the file is for the project</source>
        <translation>Ce que le fichier est pour le projet</translation>
    </message>
    <message>
        <source>How the file is read; the surest comes first</source>
        <translation>Comment le fichier est lu ; le plus sûr en premier</translation>
    </message>
    <message>
        <source>Points of a line, states of a trajectory</source>
        <translation>Points d&apos;une ligne, états d&apos;une trajectoire</translation>
    </message>
    <message>
        <source>First and last time, seconds, in the file&apos;s own time base</source>
        <translation>Premier et dernier temps, en secondes, dans la base de temps du fichier</translation>
    </message>
    <message>
        <source>What the coordinates refer to</source>
        <translation>À quoi se rapportent les coordonnées</translation>
    </message>
    <message>
        <source>Whether there is something to look at; select the row to read it</source>
        <translation>S&apos;il y a quelque chose à regarder ; sélectionnez la rangée pour le lire</translation>
    </message>
    <message>
        <source>Files to be imported</source>
        <translation>Fichiers à importer</translation>
    </message>
    <message>
        <source>Role of {file:kept}</source>
        <translation>Rôle de {file}</translation>
    </message>
    <message>
        <source>Format of {file:kept}</source>
        <translation>Format de {file}</translation>
    </message>
    <message>
        <source>Position and attitude: from {file:kept}.</source>
        <translation>Position et attitude : de {file}.</translation>
    </message>
    <message>
        <source>Position and attitude: no accuracy file, so these hold at all times.</source>
        <translation>Position et attitude : pas de fichier de précision, ces valeurs valent donc à tout moment.</translation>
    </message>
    <message>
        <source>Mounting</source>
        <translation>Montage</translation>
    </message>
    <message>
        <source>Uncertainties</source>
        <translation>Incertitudes</translation>
    </message>
    <message>
        <source>Prior boresight</source>
        <translation>Angles de visée a priori</translation>
    </message>
    <message>
        <source>Lines on the map are taken back to the scanner: state the lever arm and the boresight that they were made with.</source>
        <translation>Les lignes sur la carte sont ramenées au scanneur : indiquez le bras de levier et les angles de visée avec lesquels elles ont été faites.</translation>
    </message>
    <message>
        <source>Set the origin of the local frame</source>
        <translation>Fixer l&apos;origine du repère local</translation>
    </message>
    <message>
        <source>Without it, the mean position of the trajectory is used</source>
        <translation>Sans elle, la position moyenne de la trajectoire est prise</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Bas</translation>
    </message>
    <message>
        <source>Standard deviation of one LiDAR point on each axis, millimetres</source>
        <translation>Écart-type d&apos;un point LiDAR sur chaque axe, en millimètres</translation>
    </message>
    <message>
        <source>LiDAR noise (1 σ)</source>
        <translation>Bruit du LiDAR (1 σ)</translation>
    </message>
    <message>
        <source>Position (1 σ)</source>
        <translation>Position (1 σ)</translation>
    </message>
    <message>
        <source>Attitude (1 σ)</source>
        <translation>Attitude (1 σ)</translation>
    </message>
    <message>
        <source>Stated by you.</source>
        <translation>Indiqué par vous.</translation>
    </message>
    <message>
        <source>As found in the file, or by default.</source>
        <translation>Trouvé dans le fichier, ou par défaut.</translation>
    </message>
    <message>
        <source>This is {system:kept}.</source>
        <translation>Il s&apos;agit de {system}.</translation>
    </message>
    <message>
        <source>EPSG:32619, say</source>
        <translation>EPSG:32619, par exemple</translation>
    </message>
    <message>
        <source>First rows of the file</source>
        <translation>Premières rangées du fichier</translation>
    </message>
    <message>
        <source>What this column is</source>
        <translation>Ce qu&apos;est cette colonne</translation>
    </message>
    <message>
        <source>Column {n:n}</source>
        <translation>Colonne {n}</translation>
    </message>
    <message>
        <source>Meaning of column {n:n}</source>
        <translation>Sens de la colonne {n}</translation>
    </message>
    <message>
        <source>No accuracy file: the sigmas typed under Mounting and accuracies hold at all times.</source>
        <translation>Pas de fichier de précision : les écarts-types saisis sous Montage et précisions valent à tout moment.</translation>
    </message>
    <message>
        <source>With smrmsg, or the standard deviations of a text export, their course appears here.</source>
        <translation>Avec smrmsg, ou les écarts-types d&apos;un export texte, leur évolution apparaît ici.</translation>
    </message>
    <message>
        <source>Speed and attitude</source>
        <translation>Vitesse et attitude</translation>
    </message>
    <message>
        <source>Accuracies</source>
        <translation>Précisions</translation>
    </message>
    <message>
        <source>Track</source>
        <translation>Trace</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Temps, s</translation>
    </message>
    <message>
        <source>East, m</source>
        <translation>Est, m</translation>
    </message>
    <message>
        <source>North, m</source>
        <translation>Nord, m</translation>
    </message>
    <message>
        <source>Standard deviations of position and attitude over time</source>
        <translation>Écarts-types de la position et de l&apos;attitude au cours du temps</translation>
    </message>
    <message>
        <source>The way of the vessel on a map, the lines in their colours</source>
        <translation>La route du navire sur une carte, les lignes dans leurs couleurs</translation>
    </message>
    <message>
        <source>Speed, roll and pitch, heading over time</source>
        <translation>Vitesse, roulis et tangage, cap au cours du temps</translation>
    </message>
    <message>
        <source>Shaded: the lines.</source>
        <translation>Ombré : les lignes.</translation>
    </message>
    <message>
        <source>Coloured: the lines.</source>
        <translation>En couleur : les lignes.</translation>
    </message>
    <message>
        <source>Add the trajectory: its accuracies, its track and its motion appear here.</source>
        <translation>Ajoutez la trajectoire : ses précisions, sa trace et son mouvement apparaissent ici.</translation>
    </message>
    <message>
        <source>{what} of the trajectory over time, lines marked</source>
        <translation>{what} de la trajectoire au cours du temps, lignes marquées</translation>
    </message>
    <message>
        <source>What there is to look at</source>
        <translation>Ce qu&apos;il y a à regarder</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Doubt</source>
        <translation>Doute</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>1 doubt</source>
        <translation>1 doute</translation>
    </message>
    <message>
        <source>{n:n} doubts</source>
        <translation>{n} doutes</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>En attente</translation>
    </message>
    <message>
        <source>Not known</source>
        <translation>Inconnu</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Écarté</translation>
    </message>
    <message>
        <source>no gap</source>
        <translation>aucune lacune</translation>
    </message>
    <message>
        <source>1 gap</source>
        <translation>1 lacune</translation>
    </message>
    <message>
        <source>{n:n} gaps</source>
        <translation>{n} lacunes</translation>
    </message>
    <message>
        <source>no trajectory yet</source>
        <translation>pas encore de trajectoire</translation>
    </message>
    <message>
        <source>{n:n} % outside</source>
        <translation>{n} % en dehors</translation>
    </message>
    <message>
        <source>{n:n} % in gaps</source>
        <translation>{n} % dans des lacunes</translation>
    </message>
    <message>
        <source>{a:n} % outside, {b:n} % in gaps</source>
        <translation>{a} % en dehors, {b} % dans des lacunes</translation>
    </message>
    <message>
        <source>{words} ({shift:n} s)</source>
        <translation>{words} ({shift} s)</translation>
    </message>
    <message>
        <source>covered</source>
        <translation>couverte</translation>
    </message>
    <message>
        <source>Timeline of the lines over the trajectory</source>
        <translation>Chronologie des lignes sur la trajectoire</translation>
    </message>
    <message>
        <source>No file with times yet</source>
        <translation>Pas encore de fichier avec des temps</translation>
    </message>
    <message>
        <source>Add the trajectory and the lines: their times appear here.</source>
        <translation>Ajoutez la trajectoire et les lignes : leurs temps apparaissent ici.</translation>
    </message>
    <message>
        <source>before the trajectory</source>
        <translation>avant la trajectoire</translation>
    </message>
    <message>
        <source>after the trajectory</source>
        <translation>après la trajectoire</translation>
    </message>
    <message>
        <source>gap {n:n} s</source>
        <translation>lacune {n} s</translation>
    </message>
    <message>
        <source>{name:kept} {start:n} to {end:n} s, {words}</source>
        <translation>{name} de {start} à {end} s, {words}</translation>
    </message>
    <message>
        <source>Longest gap between two states of the trajectory that a straight line bridges, seconds; points in longer gaps are left out</source>
        <translation>Plus longue lacune entre deux états de la trajectoire comblée par une droite, en secondes ; les points dans des lacunes plus longues sont laissés de côté</translation>
    </message>
    <message>
        <source>Longest gap bridged</source>
        <translation>Plus longue lacune comblée</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Décaler</translation>
    </message>
    <message>
        <source>Add {n:n} s to</source>
        <translation>Ajouter {n} s à</translation>
    </message>
    <message>
        <source>Add {n:n} s to all {lines:n} lines outside</source>
        <translation>Ajouter {n} s aux {lines} lignes en dehors</translation>
    </message>
    <message>
        <source>Shift all {lines:n} lines outside</source>
        <translation>Décaler les {lines} lignes en dehors</translation>
    </message>
    <message>
        <source>{n:n} % of the points lie in longer gaps</source>
        <translation>{n} % des points sont dans des lacunes plus longues</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Écarter</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Précision</translation>
    </message>
    <message>
        <source>Coordinate system</source>
        <translation>Système de coordonnées</translation>
    </message>
    <message>
        <source>Order of bytes</source>
        <translation>Ordre des octets</translation>
    </message>
    <message>
        <source>Time rollover</source>
        <translation>Retour à zéro du temps</translation>
    </message>
    <message>
        <source>nowhere</source>
        <translation>nulle part</translation>
    </message>
    <message>
        <source>at midnight</source>
        <translation>à minuit</translation>
    </message>
    <message>
        <source>at the end of the week</source>
        <translation>à la fin de la semaine</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatique</translation>
    </message>
    <message>
        <source>by the system</source>
        <translation>d&apos;après le système</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>comme l&apos;indique le fichier</translation>
    </message>
    <message>
        <source>On the map</source>
        <translation>Sur la carte</translation>
    </message>
    <message>
        <source>System not stated</source>
        <translation>Système non indiqué</translation>
    </message>
    <message>
        <source>Latitude, longitude</source>
        <translation>Latitude, longitude</translation>
    </message>
    <message>
        <source>North, east, down</source>
        <translation>Nord, est, bas</translation>
    </message>
    <message>
        <source>Not looked into, as it was stopped; press Look again.</source>
        <translation>Non examiné, l&apos;examen ayant été arrêté ; cliquez sur Réexaminer.</translation>
    </message>
    <message>
        <source>Listing the files</source>
        <translation>Liste des fichiers</translation>
    </message>
    <message>
        <source>Looking into {file:kept}</source>
        <translation>Examen de {file}</translation>
    </message>
    <message>
        <source>It cannot be looked into ({kind:kept}: {error}).</source>
        <translation>Il ne peut être examiné ({kind} : {error}).</translation>
    </message>
    <message>
        <source>Add {name:kept} to the project</source>
        <translation>Ajouter {name} au projet</translation>
    </message>
</context>
<context>
    <name>preview dialog</name>
    <message>
        <source>Preview of the report</source>
        <translation>Aperçu du rapport</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Save as PDF…</source>
        <translation>Enregistrer en PDF…</translation>
    </message>
    <message>
        <source>Page {n:n} of {all:n}</source>
        <translation>Page {n} sur {all}</translation>
    </message>
    <message>
        <source>Page {n:n}</source>
        <translation>Page {n}</translation>
    </message>
</context>
<context>
    <name>proposal dialog</name>
    <message>
        <source>Proposed targets</source>
        <translation>Cibles proposées</translation>
    </message>
    <message>
        <source>Proposed targets and validation planes</source>
        <translation>Cibles et plans de validation proposés</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Pourquoi</translation>
    </message>
    <message>
        <source>Add the ticked ones to the project</source>
        <translation>Ajouter au projet ce qui est coché</translation>
    </message>
    <message>
        <source>Add nothing</source>
        <translation>Ne rien ajouter</translation>
    </message>
    <message>
        <source>Untick to leave it out</source>
        <translation>Décocher pour l&apos;écarter</translation>
    </message>
    <message>
        <source>Seen on {lines:kept}</source>
        <translation>Vu sur {lines}</translation>
    </message>
    <message>
        <source>Accept {n:n} of {all:n}</source>
        <translation>Accepter {n} sur {all}</translation>
    </message>
    <message>
        <source>Validation planes take no part in the adjustment; the lines are compared on them. Untick what you do not want.</source>
        <translation>Les plans de validation ne servent pas à la compensation ; les lignes y sont comparées. Décochez ce que vous ne voulez pas.</translation>
    </message>
    <message>
        <source>No further targets are proposed: what would serve is picked already ({names:kept}).</source>
        <translation>Aucune autre cible n&apos;est proposée : ce qui servirait est déjà désigné ({names}).</translation>
    </message>
</context>
<context>
    <name>seed dialogs</name>
    <message>
        <source>Seed at coordinates</source>
        <translation>Désigner par coordonnées</translation>
    </message>
    <message>
        <source>The plane at this place is searched for on every line, with search radius, threshold and the rest as set in step 2. What is found is offered.</source>
        <translation>Le plan à cet endroit est cherché sur toutes les lignes, avec le rayon de recherche, le seuil et le reste réglés à l&apos;étape 2. Ce qui est trouvé est proposé.</translation>
    </message>
    <message>
        <source>The sphere at this place is searched for on every line, with search radius, threshold and the rest as set in step 2. What is found is offered.</source>
        <translation>La sphère à cet endroit est cherchée sur toutes les lignes, avec le rayon de recherche, le seuil et le reste réglés à l&apos;étape 2. Ce qui est trouvé est proposé.</translation>
    </message>
    <message>
        <source>The plane at this place is searched for on {line:kept} only, with search radius, threshold and the rest as set in step 2. What is found is offered.</source>
        <translation>Le plan à cet endroit n&apos;est cherché que sur {line}, avec le rayon de recherche, le seuil et le reste réglés à l&apos;étape 2. Ce qui est trouvé est proposé.</translation>
    </message>
    <message>
        <source>The sphere at this place is searched for on {line:kept} only, with search radius, threshold and the rest as set in step 2. What is found is offered.</source>
        <translation>La sphère à cet endroit n&apos;est cherchée que sur {line}, avec le rayon de recherche, le seuil et le reste réglés à l&apos;étape 2. Ce qui est trouvé est proposé.</translation>
    </message>
    <message>
        <source>Name of the new target</source>
        <translation>Nom de la nouvelle cible</translation>
    </message>
    <message>
        <source>There is a {name:kept} already; give the seed another name.</source>
        <translation>Il y a déjà une cible {name} ; donnez un autre nom au point initial.</translation>
    </message>
    <message>
        <source>{axis}: “{text:kept}” is not a number.</source>
        <translation>{axis} : « {text} » n&apos;est pas un nombre.</translation>
    </message>
    <message>
        <source>Still to be given: {axes:list}.</source>
        <translation>Encore à donner : {axes}.</translation>
    </message>
    <message>
        <source>{n:n} m from the trajectory.</source>
        <translation>À {n} m de la trajectoire.</translation>
    </message>
    <message>
        <source>In the local frame {n:n} m north, {w:n} m west, {u:n} m up; {d:n} m from the trajectory.</source>
        <translation>Dans le repère local, {n} m nord, {w} m ouest, {u} m haut ; à {d} m de la trajectoire.</translation>
    </message>
    <message>
        <source>Paste three numbers at once into the first field to fill all three</source>
        <translation>Collez trois nombres à la fois dans le premier champ pour remplir les trois</translation>
    </message>
    <message>
        <source>west</source>
        <translation>ouest</translation>
    </message>
    <message>
        <source>Easting</source>
        <translation>Abscisse est</translation>
    </message>
    <message>
        <source>Northing</source>
        <translation>Ordonnée nord</translation>
    </message>
    <message>
        <source>East</source>
        <translation>Est</translation>
    </message>
    <message>
        <source>{axis} (m)</source>
        <translation>{axis} (m)</translation>
    </message>
    <message>
        <source>{axis} (°)</source>
        <translation>{axis} (°)</translation>
    </message>
    <message>
        <source>{axis}, m</source>
        <translation>{axis}, m</translation>
    </message>
    <message>
        <source>{axis}, °</source>
        <translation>{axis}, °</translation>
    </message>
    <message>
        <source>Validation plane</source>
        <translation>Plan de validation</translation>
    </message>
    <message>
        <source>Off the track (m)</source>
        <translation>Hors trace (m)</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>Seeds from {file:kept}</source>
        <translation>Points initiaux de {file}</translation>
    </message>
    <message>
        <source>The role is that of the list, or goes by the name: what begins with V is a validation plane.</source>
        <translation>Le rôle est celui de la liste, ou suit le nom : ce qui commence par V est un plan de validation.</translation>
    </message>
    <message>
        <source>What the columns hold, from the left: name, x, y, z, role, and - for one that is not used. Empty: as the file names them, else in that order</source>
        <translation>Ce que contiennent les colonnes, de gauche à droite : name, x, y, z, role, et - pour une colonne inutilisée. Vide : comme les nomme le fichier, sinon dans cet ordre</translation>
    </message>
    <message>
        <source>As the file names them, else name, x, y, z, role</source>
        <translation>Comme les nomme le fichier, sinon name, x, y, z, role</translation>
    </message>
    <message>
        <source>Seeds that were read</source>
        <translation>Points initiaux lus</translation>
    </message>
    <message>
        <source>Pick nothing</source>
        <translation>Ne rien désigner</translation>
    </message>
    <message>
        <source>Row {n:n} of the list; untick to leave it out</source>
        <translation>Rangée {n} de la liste ; décocher pour l&apos;écarter</translation>
    </message>
    <message>
        <source>Picked already; tick to replace</source>
        <translation>Déjà désignée ; cocher pour remplacer</translation>
    </message>
    <message>
        <source>Pick {n:n} of {all:n}</source>
        <translation>Désigner {n} sur {all}</translation>
    </message>
    <message>
        <source>Seeds picked</source>
        <translation>Points initiaux désignés</translation>
    </message>
    <message>
        <source>{n:n} of {all:n} seeds led to a target.</source>
        <translation>{n} points initiaux sur {all} ont donné une cible.</translation>
    </message>
    <message>
        <source>One undo step takes all of them back.</source>
        <translation>Une seule annulation les retire tous.</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Ce qui a été trouvé</translation>
    </message>
    <message>
        <source>Not on {line:kept}: {why}</source>
        <translation>Pas sur {line} : {why}</translation>
    </message>
    <message>
        <source>Seeds from a file</source>
        <translation>Points initiaux d&apos;un fichier</translation>
    </message>
    <message>
        <source>Lists of coordinates (*.txt *.csv *.asc *.xyz *.pts *.dat);;All files (*)</source>
        <translation>Listes de coordonnées (*.txt *.csv *.asc *.xyz *.pts *.dat);;Tous les fichiers (*)</translation>
    </message>
</context>
<context>
    <name>files and questions</name>
    <message>
        <source>Open plan</source>
        <translation>Ouvrir un plan</translation>
    </message>
    <message>
        <source>Plan (*.toml)</source>
        <translation>Plan (*.toml)</translation>
    </message>
    <message>
        <source>Save plan</source>
        <translation>Enregistrer le plan</translation>
    </message>
    <message>
        <source>Write the field plan</source>
        <translation>Écrire le plan de terrain</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Open site</source>
        <translation>Ouvrir un site</translation>
    </message>
    <message>
        <source>Site (*.toml)</source>
        <translation>Site (*.toml)</translation>
    </message>
    <message>
        <source>PDF (*.pdf);;HTML (*.html);;Numbers as JSON (*.json);;Tables as CSV in a ZIP file (*.zip)</source>
        <translation>PDF (*.pdf);;HTML (*.html);;Chiffres en JSON (*.json);;Tableaux en CSV dans un fichier ZIP (*.zip)</translation>
    </message>
    <message>
        <source>Add the files to {name:kept}?</source>
        <translation>Ajouter les fichiers à {name} ?</translation>
    </message>
    <message>
        <source>Lines are added to the open project and checked against its trajectory; what has been picked stays. Files of another survey make a new project.</source>
        <translation>Les lignes sont ajoutées au projet ouvert et contrôlées par rapport à sa trajectoire ; ce qui a été désigné reste. Les fichiers d&apos;un autre levé font un nouveau projet.</translation>
    </message>
    <message>
        <source>Add to {name:kept}</source>
        <translation>Ajouter à {name}</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>Ouvrir un projet</translation>
    </message>
    <message>
        <source>Open project…</source>
        <translation>Ouvrir un projet…</translation>
    </message>
    <message>
        <source>New project…</source>
        <translation>Nouveau projet…</translation>
    </message>
    <message>
        <source>LISPAC project (project.json *.lispac)</source>
        <translation>Projet LISPAC (project.json *.lispac)</translation>
    </message>
    <message>
        <source>Save project as: name of its new folder</source>
        <translation>Enregistrer le projet sous : nom de son nouveau dossier</translation>
    </message>
    <message>
        <source>Folder with the projects of all calibrations</source>
        <translation>Dossier des projets de tous les étalonnages</translation>
    </message>
    <message>
        <source>Export report</source>
        <translation>Exporter le rapport</translation>
    </message>
    <message>
        <source>Save the report as PDF</source>
        <translation>Enregistrer le rapport en PDF</translation>
    </message>
    <message>
        <source>Template of the report</source>
        <translation>Modèle du rapport</translation>
    </message>
    <message>
        <source>Report template (*.toml)</source>
        <translation>Modèle de rapport (*.toml)</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Enregistrer l&apos;image</translation>
    </message>
    <message>
        <source>Save the changes to {name:kept}?</source>
        <translation>Enregistrer les modifications de {name} ?</translation>
    </message>
    <message>
        <source>{name:kept} was found and is not accepted yet.</source>
        <translation>{name} a été trouvée et n&apos;est pas encore acceptée.</translation>
    </message>
    <message>
        <source>Only accepted targets take part in the adjustment.</source>
        <translation>Seules les cibles acceptées prennent part à la compensation.</translation>
    </message>
    <message>
        <source>Accept and estimate</source>
        <translation>Accepter et estimer</translation>
    </message>
    <message>
        <source>Estimate without it</source>
        <translation>Estimer sans elle</translation>
    </message>
    <message>
        <source>Copy numbers</source>
        <translation>Copier les nombres</translation>
    </message>
    <message>
        <source>Copy the table for a spreadsheet</source>
        <translation>Copier le tableau pour un tableur</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Copier l&apos;image</translation>
    </message>
    <message>
        <source>Copy the plot as it is shown</source>
        <translation>Copier le graphique tel qu&apos;il est montré</translation>
    </message>
</context>
<context>
    <name>subsampling dialog</name>
    <message>
        <source>Point spacing (m)</source>
        <translation>Espacement des points (m)</translation>
    </message>
    <message>
        <source>Points of a sighting nearer together are averaged</source>
        <translation>Les points d&apos;une observation plus rapprochés sont moyennés</translation>
    </message>
    <message>
        <source>That took part; averaged ones count once</source>
        <translation>Qui ont pris part ; les points moyennés comptent une fois</translation>
    </message>
    <message>
        <source>Of the adjustment, without the selection of the points</source>
        <translation>De la compensation, sans le choix des points</translation>
    </message>
    <message>
        <source>Subsampling study</source>
        <translation>Étude du sous-échantillonnage</translation>
    </message>
    <message>
        <source>The same sightings adjusted with points nearer together and farther apart. Points of one sighting share the errors of the POS: where the sigmas no longer shrink, more points only take time. The project stays as it is.</source>
        <translation>Les mêmes observations compensées avec des points plus rapprochés et plus espacés. Les points d&apos;une observation partagent les erreurs du POS : là où les écarts-types ne diminuent plus, davantage de points ne font que prendre du temps. Le projet reste tel quel.</translation>
    </message>
    <message>
        <source>In orange: the {n:n} m of the project&apos;s settings.</source>
        <translation>En orange : les {n} m des réglages du projet.</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Temps (s)</translation>
    </message>
    <message>
        <source>all points</source>
        <translation>tous les points</translation>
    </message>
</context>
<context>
    <name>systems</name>
    <message>
        <source>Local frame – North, West, Up</source>
        <translation>Repère local – nord, ouest, haut</translation>
    </message>
    <message>
        <source>Choose, or type an EPSG code: EPSG:2959, EPSG:6347+5703</source>
        <translation>Choisir, ou saisir un code EPSG : EPSG:2959, EPSG:6347+5703</translation>
    </message>
    <message>
        <source>{zone:kept} – UTM zone of the trajectory (WGS 84)</source>
        <translation>{zone} – zone UTM de la trajectoire (WGS 84)</translation>
    </message>
    <message>
        <source>As the lines&apos; files – {system:kept}</source>
        <translation>Comme les fichiers des lignes – {system}</translation>
    </message>
    <message>
        <source>Choose a coordinate system, or type its EPSG code.</source>
        <translation>Choisissez un système de coordonnées, ou saisissez son code EPSG.</translation>
    </message>
</context>
<context>
    <name>visibility dialog</name>
    <message>
        <source>With its size</source>
        <translation>Avec sa grandeur</translation>
    </message>
    <message>
        <source>Inclinations that Type I keeps</source>
        <translation>Inclinaisons que retient le type I</translation>
    </message>
    <message>
        <source>By its appendix C and section 3.9</source>
        <translation>D&apos;après son annexe C et sa section 3.9</translation>
    </message>
    <message>
        <source>Inclination at which the lines differ most</source>
        <translation>Inclinaison à laquelle les lignes diffèrent le plus</translation>
    </message>
    <message>
        <source>Thesis&apos;s best</source>
        <translation>Meilleure, thèse</translation>
    </message>
    <message>
        <source>By its table 3.2 and section 3.9</source>
        <translation>D&apos;après son tableau 3.2 et sa section 3.9</translation>
    </message>
    <message>
        <source>Headings; lines joined by / show the same, one of them is enough</source>
        <translation>Caps ; les lignes jointes par / montrent la même chose, une seule suffit</translation>
    </message>
    <message>
        <source>Thesis&apos;s lines</source>
        <translation>Lignes, thèse</translation>
    </message>
    <message>
        <source>By its table 3.2 and section 4.4.1.1</source>
        <translation>D&apos;après son tableau 3.2 et sa section 4.4.1.1</translation>
    </message>
    <message>
        <source>Beside the thesis; the row&apos;s tip says why it differs</source>
        <translation>Par rapport à la thèse ; l&apos;infobulle de la rangée dit pourquoi elle diffère</translation>
    </message>
    <message>
        <source>Beside the thesis</source>
        <translation>Par rapport à la thèse</translation>
    </message>
    <message>
        <source>Move the mouse over the chart to read values off</source>
        <translation>Passez la souris sur le graphique pour lire des valeurs</translation>
    </message>
    <message>
        <source>Best configurations</source>
        <translation>Meilleures configurations</translation>
    </message>
    <message>
        <source>Visibility of errors</source>
        <translation>Visibilité des erreurs</translation>
    </message>
    <message>
        <source>One board on six lines, with one systematic error at a time and no noise: at which inclination and on which lines is the error seen? Shaded is what Type I keeps, dashed the best.</source>
        <translation>Un panneau sur six lignes, avec une erreur systématique à la fois et sans bruit : à quelle inclinaison et sur quelles lignes l&apos;erreur est-elle vue ? En ombré, ce que retient le type I ; en tirets, le meilleur.</translation>
    </message>
    <message>
        <source>A vehicle 2.5 m above a board on the ground, or a vessel 15 m from a quay 5 m high</source>
        <translation>Un véhicule à 2,5 m au-dessus d&apos;un panneau au sol, ou un navire à 15 m d&apos;un quai haut de 5 m</translation>
    </message>
    <message>
        <source>Which systematic error is there</source>
        <translation>Quelle erreur systématique est présente</translation>
    </message>
    <message>
        <source>What is drawn</source>
        <translation>Ce qui est dessiné</translation>
    </message>
    <message>
        <source>Copy what the chart is drawn from as a table for a spreadsheet</source>
        <translation>Copier les données du graphique comme tableau pour un tableur</translation>
    </message>
    <message>
        <source>{error} beside the thesis: {why}</source>
        <translation>{error}, par rapport à la thèse : {why}</translation>
    </message>
</context>
<context>
    <name>step panels</name>
    <message>
        <source>{n:n}  {title}</source>
        <translation>{n}  {title}</translation>
    </message>
    <message>
        <source>&amp;{n:n}  {title}</source>
        <translation>&amp;{n}  {title}</translation>
    </message>
    <message>
        <source>{n:n}  {title}: {sentence}</source>
        <translation>{n}  {title} : {sentence}</translation>
    </message>
    <message>
        <source>{n:n}  {title}: {sentence} ({state})</source>
        <translation>{n}  {title} : {sentence} ({state})</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Appliquer</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Rétablir les valeurs</translation>
    </message>
    <message>
        <source>typed sigmas, the same at all times</source>
        <translation>écarts-types saisis, les mêmes à tout moment</translation>
    </message>
    <message>
        <source>Tick to show the line in the view</source>
        <translation>Cocher pour montrer la ligne dans la vue 3D</translation>
    </message>
    <message>
        <source>Lever arm, POS to LiDAR</source>
        <translation>Bras de levier, du POS au LiDAR</translation>
    </message>
    <message>
        <source>Place the lines with these numbers; results that rest on the old ones are dropped</source>
        <translation>Placer les lignes avec ces nombres ; les résultats fondés sur les anciens sont abandonnés</translation>
    </message>
    <message>
        <source>Back to the values in use</source>
        <translation>Revenir aux valeurs en usage</translation>
    </message>
    <message>
        <source>Surveyor, vessel, instruments, dates: what page one of the report says</source>
        <translation>Hydrographe, navire, instruments, dates : ce que dit la page un du rapport</translation>
    </message>
    <message>
        <source>Surveyor, vessel, instruments, dates: what page one says of who, when and with what</source>
        <translation>Hydrographe, navire, instruments, dates : ce que dit la page un de qui, quand et avec quoi</translation>
    </message>
    <message>
        <source>A project holds a trajectory (SBET), its accuracies, and one raw scan file for each pass of the vessel.</source>
        <translation>Un projet contient une trajectoire (SBET), ses précisions et un fichier de balayage brut pour chaque passage du navire.</translation>
    </message>
    <message>
        <source>Open the demo survey</source>
        <translation>Ouvrir le levé de démonstration</translation>
    </message>
    <message>
        <source>Lines of the survey</source>
        <translation>Lignes du levé</translation>
    </message>
    <message>
        <source>X forward</source>
        <translation>X avant</translation>
    </message>
    <message>
        <source>Y left</source>
        <translation>Y gauche</translation>
    </message>
    <message>
        <source>Z up</source>
        <translation>Z haut</translation>
    </message>
    <message>
        <source>Lever arm X: LiDAR optical centre from the POS centre, metres, positive forward</source>
        <translation>Bras de levier X : centre optique du LiDAR depuis le centre du POS, en mètres, positif vers l&apos;avant</translation>
    </message>
    <message>
        <source>Lever arm Y: LiDAR optical centre from the POS centre, metres, positive left</source>
        <translation>Bras de levier Y : centre optique du LiDAR depuis le centre du POS, en mètres, positif vers la gauche (bâbord)</translation>
    </message>
    <message>
        <source>Lever arm Z: LiDAR optical centre from the POS centre, metres, positive up</source>
        <translation>Bras de levier Z : centre optique du LiDAR depuis le centre du POS, en mètres, positif vers le haut</translation>
    </message>
    <message>
        <source>Prior roll of the LiDAR in the body frame, degrees, positive left side up</source>
        <translation>Roulis a priori du LiDAR dans le repère du navire, en degrés, positif quand bâbord monte</translation>
    </message>
    <message>
        <source>Prior pitch of the LiDAR in the body frame, degrees, positive bow down</source>
        <translation>Tangage a priori du LiDAR dans le repère du navire, en degrés, positif quand l&apos;étrave descend</translation>
    </message>
    <message>
        <source>Prior yaw of the LiDAR in the body frame, degrees, positive clockwise from above</source>
        <translation>Lacet a priori du LiDAR dans le repère du navire, en degrés, positif dans le sens horaire vu d&apos;en haut</translation>
    </message>
    <message>
        <source>Hold &lt;b&gt;Ctrl&lt;/b&gt; and click a target in the view. The plane is searched for on every line.</source>
        <translation>Maintenez &lt;b&gt;Ctrl&lt;/b&gt; et cliquez sur une cible dans la vue 3D. Le plan est cherché sur toutes les lignes.</translation>
    </message>
    <message>
        <source>Hold &lt;b&gt;Ctrl&lt;/b&gt; and click a target in the view. The sphere is searched for on every line.</source>
        <translation>Maintenez &lt;b&gt;Ctrl&lt;/b&gt; et cliquez sur une cible dans la vue 3D. La sphère est cherchée sur toutes les lignes.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Ctrl&lt;/b&gt;+click gives {name:kept} a sighting of its own on {line:kept}; its other lines stay as they are.</source>
        <translation>&lt;b&gt;Ctrl&lt;/b&gt;+clic donne à {name} une observation à elle sur {line} ; ses autres lignes restent telles quelles.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Ctrl&lt;/b&gt;+click seeks a new plane on {line:kept} only. To add the line to a target, select the target in the list first.</source>
        <translation>&lt;b&gt;Ctrl&lt;/b&gt;+clic cherche un nouveau plan sur {line} seulement. Pour ajouter la ligne à une cible, sélectionnez d&apos;abord la cible dans la liste.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Ctrl&lt;/b&gt;+click seeks a new sphere on {line:kept} only. To add the line to a target, select the target in the list first.</source>
        <translation>&lt;b&gt;Ctrl&lt;/b&gt;+clic cherche une nouvelle sphère sur {line} seulement. Pour ajouter la ligne à une cible, sélectionnez d&apos;abord la cible dans la liste.</translation>
    </message>
    <message>
        <source>default</source>
        <translation>par défaut</translation>
    </message>
    <message>
        <source>default ({n:n} mm)</source>
        <translation>par défaut ({n} mm)</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>any</source>
        <translation>libre</translation>
    </message>
    <message>
        <source>The plane or sphere takes part in the adjustment (F6)</source>
        <translation>Le plan ou la sphère prend part à la compensation (F6)</translation>
    </message>
    <message>
        <source>The plane takes no part; the lines are compared on it before and after (F7)</source>
        <translation>Le plan n&apos;y prend pas part ; les lignes y sont comparées avant et après (F7)</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Sphère</translation>
    </message>
    <message>
        <source>Shape of the target; lines are compared on planes only, so a validation target is one</source>
        <translation>Forme de la cible ; les lignes ne sont comparées que sur des plans, une cible de validation en est donc un</translation>
    </message>
    <message>
        <source>Radius of the ball, not its diameter; 0 where it is unknown: balls of {low:n} to {high:n} m are then searched for and the radius is estimated</source>
        <translation>Rayon de la sphère, non son diamètre ; 0 s&apos;il est inconnu : des sphères de {low} à {high} m sont alors cherchées et le rayon est estimé</translation>
    </message>
    <message>
        <source>Choose one line to seed it alone, where the search from another line failed</source>
        <translation>Choisir une ligne pour n&apos;y désigner qu&apos;elle, là où la recherche depuis une autre a échoué</translation>
    </message>
    <message>
        <source>Only points this near to the seed can belong to the target; 0 leaves it to the program</source>
        <translation>Seuls des points à cette distance du point initial au plus peuvent appartenir à la cible ; 0 laisse le choix au programme</translation>
    </message>
    <message>
        <source>Farthest a point may lie from its plane or sphere (RANSAC threshold); 0 gives the larger of {least:n} mm and 3 × the LiDAR noise, for spheres at least {sphere:n} mm (a small ball: 0.3 of its radius)</source>
        <translation>Distance maximale d&apos;un point à son plan ou à sa sphère (seuil de RANSAC) ; 0 donne la plus grande de {least} mm et 3 × le bruit du LiDAR, pour les sphères au moins {sphere} mm (petite sphère : 0,3 de son rayon)</translation>
    </message>
    <message>
        <source>Ball radius</source>
        <translation>Rayon de la sphère</translation>
    </message>
    <message>
        <source>Seek on</source>
        <translation>Chercher sur</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>Attendu</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>Propose targets</source>
        <translation>Proposer des cibles</translation>
    </message>
    <message>
        <source>Coordinates…</source>
        <translation>Coordonnées…</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>D&apos;un fichier…</translation>
    </message>
    <message>
        <source>Type the coordinates of a seed, in the local frame or on the map (F3)</source>
        <translation>Saisir les coordonnées d&apos;un point initial, dans le repère local ou sur la carte (F3)</translation>
    </message>
    <message>
        <source>Pick all targets of a list of coordinates (Shift+F3)</source>
        <translation>Désigner toutes les cibles d&apos;une liste de coordonnées (Maj+F3)</translation>
    </message>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Suppr</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Targets and validation planes</source>
        <translation>Cibles et plans de validation</translation>
    </message>
    <message>
        <source>Tick to use it; double-click or F2 to rename</source>
        <translation>Cocher pour l&apos;employer ; double-clic ou F2 pour renommer</translation>
    </message>
    <message>
        <source>Radius {radius} (known)</source>
        <translation>Rayon {radius} (connu)</translation>
    </message>
    <message>
        <source>Radius {a} to {b}</source>
        <translation>Rayon de {a} à {b}</translation>
    </message>
    <message>
        <source>{radius}; {a:n} to {b:n} % of the surface seen.</source>
        <translation>{radius} ; {a} à {b} % de la surface vus.</translation>
    </message>
    <message>
        <source>Radius unknown</source>
        <translation>Rayon inconnu</translation>
    </message>
    <message>
        <source>Accept  ⏎</source>
        <translation>Accepter  ⏎</translation>
    </message>
    <message>
        <source>Reject  Esc</source>
        <translation>Rejeter  Échap</translation>
    </message>
    <message>
        <source>Target {name:kept}</source>
        <translation>Cible {name}</translation>
    </message>
    <message>
        <source>Target {name:kept} (in place of the present one)</source>
        <translation>Cible {name} (à la place de l&apos;actuelle)</translation>
    </message>
    <message>
        <source>Validation plane {name:kept}</source>
        <translation>Plan de validation {name}</translation>
    </message>
    <message>
        <source>Validation plane {name:kept} (in place of the present one)</source>
        <translation>Plan de validation {name} (à la place de l&apos;actuel)</translation>
    </message>
    <message>
        <source>Found on {some:n} of {all:n} lines: {points:n} points, within {rms} RMS of their planes.</source>
        <translation>Trouvée sur {some} lignes sur {all} : {points} points, à {rms} RMS de leurs plans.</translation>
    </message>
    <message>
        <source>Found on {some:n} of {all:n} lines: {points:n} points, within {rms} RMS of their spheres.</source>
        <translation>Trouvée sur {some} lignes sur {all} : {points} points, à {rms} RMS de leurs sphères.</translation>
    </message>
    <message>
        <source>Not found on {lines:kept}.</source>
        <translation>Non trouvée sur {lines}.</translation>
    </message>
    <message>
        <source>Size and inclination are as expected.</source>
        <translation>Taille et inclinaison sont comme attendu.</translation>
    </message>
    <message>
        <source>Not as expected on {line:name}: {words}</source>
        <translation>Pas comme attendu sur {line} : {words}</translation>
    </message>
    <message>
        <source>Not as expected on {line:name}: {words} ({n:n} more lines differ too)</source>
        <translation>Pas comme attendu sur {line} : {words} ({n} autres lignes diffèrent aussi)</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Plus</translation>
    </message>
    <message>
        <source>Fewest points of the target in a line: less finds small or distant targets, more keeps scraps out (usually {n:n})</source>
        <translation>Nombre minimal de points de la cible dans une ligne : moins trouve des cibles petites ou lointaines, plus écarte les débris (d&apos;ordinaire {n})</translation>
    </message>
    <message>
        <source>Largest angle between the target in one line and in another: more where the prior boresight may be far off, less where surfaces of other slopes are near (usually {n:n}°)</source>
        <translation>Plus grand angle entre la cible dans une ligne et dans une autre : plus si les angles de visée a priori peuvent être très faux, moins si des surfaces d&apos;autres pentes sont proches (d&apos;ordinaire {n}°)</translation>
    </message>
    <message>
        <source>Fewest points</source>
        <translation>Points au moins</translation>
    </message>
    <message>
        <source>Largest tilt</source>
        <translation>Angle maximal</translation>
    </message>
    <message>
        <source>Width of the target, 0 where nothing is known; the planes found are compared with it. {width:n} × {height:n} m at 90° is the usual board</source>
        <translation>Largeur de la cible, 0 si rien n&apos;est connu ; les plans trouvés lui sont comparés. {width} × {height} m à 90° est le panneau usuel</translation>
    </message>
    <message>
        <source>Height of the target up its slope, 0 where nothing is known; the planes found are compared with it. {width:n} × {height:n} m at 90° is the usual board</source>
        <translation>Hauteur de la cible le long de sa pente, 0 si rien n&apos;est connu ; les plans trouvés lui sont comparés. {width} × {height} m à 90° est le panneau usuel</translation>
    </message>
    <message>
        <source>Angle from level: 0 lies flat, 90 stands upright; the planes found are compared with it. {width:n} × {height:n} m at 90° is the usual board</source>
        <translation>Angle depuis l&apos;horizontale : 0 à plat, 90 debout ; les plans trouvés lui sont comparés. {width} × {height} m à 90° est le panneau usuel</translation>
    </message>
    <message>
        <source>Being judged</source>
        <translation>Évaluation en cours</translation>
    </message>
    <message>
        <source>{line:kept}: Being judged</source>
        <translation>{line} : évaluation en cours</translation>
    </message>
    <message>
        <source>{line:kept}: {points:n} points, {rms} RMS</source>
        <translation>{line} : {points} points, {rms} RMS</translation>
    </message>
    <message>
        <source>{line:kept}: Quality: {light}</source>
        <translation>{line} : qualité {light}</translation>
    </message>
    <message>
        <source>4  Validate</source>
        <translation>4  Validation</translation>
    </message>
    <message>
        <source>&amp;4  Validate</source>
        <translation>&amp;4  Validation</translation>
    </message>
    <message>
        <source>4  Validate: {sentence}</source>
        <translation>4  Validation : {sentence}</translation>
    </message>
    <message>
        <source>4  Validate: {sentence} ({state})</source>
        <translation>4  Validation : {sentence} ({state})</translation>
    </message>
    <message>
        <source>{a}; {b}; {c}.</source>
        <translation>{a} ; {b} ; {c}.</translation>
    </message>
    <message>
        <source>Boresight and lever arm in this program</source>
        <translation>Angles et bras de levier de ce programme</translation>
    </message>
    <message>
        <source>Accept targets that all face one way</source>
        <translation>Accepter une orientation unique</translation>
    </message>
    <message>
        <source>Metres North, West and Up from the project&apos;s origin</source>
        <translation>Mètres vers le nord, l&apos;ouest et le haut depuis l&apos;origine du projet</translation>
    </message>
</context>
<context>
    <name>adjust panel</name>
    <message>
        <source>Correlated in time</source>
        <translation>Corrélées dans le temps</translation>
    </message>
    <message>
        <source>The POS error drifts slowly, so neighbouring points share it. The sigmas are realistic.</source>
        <translation>L&apos;erreur du POS dérive lentement : des points voisins la partagent. Les écarts-types sont réalistes.</translation>
    </message>
    <message>
        <source>Uncorrelated POS errors (classical)</source>
        <translation>Erreurs du POS non corrélées (classique)</translation>
    </message>
    <message>
        <source>Every point has a POS error of its own. For comparison only: the sigmas come out several times too small.</source>
        <translation>Chaque point a sa propre erreur du POS. Pour comparaison seulement : les écarts-types sont plusieurs fois trop petits.</translation>
    </message>
    <message>
        <source>Additional parameters</source>
        <translation>Paramètres supplémentaires</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Avancé</translation>
    </message>
    <message>
        <source>{n:n} values</source>
        <translation>{n} valeurs</translation>
    </message>
    <message>
        <source>Cross-check with parts of the data</source>
        <translation>Vérifier avec des parties des données</translation>
    </message>
    <message>
        <source>Adjust again without each line and each target, and each half of the survey by itself</source>
        <translation>Compenser de nouveau sans chaque ligne et chaque cible, et chaque moitié du levé séparément</translation>
    </message>
    <message>
        <source>Estimate boresight</source>
        <translation>Estimer les angles de visée</translation>
    </message>
    <message>
        <source>Adjust boresight and targets together by least squares (F9)</source>
        <translation>Compenser ensemble angles de visée et cibles par moindres carrés (F9)</translation>
    </message>
    <message>
        <source>No target yet, so no points to thin.</source>
        <translation>Pas encore de cible, donc pas de points à éclaircir.</translation>
    </message>
    <message>
        <source>{points} in {sightings}: not enough to adjust.</source>
        <translation>{points} en {sightings} : pas assez pour compenser.</translation>
    </message>
    <message>
        <source>Counting … ({points} in {sightings})</source>
        <translation>Comptage… ({points} en {sightings})</translation>
    </message>
    <message>
        <source>&lt;b&gt;{points:n} points&lt;/b&gt; took part, in {sightings}.</source>
        <translation>&lt;b&gt;{points} points&lt;/b&gt; ont pris part, en {sightings}.</translation>
    </message>
    <message>
        <source>&lt;b&gt;All {n:n}&lt;/b&gt; points take part, in {sightings}.</source>
        <translation>&lt;b&gt;Les {n}&lt;/b&gt; points prennent tous part, en {sightings}.</translation>
    </message>
    <message>
        <source>About &lt;b&gt;{n:n}&lt;/b&gt; of {all:n} points take part, in {sightings}.</source>
        <translation>Environ &lt;b&gt;{n}&lt;/b&gt; points sur {all} prennent part, en {sightings}.</translation>
    </message>
    <message>
        <source>Points of a sighting nearer to each other than this are thinned; 0 keeps all</source>
        <translation>Les points d&apos;une observation plus proches entre eux sont éclaircis ; 0 les garde tous</translation>
    </message>
    <message>
        <source>Unit of the distance</source>
        <translation>Unité de la distance</translation>
    </message>
    <message>
        <source>Point spacing</source>
        <translation>Espacement des points</translation>
    </message>
    <message>
        <source>How long the POS error stays like itself. Position drifts over minutes, attitude more slowly. Where the processing report states correlation times, use them; too short a time is safer than too long a one.</source>
        <translation>Combien de temps l&apos;erreur du POS reste semblable à elle-même. La position dérive en quelques minutes, l&apos;attitude plus lentement. Si le rapport de traitement donne des temps de corrélation, prenez-les ; un temps trop court est plus sûr qu&apos;un temps trop long.</translation>
    </message>
    <message>
        <source>As the model does</source>
        <translation>Selon le modèle</translation>
    </message>
    <message>
        <source>Tukey with correlated POS errors, none with uncorrelated ones</source>
        <translation>Tukey avec des erreurs du POS corrélées, aucune sans corrélation</translation>
    </message>
    <message>
        <source>All points alike</source>
        <translation>Tous les points autant</translation>
    </message>
    <message>
        <source>No point loses weight, however far it lies off</source>
        <translation>Aucun point ne perd de poids, si loin soit-il</translation>
    </message>
    <message>
        <source>Far points count less (Huber)</source>
        <translation>Les points éloignés comptent moins (Huber)</translation>
    </message>
    <message>
        <source>The weight falls beyond 1.3 σ, never to zero</source>
        <translation>Le poids baisse au-delà de 1,3 σ, jamais jusqu&apos;à zéro</translation>
    </message>
    <message>
        <source>Stray points do not count (Tukey)</source>
        <translation>Les aberrants ne comptent pas (Tukey)</translation>
    </message>
    <message>
        <source>Points beyond 4.7 σ have no say</source>
        <translation>Les points au-delà de 4,7 σ n&apos;ont aucun poids</translation>
    </message>
    <message>
        <source>Same on all axes</source>
        <translation>Égal sur tous les axes</translation>
    </message>
    <message>
        <source>Along X, Y, Z</source>
        <translation>Selon X, Y, Z</translation>
    </message>
    <message>
        <source>Range and angle</source>
        <translation>Distance et angle</translation>
    </message>
    <message>
        <source>LiDAR along X, Y, Z</source>
        <translation>LiDAR selon X, Y, Z</translation>
    </message>
    <message>
        <source>LiDAR along x, y, z</source>
        <translation>LiDAR selon x, y, z</translation>
    </message>
    <message>
        <source>surface σ typed</source>
        <translation>σ de surface saisi</translation>
    </message>
    <message>
        <source>variance components</source>
        <translation>composantes de variance</translation>
    </message>
    <message>
        <source>one facing accepted</source>
        <translation>orientation unique acceptée</translation>
    </message>
    <message>
        <source>huber</source>
        <translation>Huber</translation>
    </message>
    <message>
        <source>tukey</source>
        <translation>Tukey</translation>
    </message>
    <message>
        <source>Position time</source>
        <translation>Temps, position</translation>
    </message>
    <message>
        <source>Attitude time</source>
        <translation>Temps, attitude</translation>
    </message>
    <message>
        <source>How far what one line sees of a target may lie off the shape all lines share</source>
        <translation>De combien ce qu&apos;une ligne voit d&apos;une cible peut s&apos;écarter de la forme commune à toutes les lignes</translation>
    </message>
    <message>
        <source>Surface σ, mm</source>
        <translation>σ de surface, mm</translation>
    </message>
    <message>
        <source>from the data</source>
        <translation>des données</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>What is done with points that lie far off their surface</source>
        <translation>Ce qui est fait des points loin de leur surface</translation>
    </message>
    <message>
        <source>How the noise of a LiDAR point is stated</source>
        <translation>Comment le bruit d&apos;un point LiDAR est déclaré</translation>
    </message>
    <message>
        <source>Noise along {axis:kept} of the LiDAR, one standard deviation</source>
        <translation>Bruit selon {axis} du LiDAR, un écart-type</translation>
    </message>
    <message>
        <source>LiDAR noise along {axis:kept}</source>
        <translation>Bruit du LiDAR selon {axis}</translation>
    </message>
    <message>
        <source>X, mm</source>
        <translation>X, mm</translation>
    </message>
    <message>
        <source>Y, mm</source>
        <translation>Y, mm</translation>
    </message>
    <message>
        <source>Z, mm</source>
        <translation>Z, mm</translation>
    </message>
    <message>
        <source>LiDAR range noise</source>
        <translation>Bruit de distance du LiDAR</translation>
    </message>
    <message>
        <source>Noise of the range, one standard deviation</source>
        <translation>Bruit de la distance, un écart-type</translation>
    </message>
    <message>
        <source>range, mm</source>
        <translation>distance, mm</translation>
    </message>
    <message>
        <source>LiDAR angle noise</source>
        <translation>Bruit d&apos;angle du LiDAR</translation>
    </message>
    <message>
        <source>Noise of the beam&apos;s direction, one standard deviation</source>
        <translation>Bruit de la direction du faisceau, un écart-type</translation>
    </message>
    <message>
        <source>angle, °</source>
        <translation>angle, °</translation>
    </message>
    <message>
        <source>Find how large the errors are</source>
        <translation>Chercher la grandeur des erreurs</translation>
    </message>
    <message>
        <source>Variance components: the sigmas of LiDAR, POS position and POS attitude are scaled by what the data say. With few sightings the data say little of the POS.</source>
        <translation>Composantes de variance : les écarts-types du LiDAR, de la position et de l&apos;attitude du POS sont mis à l&apos;échelle d&apos;après les données. Avec peu d&apos;observations, les données disent peu du POS.</translation>
    </message>
    <message>
        <source>For boards that all hang on one wall, or a single one. Only the headings of the lines tell the angles apart then, and nothing shows whether a board is bent or moved. A target of another inclination, or a sphere, is better.</source>
        <translation>Pour des panneaux tous accrochés à un même mur, ou un seul panneau. Seuls les caps des lignes distinguent alors les angles, et rien ne montre si un panneau est déformé ou a bougé. Une cible d&apos;une autre inclinaison, ou une sphère, vaut mieux.</translation>
    </message>
    <message>
        <source>{n:n} mm, as typed in step 1</source>
        <translation>{n} mm, comme saisi à l&apos;étape 1</translation>
    </message>
    <message>
        <source>The LiDAR sigma along X, Y and Z is not complete; fill in every field.</source>
        <translation>L&apos;écart-type du LiDAR selon X, Y et Z n&apos;est pas complet ; remplissez tous les champs.</translation>
    </message>
    <message>
        <source>The LiDAR sigma of range and angle is not complete; fill in every field.</source>
        <translation>L&apos;écart-type du LiDAR en distance et en angle n&apos;est pas complet ; remplissez tous les champs.</translation>
    </message>
    <message>
        <source>Correlation time of the position error of the POS, seconds</source>
        <translation>Temps de corrélation de l&apos;erreur de position du POS, en secondes</translation>
    </message>
    <message>
        <source>Correlation time of the attitude error of the POS, seconds</source>
        <translation>Temps de corrélation de l&apos;erreur d&apos;attitude du POS, en secondes</translation>
    </message>
    <message>
        <source>{tip}, in {unit}</source>
        <translation>{tip}, en {unit}</translation>
    </message>
    <message>
        <source>{tip}, in {unit}. Empty: {empty}.</source>
        <translation>{tip}, en {unit}. Vide : {empty}.</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>The value it starts from</source>
        <translation>La valeur de départ</translation>
    </message>
    <message>
        <source>How well that value is known</source>
        <translation>Avec quelle précision cette valeur est connue</translation>
    </message>
    <message>
        <source>Scan angle</source>
        <translation>Angle de balayage</translation>
    </message>
    <message>
        <source>scan angle</source>
        <translation>angle de balayage</translation>
    </message>
    <message>
        <source>added to every range</source>
        <translation>ajouté à chaque distance</translation>
    </message>
    <message>
        <source>turns every beam about the scanner&apos;s X axis</source>
        <translation>tourne chaque faisceau autour de l&apos;axe X du scanneur</translation>
    </message>
    <message>
        <source>added to the time of every point before the trajectory is asked</source>
        <translation>ajoutée au temps de chaque point avant de consulter la trajectoire</translation>
    </message>
    <message>
        <source>Estimate the {name} too ({tip})</source>
        <translation>Estimer aussi : {name} ({tip})</translation>
    </message>
    <message>
        <source>Prior sigma of the {name}</source>
        <translation>Écart-type a priori : {name}</translation>
    </message>
    <message>
        <source>How well the prior {name} is known, one standard deviation</source>
        <translation>Avec quelle précision la valeur a priori est connue ({name}), un écart-type</translation>
    </message>
    <message>
        <source>Lever arm X as typed in step 1</source>
        <translation>Bras de levier X tel que saisi à l&apos;étape 1</translation>
    </message>
    <message>
        <source>Lever arm Y as typed in step 1</source>
        <translation>Bras de levier Y tel que saisi à l&apos;étape 1</translation>
    </message>
    <message>
        <source>Lever arm Z as typed in step 1</source>
        <translation>Bras de levier Z tel que saisi à l&apos;étape 1</translation>
    </message>
    <message>
        <source>{name} as it is known: {tip}; used where not estimated too</source>
        <translation>{name}, valeur connue : {tip} ; employée aussi sans estimation</translation>
    </message>
    <message>
        <source>left</source>
        <translation>gauche</translation>
    </message>
    <message>
        <source>{what}: “{text:kept}” is not a number; give {unit}.</source>
        <translation>{what} : « {text} » n&apos;est pas un nombre ; donnez des {unit}.</translation>
    </message>
</context>
<context>
    <name>validate panel</name>
    <message>
        <source>Local plane</source>
        <translation>Plan local</translation>
    </message>
    <message>
        <source>Local quadric</source>
        <translation>Quadrique locale</translation>
    </message>
    <message>
        <source>Nearest point</source>
        <translation>Point le plus proche</translation>
    </message>
    <message>
        <source>The lines are compared with each other, cloud to cloud, on planes not used in the adjustment.</source>
        <translation>Les lignes sont comparées entre elles, nuage à nuage, sur des plans non utilisés dans la compensation.</translation>
    </message>
    <message>
        <source>What stands for the surface between the points of a line. A plane suits walls and boards, a quadric what bends; to the nearest point the spacing of the points counts as distance</source>
        <translation>Ce qui représente la surface entre les points d&apos;une ligne. Un plan convient aux murs et aux panneaux, une quadrique à ce qui est courbe ; au point le plus proche, l&apos;espacement des points compte comme distance</translation>
    </message>
    <message>
        <source>Points the plane or quadric is fitted to: more smooth the noise, fewer follow the surface (usually 6, 12 for a quadric)</source>
        <translation>Points auxquels le plan ou la quadrique est ajusté : plus lissent le bruit, moins suivent la surface (d&apos;ordinaire 6, 12 pour une quadrique)</translation>
    </message>
    <message>
        <source>Distance to</source>
        <translation>Distance à</translation>
    </message>
    <message>
        <source>Through points</source>
        <translation>Points ajustés</translation>
    </message>
    <message>
        <source>Compare the lines on every validation plane, before and after (F10)</source>
        <translation>Comparer les lignes sur chaque plan de validation, avant et après (F10)</translation>
    </message>
    <message>
        <source>Lines in the view</source>
        <translation>Lignes dans la vue 3D</translation>
    </message>
    <message>
        <source>Lines placed with the prior boresight</source>
        <translation>Lignes placées avec les angles de visée a priori</translation>
    </message>
    <message>
        <source>Lines placed with the estimated boresight</source>
        <translation>Lignes placées avec les angles de visée estimés</translation>
    </message>
</context>
<context>
    <name>report panel</name>
    <message>
        <source>Export report…</source>
        <translation>Exporter le rapport…</translation>
    </message>
    <message>
        <source>PDF, HTML, JSON or tables (CSV in a ZIP); pictures of the view before and after go into it (Ctrl+E)</source>
        <translation>PDF, HTML, JSON ou tableaux (CSV dans un ZIP) ; des images de la vue 3D avant et après y sont incluses (Ctrl+E)</translation>
    </message>
    <message>
        <source>Look at the pages as they will be printed, and save them as PDF</source>
        <translation>Regarder les pages telles qu&apos;elles seront imprimées, et les enregistrer en PDF</translation>
    </message>
    <message>
        <source>Export georeferenced lines…</source>
        <translation>Exporter les lignes géoréférencées…</translation>
    </message>
    <message>
        <source>Every line as LAZ or LAS in a coordinate system of your choice (Ctrl+Shift+E)</source>
        <translation>Chaque ligne en LAZ ou LAS dans le système de coordonnées de votre choix (Ctrl+Maj+E)</translation>
    </message>
    <message>
        <source>Size of the paper</source>
        <translation>Format du papier</translation>
    </message>
    <message>
        <source>Language of the report; numbers keep their decimal point, JSON stays English</source>
        <translation>Langue du rapport ; les nombres gardent le point décimal, le JSON reste en anglais</translation>
    </message>
    <message>
        <source>Same as window</source>
        <translation>Comme la fenêtre</translation>
    </message>
    <message>
        <source>Also state the boresight as another program has it</source>
        <translation>Donner aussi les angles de visée tels que les veut un autre logiciel</translation>
    </message>
    <message>
        <source>TOML file with logo, company, own texts, page, convention and language</source>
        <translation>Fichier TOML avec logo, entreprise, textes propres, page, convention et langue</translation>
    </message>
    <message>
        <source>Use no template</source>
        <translation>N&apos;employer aucun modèle</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Page</translation>
    </message>
    <message>
        <source>Also give angles for</source>
        <translation>Donner aussi les angles pour</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>Without</source>
        <translation>Sans</translation>
    </message>
</context>
<context>
    <name>results</name>
    <message>
        <source>The boresight turns the LiDAR frame into the body frame (forward, left, up):</source>
        <translation>Les angles de visée font passer du repère du LiDAR à celui du navire (avant, gauche, haut) :</translation>
    </message>
    <message>
        <source>&lt;b&gt;R = R&lt;sub&gt;z&lt;/sub&gt;(−yaw) · R&lt;sub&gt;y&lt;/sub&gt;(pitch) · R&lt;sub&gt;x&lt;/sub&gt;(roll)&lt;/b&gt;</source>
        <translation>&lt;b&gt;R = R&lt;sub&gt;z&lt;/sub&gt;(−lacet) · R&lt;sub&gt;y&lt;/sub&gt;(tangage) · R&lt;sub&gt;x&lt;/sub&gt;(roulis)&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Roll is positive left side up, pitch positive bow down, yaw positive clockwise seen from above.</source>
        <translation>Le roulis est positif quand bâbord monte, le tangage quand l&apos;étrave descend, le lacet dans le sens horaire vu d&apos;en haut.</translation>
    </message>
    <message>
        <source>Nothing estimated yet. Pick at least two targets that face different ways, then press Estimate in step 3. Roll, pitch and yaw appear here with their uncertainties.</source>
        <translation>Rien n&apos;est encore estimé. Désignez au moins deux cibles d&apos;orientations différentes, puis cliquez sur Estimer à l&apos;étape 3. Roulis, tangage et lacet apparaissent ici avec leurs incertitudes.</translation>
    </message>
    <message>
        <source>Estimating again; the figures below are those from before the change.</source>
        <translation>Nouvelle estimation en cours ; les chiffres ci-dessous sont ceux d&apos;avant la modification.</translation>
    </message>
    <message>
        <source>Estimating …</source>
        <translation>Estimation en cours…</translation>
    </message>
    <message>
        <source>Boresight, degrees</source>
        <translation>Angles de visée, degrés</translation>
    </message>
    <message>
        <source>Rotation matrix, LiDAR to body (forward, left, up):</source>
        <translation>Matrice de rotation, LiDAR vers navire (avant, gauche, haut) :</translation>
    </message>
    <message>
        <source>Simulated survey: the truth is known. Green lies within the 95 % interval.</source>
        <translation>Levé simulé : la vérité est connue. En vert, ce qui est dans l&apos;intervalle à 95 %.</translation>
    </message>
    <message>
        <source>Also estimated</source>
        <translation>Estimé aussi</translation>
    </message>
    <message>
        <source>Weakest direction</source>
        <translation>Direction la moins bien déterminée</translation>
    </message>
    <message>
        <source>Not worked out.</source>
        <translation>Non calculé.</translation>
    </message>
    <message>
        <source>RMS point-to-plane</source>
        <translation>RMS point-plan</translation>
    </message>
    <message>
        <source>Chi-square test</source>
        <translation>Test du khi-deux</translation>
    </message>
    <message>
        <source>Points, sightings</source>
        <translation>Points, observations</translation>
    </message>
    <message>
        <source>Iterations, time</source>
        <translation>Itérations, temps</translation>
    </message>
    <message>
        <source>Convention</source>
        <translation>Convention</translation>
    </message>
    <message>
        <source>{before:n} → &lt;b&gt;{after:n} mm&lt;/b&gt;</source>
        <translation>{before} → &lt;b&gt;{after} mm&lt;/b&gt;</translation>
    </message>
    <message>
        <source>{iterations:n}, {time:n} s</source>
        <translation>{iterations}, {time} s</translation>
    </message>
    <message>
        <source>uncorrelated (classical)</source>
        <translation>non corrélées (classique)</translation>
    </message>
    <message>
        <source>correlated, {a:n} s and {b:n} s</source>
        <translation>corrélées, {a} s et {b} s</translation>
    </message>
    <message>
        <source>Where the adjustment started</source>
        <translation>D&apos;où la compensation est partie</translation>
    </message>
    <message>
        <source>The adjusted boresight</source>
        <translation>Les angles de visée compensés</translation>
    </message>
    <message>
        <source>One standard deviation</source>
        <translation>Un écart-type</translation>
    </message>
    <message>
        <source>Half width of the 95 % interval: 1.96 σ</source>
        <translation>Demi-largeur de l&apos;intervalle à 95 % : 1,96 σ</translation>
    </message>
    <message>
        <source>What the simulator put in</source>
        <translation>Ce que le simulateur a mis</translation>
    </message>
    <message>
        <source>Truth</source>
        <translation>Vérité</translation>
    </message>
    <message>
        <source>± 1 σ</source>
        <translation>± 1 σ</translation>
    </message>
    <message>
        <source>Estimated minus truth: {n:n}°, inside the 95 % interval</source>
        <translation>Estimé moins vérité : {n}°, dans l&apos;intervalle à 95 %</translation>
    </message>
    <message>
        <source>Estimated minus truth: {n:n}°, outside the 95 % interval</source>
        <translation>Estimé moins vérité : {n}°, hors de l&apos;intervalle à 95 %</translation>
    </message>
    <message>
        <source>These two angles are hardly told apart: add a target that faces elsewhere</source>
        <translation>Ces deux angles se distinguent à peine : ajoutez une cible orientée autrement</translation>
    </message>
    <message>
        <source>angles table</source>
        <translation>tableau des angles</translation>
    </message>
    <message>
        <source>correlation table</source>
        <translation>tableau des corrélations</translation>
    </message>
    <message>
        <source>Leave a sighting out if its points are of another surface.</source>
        <translation>Écartez une observation si ses points sont d&apos;une autre surface.</translation>
    </message>
    <message>
        <source>See the cross-checks under Diagnostics.</source>
        <translation>Voyez les vérifications croisées sous Diagnostics.</translation>
    </message>
    <message>
        <source>not detected</source>
        <translation>non détecté</translation>
    </message>
    <message>
        <source>held at 0</source>
        <translation>fixé à 0</translation>
    </message>
    <message>
        <source>1 outlier</source>
        <translation>1 point aberrant</translation>
    </message>
    <message>
        <source>{n:n} outliers</source>
        <translation>{n} points aberrants</translation>
    </message>
    <message>
        <source>{words} Errors by the data: {components}.</source>
        <translation>{words} Erreurs d&apos;après les données : {components}.</translation>
    </message>
    <message>
        <source>&lt;b style=&quot;{style:kept}&quot;&gt;passed&lt;/b&gt;: {n:n} in [{a:n}, {b:n}]</source>
        <translation>&lt;b style=&quot;{style}&quot;&gt;réussi&lt;/b&gt; : {n} dans [{a} ; {b}]</translation>
    </message>
    <message>
        <source>&lt;b style=&quot;{style:kept}&quot;&gt;failed&lt;/b&gt;: {n:n} not in [{a:n}, {b:n}]</source>
        <translation>&lt;b style=&quot;{style}&quot;&gt;échoué&lt;/b&gt; : {n} hors de [{a} ; {b}]</translation>
    </message>
</context>
<context>
    <name>diagnostics</name>
    <message>
        <source>Pages of the diagnostics</source>
        <translation>Pages des diagnostics</translation>
    </message>
    <message>
        <source>Estimating again; these are the figures from before the change.</source>
        <translation>Nouvelle estimation en cours ; ces chiffres sont ceux d&apos;avant la modification.</translation>
    </message>
    <message>
        <source>Nothing estimated yet: press Estimate in step 3, and the way of each angle to its last value appears here.</source>
        <translation>Rien n&apos;est encore estimé : cliquez sur Estimer à l&apos;étape 3, et le chemin de chaque angle vers sa dernière valeur apparaîtra ici.</translation>
    </message>
    <message>
        <source>Nothing estimated yet: press Estimate in step 3, and the correlations between all estimated values appear here.</source>
        <translation>Rien n&apos;est encore estimé : cliquez sur Estimer à l&apos;étape 3, et les corrélations entre toutes les valeurs estimées apparaîtront ici.</translation>
    </message>
    <message>
        <source>Nothing estimated yet: press Estimate in step 3, and the estimated POS error of each sighting appears, against its prior sigma, here.</source>
        <translation>Rien n&apos;est encore estimé : cliquez sur Estimer à l&apos;étape 3, et l&apos;erreur du POS estimée pour chaque observation apparaîtra ici, face à son écart-type a priori.</translation>
    </message>
    <message>
        <source>Nothing estimated yet: press Estimate in step 3, and how well lines and targets see the angles appears here.</source>
        <translation>Rien n&apos;est encore estimé : cliquez sur Estimer à l&apos;étape 3, et vous verrez ici combien les lignes et les cibles voient les angles.</translation>
    </message>
    <message>
        <source>Nothing estimated yet: press Estimate in step 3, and the residuals and tests of every sighting appear here.</source>
        <translation>Rien n&apos;est encore estimé : cliquez sur Estimer à l&apos;étape 3, et les résidus et tests de chaque observation apparaîtront ici.</translation>
    </message>
    <message>
        <source>Nothing estimated yet: press Estimate in step 3, and the residuals of every target appear here.</source>
        <translation>Rien n&apos;est encore estimé : cliquez sur Estimer à l&apos;étape 3, et les résidus de chaque cible apparaîtront ici.</translation>
    </message>
    <message>
        <source>Nothing estimated yet: press Estimate in step 3, and every estimated value appears with its prior and its significance here.</source>
        <translation>Rien n&apos;est encore estimé : cliquez sur Estimer à l&apos;étape 3, et chaque valeur estimée apparaîtra ici avec sa valeur a priori et sa signification.</translation>
    </message>
    <message>
        <source>Nothing estimated yet: press Estimate in step 3, and what parts of the data say by themselves appears here.</source>
        <translation>Rien n&apos;est encore estimé : cliquez sur Estimer à l&apos;étape 3, et ce que disent séparément des parties des données apparaîtra ici.</translation>
    </message>
    <message>
        <source>Not available with uncorrelated POS errors. Choose “Correlated in time” in step 3 and estimate.</source>
        <translation>Indisponible avec des erreurs du POS non corrélées. Choisissez « Corrélées dans le temps » à l&apos;étape 3 et estimez.</translation>
    </message>
    <message>
        <source>Convergence</source>
        <translation>Convergence</translation>
    </message>
    <message>
        <source>POS error</source>
        <translation>Erreur du POS</translation>
    </message>
    <message>
        <source>Observability</source>
        <translation>Observabilité</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Paramètre</translation>
    </message>
    <message>
        <source>The adjustment took one iteration: nothing to plot.</source>
        <translation>La compensation a pris une seule itération : rien à tracer.</translation>
    </message>
    <message>
        <source>Not worked out: press Estimate for it.</source>
        <translation>Non calculé : cliquez sur Estimer pour l&apos;avoir.</translation>
    </message>
    <message>
        <source>Condition number {n:n}: the strongest direction is known {times:n} times as well as the weakest.</source>
        <translation>Conditionnement {n} : la direction la mieux déterminée est connue {times} fois mieux que la moins bien déterminée.</translation>
    </message>
    <message>
        <source>The formal sigma, and the spread of the answers when one line, or one target, at a time is left out; it needs three parts at least that each give an answer</source>
        <translation>L&apos;écart-type formel, et la dispersion des réponses quand une ligne, ou une cible, est écartée à la fois ; il faut au moins trois parties qui donnent chacune une réponse</translation>
    </message>
    <message>
        <source>Not cross-checked. Tick “Cross-check” in step 3 and press Estimate; after that it follows each tick in the table by itself, a moment after the angles.</source>
        <translation>Sans vérifications croisées. Cochez « Vérifier avec des parties des données » à l&apos;étape 3 et cliquez sur Estimer ; elles suivent ensuite d&apos;elles-mêmes chaque coche du tableau, un instant après les angles.</translation>
    </message>
    <message>
        <source>Click to sort</source>
        <translation>Cliquer pour trier</translation>
    </message>
    <message>
        <source>Double click, or Enter, goes to its points in the view</source>
        <translation>Double-clic, ou Entrée, mène à ses points dans la vue 3D</translation>
    </message>
    <message>
        <source>Points that took part, after averaging or thinning</source>
        <translation>Points qui ont pris part, après moyenne ou éclaircissement</translation>
    </message>
    <message>
        <source>RMS distance to the surface with the prior boresight, mm</source>
        <translation>Distance RMS à la surface avec les angles de visée a priori, mm</translation>
    </message>
    <message>
        <source>RMS distance to the adjusted surface, mm; no POS error is taken off</source>
        <translation>Distance RMS à la surface compensée, mm ; aucune erreur du POS n&apos;est retirée</translation>
    </message>
    <message>
        <source>RMS distance to its best surface with the prior boresight, mm</source>
        <translation>Distance RMS à sa meilleure surface avec les angles de visée a priori, mm</translation>
    </message>
    <message>
        <source>RMS distance to the adjusted surface, mm</source>
        <translation>Distance RMS à la surface compensée, mm</translation>
    </message>
    <message>
        <source>By how much the sighting as a whole lies off what all others say, mm</source>
        <translation>De combien l&apos;observation entière s&apos;écarte de ce que disent toutes les autres, mm</translation>
    </message>
    <message>
        <source>The shift over its standard deviation (Baarda&apos;s test)</source>
        <translation>L&apos;écart rapporté à son écart-type (test de Baarda)</translation>
    </message>
    <message>
        <source>Smallest shift the test finds with 80 % power, mm</source>
        <translation>Plus petit écart que le test trouve avec une puissance de 80 %, mm</translation>
    </message>
    <message>
        <source>Largest change of an angle by a shift of that size that stays unfound, 0.001°</source>
        <translation>Plus grande variation d&apos;un angle par un écart de cette taille resté inaperçu, 0,001°</translation>
    </message>
    <message>
        <source>Points whose own test is beyond 3.29</source>
        <translation>Points dont le propre test dépasse 3,29</translation>
    </message>
    <message>
        <source>Test value of the point farthest off, by its sigma, and its time in the line, s; of an average of points, the mean of their times</source>
        <translation>Valeur de test du point le plus écarté, selon son sigma, et son temps dans la ligne, s ; pour une moyenne de points, la moyenne de leurs temps</translation>
    </message>
    <message>
        <source>Mean of the points&apos; redundancy numbers, 0 (unchecked) to 1</source>
        <translation>Moyenne des redondances des points, de 0 (non contrôlé) à 1</translation>
    </message>
    <message>
        <source>Estimated position error and its prior sigma, mm (3D length)</source>
        <translation>Erreur de position estimée et son écart-type a priori, mm (longueur 3D)</translation>
    </message>
    <message>
        <source>Estimated attitude error and its prior sigma, 0.001° (3D length)</source>
        <translation>Erreur d&apos;attitude estimée et son écart-type a priori, 0,001° (longueur 3D)</translation>
    </message>
    <message>
        <source>What to look at</source>
        <translation>Ce qu&apos;il faut regarder</translation>
    </message>
    <message>
        <source>Plane or sphere</source>
        <translation>Plan ou sphère</translation>
    </message>
    <message>
        <source>Lines it was seen on</source>
        <translation>Lignes où elle a été vue</translation>
    </message>
    <message>
        <source>Noise found in the residuals over the stated one, at least 1</source>
        <translation>Bruit trouvé dans les résidus rapporté au bruit déclaré, au moins 1</translation>
    </message>
    <message>
        <source>Largest test value of its sightings</source>
        <translation>Plus grande valeur de test de ses observations</translation>
    </message>
    <message>
        <source>Detectable</source>
        <translation>Décelable</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>Effet</translation>
    </message>
    <message>
        <source>(mm)</source>
        <translation>(mm)</translation>
    </message>
    <message>
        <source>(0.001°)</source>
        <translation>(0,001°)</translation>
    </message>
    <message>
        <source>(deg)</source>
        <translation>(°)</translation>
    </message>
    <message>
        <source>(cm)</source>
        <translation>(cm)</translation>
    </message>
    <message>
        <source>(m)</source>
        <translation>(m)</translation>
    </message>
    <message>
        <source>(s)</source>
        <translation>(s)</translation>
    </message>
    <message>
        <source>(sigmas)</source>
        <translation>(sigmas)</translation>
    </message>
    <message>
        <source>Largest point w</source>
        <translation>Plus grand w d&apos;un point</translation>
    </message>
    <message>
        <source>Noise factor</source>
        <translation>Facteur de bruit</translation>
    </message>
    <message>
        <source>Difference from the answer of all points, or between the halves, degrees</source>
        <translation>Différence avec la réponse de tous les points, ou entre les moitiés, en degrés</translation>
    </message>
    <message>
        <source>Part of the data</source>
        <translation>Partie des données</translation>
    </message>
    <message>
        <source>What was left out, or which halves were compared</source>
        <translation>Ce qui a été écarté, ou quelles moitiés ont été comparées</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>différence</translation>
    </message>
    <message>
        <source>in σ</source>
        <translation>en σ</translation>
    </message>
    <message>
        <source>Roll difference (deg)</source>
        <translation>Différence de roulis (°)</translation>
    </message>
    <message>
        <source>Pitch difference (deg)</source>
        <translation>Différence de tangage (°)</translation>
    </message>
    <message>
        <source>Yaw difference (deg)</source>
        <translation>Différence de lacet (°)</translation>
    </message>
    <message>
        <source>The difference over the standard deviation it should have</source>
        <translation>La différence rapportée à l&apos;écart-type qu&apos;elle devrait avoir</translation>
    </message>
    <message>
        <source>Whether it agrees, or why there is no answer</source>
        <translation>Si elle concorde, ou pourquoi il n&apos;y a pas de réponse</translation>
    </message>
    <message>
        <source>Why there is no answer, or what disagrees</source>
        <translation>Pourquoi il n&apos;y a pas de réponse, ou ce qui est en désaccord</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Raison</translation>
    </message>
    <message>
        <source>Value of the mounting</source>
        <translation>Grandeur du montage</translation>
    </message>
    <message>
        <source>As estimated</source>
        <translation>Valeur estimée</translation>
    </message>
    <message>
        <source>Standard deviation of the value</source>
        <translation>Écart-type de la valeur</translation>
    </message>
    <message>
        <source>What went in</source>
        <translation>Ce qui est entré</translation>
    </message>
    <message>
        <source>Prior σ</source>
        <translation>σ a priori</translation>
    </message>
    <message>
        <source>How well that was said to be known</source>
        <translation>Avec quelle précision elle était dite connue</translation>
    </message>
    <message>
        <source>Change from the prior over its standard deviation; significant beyond {n:n}, which chance exceeds one time in twenty</source>
        <translation>Variation depuis la valeur a priori, rapportée à son écart-type ; significative au-delà de {n}, ce que le hasard dépasse une fois sur vingt</translation>
    </message>
    <message>
        <source>Whether it earns its place, or why there is no number</source>
        <translation>Si elle est justifiée, ou pourquoi il n&apos;y a pas de nombre</translation>
    </message>
    <message>
        <source>no test</source>
        <translation>sans test</translation>
    </message>
    <message>
        <source>released: disagrees</source>
        <translation>écartée : en désaccord</translation>
    </message>
    <message>
        <source>w beyond {n:n}</source>
        <translation>w au-delà de {n}</translation>
    </message>
    <message>
        <source>many outliers</source>
        <translation>beaucoup de points aberrants</translation>
    </message>
    <message>
        <source>{w:n} at {time:n} s</source>
        <translation>{w} à {time} s</translation>
    </message>
    <message>
        <source>{n:n} (σ {prior:n})</source>
        <translation>{n} (σ {prior})</translation>
    </message>
    <message>
        <source>rougher than stated</source>
        <translation>plus rugueuse que déclaré</translation>
    </message>
    <message>
        <source>released on {lines:list}</source>
        <translation>écartée sur {lines}</translation>
    </message>
    <message>
        <source>An angle differs by more than chance explains</source>
        <translation>Un angle diffère plus que le hasard ne l&apos;explique</translation>
    </message>
    <message>
        <source>1 σ, degrees</source>
        <translation>1 σ, degrés</translation>
    </message>
    <message>
        <source>&lt;b&gt;1 σ, degrees&lt;/b&gt;</source>
        <translation>&lt;b&gt;1 σ, degrés&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Roll&lt;/b&gt;</source>
        <translation>&lt;b&gt;Roulis&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Pitch&lt;/b&gt;</source>
        <translation>&lt;b&gt;Tangage&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Yaw&lt;/b&gt;</source>
        <translation>&lt;b&gt;Lacet&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Formal sigma</source>
        <translation>Écart-type formel</translation>
    </message>
    <message>
        <source>Spread,</source>
        <translation>Dispersion,</translation>
    </message>
    <message>
        <source>one line left out</source>
        <translation>une ligne écartée</translation>
    </message>
    <message>
        <source>one target left out</source>
        <translation>une cible écartée</translation>
    </message>
    <message>
        <source>always estimated</source>
        <translation>toujours estimé</translation>
    </message>
    <message>
        <source>significant: keep it</source>
        <translation>significatif : à garder</translation>
    </message>
    <message>
        <source>not significant: can be left out</source>
        <translation>non significatif : peut être omis</translation>
    </message>
    <message>
        <source>smallest sigma</source>
        <translation>plus petit sigma</translation>
    </message>
    <message>
        <source>Iteration</source>
        <translation>Itération</translation>
    </message>
    <message>
        <source>From last value, °</source>
        <translation>Depuis la dernière valeur, °</translation>
    </message>
    <message>
        <source>Position, mm</source>
        <translation>Position, mm</translation>
    </message>
    <message>
        <source>Attitude, 0.001°</source>
        <translation>Attitude, 0,001°</translation>
    </message>
    <message>
        <source>prior ± 2 σ</source>
        <translation>a priori ± 2 σ</translation>
    </message>
    <message>
        <source>weakest</source>
        <translation>la moins bonne</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>moyenne</translation>
    </message>
    <message>
        <source>strongest</source>
        <translation>la meilleure</translation>
    </message>
    <message>
        <source>Share of each angle in the direction, %</source>
        <translation>Part de chaque angle dans la direction, %</translation>
    </message>
    <message>
        <source>{angle}  {n:n}°</source>
        <translation>{angle}  {n}°</translation>
    </message>
    <message>
        <source>σ {n:n}°</source>
        <translation>σ {n}°</translation>
    </message>
    <message>
        <source>Shift (mm)</source>
        <translation>Écart (mm)</translation>
    </message>
    <message>
        <source>Detectable (mm)</source>
        <translation>Décelable (mm)</translation>
    </message>
    <message>
        <source>Effect (0.001°)</source>
        <translation>Effet (0,001°)</translation>
    </message>
    <message>
        <source>POS position (mm)</source>
        <translation>Position du POS (mm)</translation>
    </message>
    <message>
        <source>POS attitude (0.001°)</source>
        <translation>Attitude du POS (0,001°)</translation>
    </message>
    <message>
        <source>Roll
difference (deg)</source>
        <translation>Différence
de roulis (°)</translation>
    </message>
    <message>
        <source>Pitch
difference (deg)</source>
        <translation>Différence
de tangage (°)</translation>
    </message>
    <message>
        <source>Yaw
difference (deg)</source>
        <translation>Différence
de lacet (°)</translation>
    </message>
    <message>
        <source>Position
σ, m</source>
        <translation>Position
σ, m</translation>
    </message>
    <message>
        <source>Attitude
σ, °</source>
        <translation>Attitude
σ, °</translation>
    </message>
    <message>
        <source>Speed
m/s</source>
        <translation>Vitesse
m/s</translation>
    </message>
    <message>
        <source>Roll, pitch
°</source>
        <translation>Roulis, tangage
°</translation>
    </message>
    <message>
        <source>Heading
°</source>
        <translation>Cap
°</translation>
    </message>
</context>
<context>
    <name>histograms and pairs</name>
    <message>
        <source>Distances between points of one line and the surface of another</source>
        <translation>Distances entre les points d&apos;une ligne et la surface d&apos;une autre</translation>
    </message>
    <message>
        <source>Median distance, millimetres, before → after</source>
        <translation>Distance médiane, en millimètres, avant → après</translation>
    </message>
    <message>
        <source>Root mean square distance, millimetres, before → after</source>
        <translation>Distance quadratique moyenne, en millimètres, avant → après</translation>
    </message>
    <message>
        <source>95 % of the distances are smaller, millimetres, before → after</source>
        <translation>95 % des distances sont plus petites, en millimètres, avant → après</translation>
    </message>
    <message>
        <source>RMS (mm)</source>
        <translation>RMS (mm)</translation>
    </message>
    <message>
        <source>n</source>
        <translation>n</translation>
    </message>
    <message>
        <source>{a:n} → {b:n} mm</source>
        <translation>{a} → {b} mm</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>Histogramme</translation>
    </message>
    <message>
        <source>Histogram, shares</source>
        <translation>Histogramme, parts</translation>
    </message>
    <message>
        <source>Against height and range</source>
        <translation>Selon la hauteur et la distance</translation>
    </message>
    <message>
        <source>Wheel: closer or farther; drag: move; double click: all of it</source>
        <translation>Molette : plus près ou plus loin ; glisser : déplacer ; double-clic : tout montrer</translation>
    </message>
    <message>
        <source>No comparison yet. Pick validation planes, estimate, then press Validate in step 4: the distances between the lines before and after appear here.</source>
        <translation>Pas encore de comparaison. Désignez des plans de validation, estimez, puis cliquez sur Valider à l&apos;étape 4 : les distances entre les lignes avant et après apparaissent ici.</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Plans</translation>
    </message>
    <message>
        <source>Pairs of lines</source>
        <translation>Paires de lignes</translation>
    </message>
    <message>
        <source>What is drawn of the plane: how often each distance occurs, which share of the points has it, or how the distances grow with height and range (before a calibration they do, after it they should not)</source>
        <translation>Ce qui est dessiné du plan : combien de fois chaque distance se présente, quelle part des points l&apos;a, ou comment les distances croissent avec la hauteur et la distance au scanneur (avant un étalonnage elles croissent, après elles ne devraient pas)</translation>
    </message>
    <message>
        <source>Copy the plot as it is shown to the clipboard</source>
        <translation>Copier le graphique tel qu&apos;il est montré dans le presse-papiers</translation>
    </message>
    <message>
        <source>Copy what the plot is drawn from to the clipboard, as a table for a spreadsheet</source>
        <translation>Copier les données du graphique dans le presse-papiers, comme tableau pour un tableur</translation>
    </message>
    <message>
        <source>{plane:name}: all pairs of lines, {model}</source>
        <translation>{plane} : toutes les paires de lignes, {model}</translation>
    </message>
    <message>
        <source>Pairs of lines on {plane:kept}</source>
        <translation>Paires de lignes sur {plane}</translation>
    </message>
    <message>
        <source>Distances on {plane:kept}, {plot}, before in blue and after in brown</source>
        <translation>Distances sur {plane}, {plot}, avant en bleu et après en brun</translation>
    </message>
    <message>
        <source>histogram</source>
        <translation>histogramme</translation>
    </message>
    <message>
        <source>histogram, shares</source>
        <translation>histogramme, parts</translation>
    </message>
    <message>
        <source>against height and range</source>
        <translation>selon la hauteur et la distance</translation>
    </message>
    <message>
        <source>The picture is in the clipboard</source>
        <translation>L&apos;image est dans le presse-papiers</translation>
    </message>
    <message>
        <source>The numbers are in the clipboard, ready for a spreadsheet</source>
        <translation>Les nombres sont dans le presse-papiers, prêts pour un tableur</translation>
    </message>
    <message>
        <source>Validation planes before and after</source>
        <translation>Plans de validation avant et après</translation>
    </message>
    <message>
        <source>{reach}: before {a:n} points ({b:n} % up to here), after {c:n} points ({d:n} % up to here)</source>
        <translation>{reach} : avant {a} points ({b} % jusqu&apos;ici), après {c} points ({d} % jusqu&apos;ici)</translation>
    </message>
    <message>
        <source>{a:n} mm and beyond</source>
        <translation>{a} mm et au-delà</translation>
    </message>
    <message>
        <source>{a:n}–{b:n} mm</source>
        <translation>{a}–{b} mm</translation>
    </message>
    <message>
        <source>height {a:n}–{b:n} m</source>
        <translation>hauteur {a}–{b} m</translation>
    </message>
    <message>
        <source>range {a:n}–{b:n} m</source>
        <translation>distance au scanneur {a}–{b} m</translation>
    </message>
    <message>
        <source>{reach}: {n:n} distances, too few</source>
        <translation>{reach} : {n} distances, trop peu</translation>
    </message>
    <message>
        <source>{reach}: median {a:n} → {b:n} mm, 95 % {c:n} → {d:n} mm, {n:n} distances</source>
        <translation>{reach} : médiane {a} → {b} mm, 95 % {c} → {d} mm, {n} distances</translation>
    </message>
    <message>
        <source>The two lines; ⇄ where they were run in opposite directions</source>
        <translation>Les deux lignes ; ⇄ si elles ont été parcourues en sens opposés</translation>
    </message>
    <message>
        <source>Distances, both directions together</source>
        <translation>Distances, les deux sens ensemble</translation>
    </message>
    <message>
        <source>Off before (mm)</source>
        <translation>Écart avant (mm)</translation>
    </message>
    <message>
        <source>Off after (mm)</source>
        <translation>Écart après (mm)</translation>
    </message>
    <message>
        <source>Off before</source>
        <translation>Écart avant</translation>
    </message>
    <message>
        <source>Off after</source>
        <translation>Écart après</translation>
    </message>
    <message>
        <source>Plane off before (mm)</source>
        <translation>Écart du plan avant (mm)</translation>
    </message>
    <message>
        <source>Plane off after (mm)</source>
        <translation>Écart du plan après (mm)</translation>
    </message>
    <message>
        <source>Plane off before</source>
        <translation>Écart du plan avant</translation>
    </message>
    <message>
        <source>Plane off after</source>
        <translation>Écart du plan après</translation>
    </message>
    <message>
        <source>Turned before (deg)</source>
        <translation>Tourné avant (°)</translation>
    </message>
    <message>
        <source>Turned after (deg)</source>
        <translation>Tourné après (°)</translation>
    </message>
    <message>
        <source>Turned before</source>
        <translation>Tourné avant</translation>
    </message>
    <message>
        <source>Turned after</source>
        <translation>Tourné après</translation>
    </message>
    <message>
        <source>Root mean square distance between the lines, before the calibration</source>
        <translation>Distance quadratique moyenne entre les lignes, avant l&apos;étalonnage</translation>
    </message>
    <message>
        <source>Root mean square distance between the lines, after the calibration</source>
        <translation>Distance quadratique moyenne entre les lignes, après l&apos;étalonnage</translation>
    </message>
    <message>
        <source>How far the first line lies off the second along the normal, in the median of places (M3C2), positive towards the vessel, before the calibration</source>
        <translation>De combien la première ligne s&apos;écarte de la seconde le long de la normale, en médiane des endroits (M3C2), positif vers le navire, avant l&apos;étalonnage</translation>
    </message>
    <message>
        <source>How far the first line lies off the second along the normal, in the median of places (M3C2), positive towards the vessel, after the calibration</source>
        <translation>De combien la première ligne s&apos;écarte de la seconde le long de la normale, en médiane des endroits (M3C2), positif vers le navire, après l&apos;étalonnage</translation>
    </message>
    <message>
        <source>The first line&apos;s plane off the second&apos;s, positive towards the vessel, before the calibration</source>
        <translation>Écart du plan de la première ligne à celui de la seconde, positif vers le navire, avant l&apos;étalonnage</translation>
    </message>
    <message>
        <source>The first line&apos;s plane off the second&apos;s, positive towards the vessel, after the calibration</source>
        <translation>Écart du plan de la première ligne à celui de la seconde, positif vers le navire, après l&apos;étalonnage</translation>
    </message>
    <message>
        <source>Angle between the planes of the two lines, before the calibration</source>
        <translation>Angle entre les plans des deux lignes, avant l&apos;étalonnage</translation>
    </message>
    <message>
        <source>Angle between the planes of the two lines, after the calibration</source>
        <translation>Angle entre les plans des deux lignes, après l&apos;étalonnage</translation>
    </message>
    <message>
        <source>Pairs of lines before and after</source>
        <translation>Paires de lignes avant et après</translation>
    </message>
    <message>
        <source>After: at {n:n} places the 95 % interval of one is ± {a:n} mm; {b:n} % of them differ from zero.</source>
        <translation>Après : à {n} endroits, l&apos;intervalle à 95 % de l&apos;un est de ± {a} mm ; {b} % d&apos;entre eux diffèrent de zéro.</translation>
    </message>
    <message>
        <source>Planes after: {a:n} ± {b:n} mm (95 %).</source>
        <translation>Plans après : {a} ± {b} mm (95 %).</translation>
    </message>
</context>
<context>
    <name>section panel</name>
    <message>
        <source>Select a target to see all lines side by side in a strip across it, or cut from one point to another. Where the lines stand apart or lean, the boresight is wrong.</source>
        <translation>Sélectionnez une cible pour voir toutes les lignes côte à côte dans une bande en travers, ou coupez d&apos;un point à un autre. Là où les lignes s&apos;écartent ou penchent, les angles de visée sont faux.</translation>
    </message>
    <message>
        <source>Wheel: zoom. Drag: move. Double click: all of it.</source>
        <translation>Molette : zoom. Glisser : déplacer. Double-clic : tout montrer.</translation>
    </message>
    <message>
        <source>Away from the vessel, m</source>
        <translation>En s&apos;éloignant du navire, m</translation>
    </message>
    <message>
        <source>To the right, m</source>
        <translation>Vers la droite, m</translation>
    </message>
    <message>
        <source>From the first point to the second, m</source>
        <translation>Du premier point au second, m</translation>
    </message>
    <message>
        <source>Height, m</source>
        <translation>Hauteur, m</translation>
    </message>
    <message>
        <source>Upright</source>
        <translation>Verticale</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Horizontale</translation>
    </message>
    <message>
        <source>Upright shows height against distance: roll and pitch. Level looks down: yaw.</source>
        <translation>Verticale montre la hauteur selon la distance : roulis et tangage. Horizontale regarde d&apos;en haut : lacet.</translation>
    </message>
    <message>
        <source>Thickness of the strip</source>
        <translation>Épaisseur de la bande</translation>
    </message>
    <message>
        <source>Height of the picture, and its width across a target</source>
        <translation>Hauteur de l&apos;image, et sa largeur en travers d&apos;une cible</translation>
    </message>
    <message>
        <source>Cut from one clicked point to another</source>
        <translation>Couper d&apos;un point cliqué à un autre</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>Strip</source>
        <translation>Bande</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Section of the lines: {what}</source>
        <translation>Coupe des lignes : {what}</translation>
    </message>
    <message>
        <source>Before: up to {n:n} mm apart</source>
        <translation>Avant : jusqu&apos;à {n} mm d&apos;écart</translation>
    </message>
    <message>
        <source>After: up to {n:n} mm apart</source>
        <translation>Après : jusqu&apos;à {n} mm d&apos;écart</translation>
    </message>
    <message>
        <source>No points here</source>
        <translation>Aucun point ici</translation>
    </message>
    <message>
        <source>{n:n} km</source>
        <translation>{n} km</translation>
    </message>
</context>
<context>
    <name>sightings table</name>
    <message>
        <source>No targets yet. Hold Ctrl and click a target in the view: one row for each appears here.</source>
        <translation>Pas encore de cible. Maintenez Ctrl et cliquez sur une cible dans la vue 3D : une rangée pour chacune apparaît ici.</translation>
    </message>
    <message>
        <source>Tick to let the whole target take part</source>
        <translation>Cocher pour que la cible entière prenne part</translation>
    </message>
    <message>
        <source>{line:name}  {n:n}°</source>
        <translation>{line}  {n}°</translation>
    </message>
    <message>
        <source>{line:name}: points and RMS about the sighting&apos;s own plane, in millimetres</source>
        <translation>{line} : points et RMS par rapport au plan propre de l&apos;observation, en millimètres</translation>
    </message>
    <message>
        <source>Whole line</source>
        <translation>Ligne entière</translation>
    </message>
    <message>
        <source>Untick a line to leave out all targets on it</source>
        <translation>Décocher une ligne pour y écarter toutes les cibles</translation>
    </message>
    <message>
        <source>{n:n} of {all:n} used</source>
        <translation>{n} sur {all} employées</translation>
    </message>
    <message>
        <source>{line:name}: untick to leave out every target on it, tick to use them all</source>
        <translation>{line} : décocher pour y écarter toutes les cibles, cocher pour les employer toutes</translation>
    </message>
    <message>
        <source>{n:n}   {rms}</source>
        <translation>{n}   {rms}</translation>
    </message>
    <message>
        <source>{n:n}   {rms}   poor</source>
        <translation>{n}   {rms}   mauvaise</translation>
    </message>
    <message>
        <source>{n:n}   {rms} 🖎</source>
        <translation>{n}   {rms} 🖎</translation>
    </message>
    <message>
        <source>{target:name} on {line:name}: {n:n} points, {rms} RMS about their own plane</source>
        <translation>{target} sur {line} : {n} points, {rms} RMS par rapport à leur propre plan</translation>
    </message>
    <message>
        <source>Points edited with the lasso; they stay as they were chosen</source>
        <translation>Points modifiés au lasso ; ils restent tels qu&apos;ils ont été choisis</translation>
    </message>
    <message>
        <source>Drawn from one in {n:n} of the many points about the seed</source>
        <translation>Tiré d&apos;un point sur {n} parmi les nombreux points autour du point initial</translation>
    </message>
    <message>
        <source>Distance to the adjusted plane: {a} RMS before, {b} after</source>
        <translation>Distance au plan compensé : {a} RMS avant, {b} après</translation>
    </message>
    <message>
        <source>Untick to leave this sighting out</source>
        <translation>Décocher pour écarter cette observation</translation>
    </message>
    <message>
        <source>{n:n} points per m²</source>
        <translation>{n} points par m²</translation>
    </message>
    <message>
        <source>{n:n}° from the normal</source>
        <translation>à {n}° de la normale</translation>
    </message>
    <message>
        <source>{a:n} × {b:n} {unit:kept}</source>
        <translation>{a} × {b} {unit}</translation>
    </message>
    <message>
        <source>{n:n} % of what the other lines show</source>
        <translation>{n} % de ce que montrent les autres lignes</translation>
    </message>
    <message>
        <source>Quality: {light}</source>
        <translation>Qualité : {light}</translation>
    </message>
    <message>
        <source>good</source>
        <translation>bonne</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>douteuse</translation>
    </message>
    <message>
        <source>poor</source>
        <translation>mauvaise</translation>
    </message>
    <message>
        <source>Up to {n} (RMS) may be the error of the rough boresight; it does not count before the calibration</source>
        <translation>Jusqu&apos;à {n} (RMS) peuvent venir de l&apos;erreur des angles de visée approchés ; cela ne compte pas avant l&apos;étalonnage</translation>
    </message>
    <message>
        <source>Judged with the estimated boresight, from {n:n} points with an RMS of {rms}</source>
        <translation>Évaluée avec les angles de visée estimés, d&apos;après {n} points de RMS {rms}</translation>
    </message>
    <message>
        <source>{name:name}: takes part in the adjustment</source>
        <translation>{name} : prend part à la compensation</translation>
    </message>
    <message>
        <source>{name:name}: validation plane, takes no part</source>
        <translation>{name} : plan de validation, n&apos;y prend pas part</translation>
    </message>
    <message>
        <source>{name:name} on {line:name}: {reason}</source>
        <translation>{name} sur {line} : {reason}</translation>
    </message>
    <message>
        <source>not searched for on this line</source>
        <translation>non cherchée sur cette ligne</translation>
    </message>
    <message>
        <source>To seed this line alone, choose it under “Seek on” in step 2 and Ctrl+click.</source>
        <translation>Pour ne désigner que cette ligne, choisissez-la sous « Chercher sur » à l&apos;étape 2 et faites Ctrl+clic.</translation>
    </message>
</context>
<context>
    <name>clipping panel</name>
    <message>
        <source>Only what lies in the box is drawn, picked and measured. Drag the dots on its sides, or type its lengths.</source>
        <translation>Seul ce qui est dans la boîte est dessiné, désigné et mesuré. Glissez les points de ses côtés, ou saisissez ses longueurs.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profondeur</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Length of the box across the target, metres</source>
        <translation>Longueur de la boîte en travers de la cible, en mètres</translation>
    </message>
    <message>
        <source>Length of the box along the target, metres</source>
        <translation>Longueur de la boîte le long de la cible, en mètres</translation>
    </message>
    <message>
        <source>Height of the box, metres</source>
        <translation>Hauteur de la boîte, en mètres</translation>
    </message>
    <message>
        <source>About the selection</source>
        <translation>Autour de la sélection</translation>
    </message>
    <message>
        <source>Lay the box about the selected target</source>
        <translation>Poser la boîte autour de la cible sélectionnée</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Réinitialiser</translation>
    </message>
    <message>
        <source>Draw everything again</source>
        <translation>Tout dessiner de nouveau</translation>
    </message>
</context>
<context>
    <name>convention panel</name>
    <message>
        <source>Angles in another program</source>
        <translation>Angles dans un autre logiciel</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Logiciel</translation>
    </message>
    <message>
        <source>Program the angles are for</source>
        <translation>Logiciel auquel sont destinés les angles</translation>
    </message>
    <message>
        <source>like the body axes</source>
        <translation>comme les axes du navire</translation>
    </message>
    <message>
        <source>as in the raw points</source>
        <translation>comme dans les points bruts</translation>
    </message>
    <message>
        <source>laid on them by a mounting</source>
        <translation>posés dessus par un montage</translation>
    </message>
    <message>
        <source>like the body axes (usual)</source>
        <translation>comme les axes du navire (usuel)</translation>
    </message>
    <message>
        <source>as in the raw points (usual)</source>
        <translation>comme dans les points bruts (usuel)</translation>
    </message>
    <message>
        <source>laid on them by a mounting (usual)</source>
        <translation>posés dessus par un montage (usuel)</translation>
    </message>
    <message>
        <source>How that program&apos;s scanner axes lie to those of the raw points</source>
        <translation>Comment les axes du scanneur de ce logiciel se placent par rapport à ceux des points bruts</translation>
    </message>
    <message>
        <source>Scanner axes there</source>
        <translation>Axes du scanneur là-bas</translation>
    </message>
    <message>
        <source>Matrix from scanner to body</source>
        <translation>Matrice du scanneur au navire</translation>
    </message>
    <message>
        <source>Copy matrix</source>
        <translation>Copier la matrice</translation>
    </message>
    <message>
        <source>Copy the sixteen numbers, row by row, to the clipboard</source>
        <translation>Copier les seize nombres, rangée par rangée, dans le presse-papiers</translation>
    </message>
    <message>
        <source>Copy angles</source>
        <translation>Copier les angles</translation>
    </message>
    <message>
        <source>Copy the angles to type in, one a line with its name, to the clipboard</source>
        <translation>Copier les angles à saisir, un par ligne avec son nom, dans le presse-papiers</translation>
    </message>
    <message>
        <source>No values</source>
        <translation>Pas de valeurs</translation>
    </message>
    <message>
        <source>&lt;b style=&quot;{style:kept}&quot;&gt;{word}&lt;/b&gt;: {source}.</source>
        <translation>&lt;b style=&quot;{style}&quot;&gt;{word}&lt;/b&gt; : {source}.</translation>
    </message>
    <message>
        <source>Verified</source>
        <translation>Vérifiée</translation>
    </message>
    <message>
        <source>Partly verified</source>
        <translation>Partiellement vérifiée</translation>
    </message>
    <message>
        <source>Not verified</source>
        <translation>Non vérifiée</translation>
    </message>
    <message>
        <source>Body axes there: X {x}, Y {y}, Z {z}.</source>
        <translation>Axes du navire là-bas : X {x}, Y {y}, Z {z}.</translation>
    </message>
    <message>
        <source>{formula}, LiDAR to body.</source>
        <translation>{formula}, du LiDAR au navire.</translation>
    </message>
    <message>
        <source>{formula}, body to LiDAR.</source>
        <translation>{formula}, du navire au LiDAR.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Assumed:&lt;/b&gt; {what}</source>
        <translation>&lt;b&gt;Supposé :&lt;/b&gt; {what}</translation>
    </message>
    <message>
        <source>Taken as a matrix only: see below</source>
        <translation>Donnée comme matrice seulement : voir ci-dessous</translation>
    </message>
    <message>
        <source>Type in there, degrees</source>
        <translation>À saisir là-bas, en degrés</translation>
    </message>
    <message>
        <source>If the assumption holds, degrees</source>
        <translation>Si la supposition est juste, en degrés</translation>
    </message>
    <message>
        <source>Type in</source>
        <translation>À saisir</translation>
    </message>
    <message>
        <source>If so</source>
        <translation>Si oui</translation>
    </message>
    <message>
        <source>Now set</source>
        <translation>Réglé</translation>
    </message>
    <message>
        <source>Correction</source>
        <translation>Correction</translation>
    </message>
    <message>
        <source>The matrix of the correction stands on the left: new = correction · present.</source>
        <translation>La matrice de la correction est à gauche : nouveau = correction · actuel.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Do not add the angles:&lt;/b&gt; the sum would be {n:n}° off, {mm:n} mm at {far:n} m.</source>
        <translation>&lt;b&gt;N&apos;additionnez pas les angles :&lt;/b&gt; la somme serait fausse de {n}°, {mm} mm à {far} m.</translation>
    </message>
    <message>
        <source>The correction of the 4x4 matrix:</source>
        <translation>La correction de la matrice 4x4 :</translation>
    </message>
    <message>
        <source>The matrix below replaces the present one: new = correction · present. The correction:</source>
        <translation>La matrice ci-dessous remplace l&apos;actuelle : nouveau = correction · actuel. La correction :</translation>
    </message>
    <message>
        <source>Typed by hand.</source>
        <translation>Saisi à la main.</translation>
    </message>
    <message>
        <source>Degrees, positive left side up</source>
        <translation>Degrés, positif quand bâbord monte</translation>
    </message>
    <message>
        <source>Degrees, positive bow down</source>
        <translation>Degrés, positif quand l&apos;étrave descend</translation>
    </message>
    <message>
        <source>Degrees, positive clockwise from above</source>
        <translation>Degrés, positif dans le sens horaire vu d&apos;en haut</translation>
    </message>
    <message>
        <source>Take from the project</source>
        <translation>Reprendre du projet</translation>
    </message>
    <message>
        <source>The estimated boresight of the project, or its prior where none is estimated</source>
        <translation>Les angles de visée estimés du projet, ou a priori si aucun n&apos;est estimé</translation>
    </message>
    <message>
        <source>Correct what is set there now</source>
        <translation>Corriger ce qui y est réglé</translation>
    </message>
    <message>
        <source>Give the present settings of that program to see the correction</source>
        <translation>Donner les réglages actuels de ce logiciel pour voir la correction</translation>
    </message>
    <message>
        <source>Give them as a matrix</source>
        <translation>Les donner comme matrice</translation>
    </message>
    <message>
        <source>Paste the present matrix of that program instead of its angles</source>
        <translation>Coller la matrice actuelle de ce logiciel au lieu de ses angles</translation>
    </message>
    <message>
        <source>Present matrix from scanner to body</source>
        <translation>Matrice actuelle du scanneur au navire</translation>
    </message>
    <message>
        <source>Present matrix from scanner to body in that program, row by row: 3x3 numbers, or 4x4 with the lever arm in metres</source>
        <translation>Matrice actuelle du scanneur au navire dans ce logiciel, rangée par rangée : 3x3 nombres, ou 4x4 avec le bras de levier en mètres</translation>
    </message>
    <message>
        <source>The lines were already turned by them</source>
        <translation>Les lignes ont déjà été tournées par eux</translation>
    </message>
    <message>
        <source>Tick where that program had applied these angles before it wrote the lines: the boresight found is then what comes on top</source>
        <translation>Cocher si ce logiciel avait appliqué ces angles avant d&apos;écrire les lignes : les angles de visée trouvés s&apos;y ajoutent alors</translation>
    </message>
    <message>
        <source>Present matrix</source>
        <translation>Matrice actuelle</translation>
    </message>
    <message>
        <source>Present {turn}</source>
        <translation>{turn} actuel</translation>
    </message>
    <message>
        <source>Where the X axis of the IMU points on the vessel</source>
        <translation>Vers où pointe l&apos;axe X de l&apos;IMU sur le navire</translation>
    </message>
    <message>
        <source>Where the Y axis of the IMU points on the vessel</source>
        <translation>Vers où pointe l&apos;axe Y de l&apos;IMU sur le navire</translation>
    </message>
    <message>
        <source>IMU X axis</source>
        <translation>Axe X de l&apos;IMU</translation>
    </message>
    <message>
        <source>IMU Y axis</source>
        <translation>Axe Y de l&apos;IMU</translation>
    </message>
    <message>
        <source>IMU X</source>
        <translation>IMU X</translation>
    </message>
    <message>
        <source>IMU Y</source>
        <translation>IMU Y</translation>
    </message>
    <message>
        <source>Z {direction}</source>
        <translation>Z {direction}</translation>
    </message>
    <message>
        <source>Prior boresight of {name:kept}: nothing has been estimated yet.</source>
        <translation>Angles de visée a priori de {name} : rien n&apos;a encore été estimé.</translation>
    </message>
    <message>
        <source>Uncorrelated POS errors: these sigmas are several times too small.</source>
        <translation>Erreurs du POS non corrélées : ces écarts-types sont plusieurs fois trop petits.</translation>
    </message>
    <message>
        <source>Estimated boresight of {name:kept}.</source>
        <translation>Angles de visée estimés de {name}.</translation>
    </message>
    <message>
        <source>Angles in the other program</source>
        <translation>Angles dans l&apos;autre logiciel</translation>
    </message>
    <message>
        <source>Scanner axes in the body axes</source>
        <translation>Axes du scanneur dans les axes du navire</translation>
    </message>
    <message>
        <source>Grey: axes of the vessel. Coloured: axes of the scanner, the turn exaggerated by the factor shown. Drag or use the arrow keys to turn, double-click to reset.</source>
        <translation>En gris : axes du navire. En couleur : axes du scanneur, la rotation exagérée du facteur indiqué. Glissez ou prenez les flèches pour tourner, double-clic pour revenir.</translation>
    </message>
</context>
<context>
    <name>more of the view</name>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>W</source>
        <translation>O</translation>
    </message>
    <message>
        <source>U</source>
        <translation>H</translation>
    </message>
    <message>
        <source>{path:kept}: the picture cannot be written there; choose another folder.</source>
        <translation>{path} : l&apos;image ne peut y être écrite ; choisissez un autre dossier.</translation>
    </message>
    <message>
        <source>none chosen</source>
        <translation>aucun choisi</translation>
    </message>
    <message>
        <source>range {n:n} m, {rest:list}</source>
        <translation>distance {n} m, {rest}</translation>
    </message>
    <message>
        <source>range {n:n} {unit:kept}</source>
        <translation>distance {n} {unit}</translation>
    </message>
    <message>
        <source>{n:n} points, {k:n} sightings</source>
        <translation>{n} points, {k} observations</translation>
    </message>
    <message>
        <source>{n:n} points, 1 sighting</source>
        <translation>{n} points, 1 observation</translation>
    </message>
    <message>
        <source>{n:n} points, {k:n} sightings; {strays} left out</source>
        <translation>{n} points, {k} observations ; {strays} hors calcul</translation>
    </message>
    <message>
        <source>{n:n} points, 1 sighting; {strays} left out</source>
        <translation>{n} points, 1 observation ; {strays} hors calcul</translation>
    </message>
    <message>
        <source>Lever arm X: {reason}</source>
        <translation>Bras de levier X : {reason}</translation>
    </message>
    <message>
        <source>Lever arm Y: {reason}</source>
        <translation>Bras de levier Y : {reason}</translation>
    </message>
    <message>
        <source>Lever arm Z: {reason}</source>
        <translation>Bras de levier Z : {reason}</translation>
    </message>
    <message>
        <source>Range offset: {reason}</source>
        <translation>Décalage de distance : {reason}</translation>
    </message>
    <message>
        <source>Scan-angle offset: {reason}</source>
        <translation>Décalage d&apos;angle de balayage : {reason}</translation>
    </message>
    <message>
        <source>Latency: {reason}</source>
        <translation>Latence : {reason}</translation>
    </message>
    <message>
        <source>&lt;b&gt;{value}&lt;/b&gt; ± {sigma}</source>
        <translation>&lt;b&gt;{value}&lt;/b&gt; ± {sigma}</translation>
    </message>
    <message>
        <source>{n:n} °</source>
        <translation>{n} °</translation>
    </message>
    <message>
        <source>prior {value}, significant</source>
        <translation>a priori {value}, significatif</translation>
    </message>
    <message>
        <source>prior {value}, not significant</source>
        <translation>a priori {value}, non significatif</translation>
    </message>
    <message>
        <source>prior {value}, not tested: with uncorrelated POS errors the sigmas are too small</source>
        <translation>a priori {value}, non testé : avec des erreurs du POS non corrélées les écarts-types sont trop petits</translation>
    </message>
    <message>
        <source>Lever arm there, from the POS centre: {arm:kept}</source>
        <translation>Bras de levier là-bas, depuis le centre du POS : {arm}</translation>
    </message>
    <message>
        <source>Present: {arm:kept}</source>
        <translation>Actuel : {arm}</translation>
    </message>
    <message>
        <source>LiDAR range and angle</source>
        <translation>LiDAR distance et angle</translation>
    </message>
    <message>
        <source>{path:kept}: the picture cannot be written; make room on the disk.</source>
        <translation>{path} : l&apos;image ne peut être écrite ; libérez de la place sur le disque.</translation>
    </message>
</context>
<context>
    <name>charts</name>
    <message>
        <source>Type I</source>
        <translation>Type I</translation>
    </message>
</context>
<context>
    <name>progress</name>
    <message>
        <source>Reading {file:kept}</source>
        <translation>Lecture de {file}</translation>
    </message>
    <message>
        <source>Reading {file:kept}, {n:n} points</source>
        <translation>Lecture de {file}, {n} points</translation>
    </message>
    <message>
        <source>Reading {file:kept} for its digest</source>
        <translation>Lecture de {file} pour son empreinte</translation>
    </message>
    <message>
        <source>Georeferencing {line:kept}</source>
        <translation>Géoréférencement de {line}</translation>
    </message>
    <message>
        <source>Placing {line:kept}</source>
        <translation>Placement de {line}</translation>
    </message>
    <message>
        <source>Cutting {line:kept}</source>
        <translation>Coupe de {line}</translation>
    </message>
    <message>
        <source>Cross-checking: line {name:kept}</source>
        <translation>Vérification croisée : ligne {name}</translation>
    </message>
    <message>
        <source>Cross-checking: target {name:kept}</source>
        <translation>Vérification croisée : cible {name}</translation>
    </message>
    <message>
        <source>Cross-checking: {what:kept}</source>
        <translation>Vérification croisée : {what}</translation>
    </message>
    <message>
        <source>Found {n:n} planes</source>
        <translation>{n} plans trouvés</translation>
    </message>
    <message>
        <source>Looked for the target in {line:kept}</source>
        <translation>Cible cherchée dans {line}</translation>
    </message>
    <message>
        <source>Compared {n:n} pairs of lines on {name:kept}</source>
        <translation>{n} paires de lignes comparées sur {name}</translation>
    </message>
    <message>
        <source>Compared {n:n} lines with {name:kept}</source>
        <translation>{n} lignes comparées avec {name}</translation>
    </message>
    <message>
        <source>Adjusted {n:n} times</source>
        <translation>Compensé {n} fois</translation>
    </message>
    <message>
        <source>Proposed {n:n} targets and {k:n} validation planes</source>
        <translation>{n} cibles et {k} plans de validation proposés</translation>
    </message>
    <message>
        <source>{file:kept}: {n:n} points looked at</source>
        <translation>{file} : {n} points examinés</translation>
    </message>
    <message>
        <source>{file:kept}: {n:n} of {all:n} places looked at</source>
        <translation>{file} : {n} endroits examinés sur {all}</translation>
    </message>
    <message>
        <source>{n:n} calibrations of {k:n} systems</source>
        <translation>{n} étalonnages de {k} systèmes</translation>
    </message>
    <message>
        <source>Checking {file:kept}</source>
        <translation>Contrôle de {file}</translation>
    </message>
    <message>
        <source>{folder:kept} ({n:n} of {all:n})</source>
        <translation>{folder} ({n} sur {all})</translation>
    </message>
    <message>
        <source>{n:n} projects</source>
        <translation>{n} projets</translation>
    </message>
    <message>
        <source>Scanned line {n:n} of {all:n}</source>
        <translation>Ligne {n} sur {all} balayée</translation>
    </message>
</context>
<context>
    <name>words of the core</name>
    <message>
        <source>Roll, pitch, yaw</source>
        <translation>Roulis, tangage, lacet</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Letter (US)</translation>
    </message>
    <message>
        <source>English</source>
        <translation>English</translation>
    </message>
    <message>
        <source>Français</source>
        <translation>Français</translation>
    </message>
    <message>
        <source>{a} · {b} · {c}</source>
        <translation>{a} · {b} · {c}</translation>
    </message>
    <message>
        <source>Assumed:</source>
        <translation>Supposé :</translation>
    </message>
    <message>
        <source>Positive left side up</source>
        <translation>Positif quand bâbord monte</translation>
    </message>
    <message>
        <source>Positive port side up</source>
        <translation>Positif quand bâbord monte</translation>
    </message>
    <message>
        <source>Positive starboard side down</source>
        <translation>Positif quand tribord descend</translation>
    </message>
    <message>
        <source>Positive bow down</source>
        <translation>Positif quand l&apos;étrave descend</translation>
    </message>
    <message>
        <source>Positive bow up</source>
        <translation>Positif quand l&apos;étrave monte</translation>
    </message>
    <message>
        <source>Positive clockwise seen from above</source>
        <translation>Positif dans le sens horaire vu d&apos;en haut</translation>
    </message>
    <message>
        <source>Positive counter-clockwise seen from above</source>
        <translation>Positif dans le sens antihoraire vu d&apos;en haut</translation>
    </message>
    <message>
        <source>Right-handed</source>
        <translation>Sens direct</translation>
    </message>
    <message>
        <source>Right-handed, {meaning}</source>
        <translation>Sens direct, {meaning}</translation>
    </message>
    <message>
        <source>The scanner {parts:list}.</source>
        <translation>Le scanneur {parts}.</translation>
    </message>
    <message>
        <source>The scanner {parts:list} (first turned, then pitched, then rolled).</source>
        <translation>Le scanneur {parts} (d&apos;abord tourné, puis tangué, puis roulé).</translation>
    </message>
    <message>
        <source>looks {n:n} deg bow up</source>
        <translation>regarde {n}° vers le haut</translation>
    </message>
    <message>
        <source>looks {n:n} deg bow down</source>
        <translation>regarde {n}° vers le bas</translation>
    </message>
    <message>
        <source>is turned {n:n} deg to starboard</source>
        <translation>est tourné de {n}° vers tribord</translation>
    </message>
    <message>
        <source>is turned {n:n} deg to port</source>
        <translation>est tourné de {n}° vers bâbord</translation>
    </message>
    <message>
        <source>The scanner&apos;s optical centre is {parts:list} the POS centre.</source>
        <translation>Le centre optique du scanneur est à {parts} du centre du POS.</translation>
    </message>
    <message>
        <source>{a:name} ⇄ {b:name}</source>
        <translation>{a} ⇄ {b}</translation>
    </message>
    <message>
        <source>{plane:name}: reciprocal pairs of lines, {model}</source>
        <translation>{plane} : paires réciproques de lignes, {model}</translation>
    </message>
    <message>
        <source>{angle} positive left side up</source>
        <translation>{angle} positif quand bâbord monte</translation>
    </message>
    <message>
        <source>{angle} positive port side up</source>
        <translation>{angle} positif quand bâbord monte</translation>
    </message>
    <message>
        <source>{angle} positive starboard side down</source>
        <translation>{angle} positif quand tribord descend</translation>
    </message>
    <message>
        <source>{angle} positive bow down</source>
        <translation>{angle} positif quand l&apos;étrave descend</translation>
    </message>
    <message>
        <source>{angle} positive bow up</source>
        <translation>{angle} positif quand l&apos;étrave monte</translation>
    </message>
    <message>
        <source>{angle} positive clockwise seen from above</source>
        <translation>{angle} positif dans le sens horaire vu d&apos;en haut</translation>
    </message>
    <message>
        <source>{angle} positive counter-clockwise seen from above</source>
        <translation>{angle} positif dans le sens antihoraire vu d&apos;en haut</translation>
    </message>
    <message>
        <source>{angle} right-handed</source>
        <translation>{angle} en sens direct</translation>
    </message>
    <message>
        <source>{angle} right-handed, {meaning}</source>
        <translation>{angle} en sens direct, {meaning}</translation>
    </message>
</context>
<context>
    <name>pace</name>
    <message>
        <source>{what}: {a:n} points</source>
        <translation>{what} : {a} points</translation>
    </message>
    <message>
        <source>{what}: {a:n} M points</source>
        <translation>{what} : {a} M points</translation>
    </message>
    <message>
        <source>{what}: {a:n} of {b:n} points</source>
        <translation>{what} : {a} points sur {b}</translation>
    </message>
    <message>
        <source>{what}: {a:n} of {b:n} M points</source>
        <translation>{what} : {a} points sur {b} M</translation>
    </message>
    <message>
        <source>{what}: {a:n} M of {b:n} M points</source>
        <translation>{what} : {a} M points sur {b} M</translation>
    </message>
    <message>
        <source>{what}: {a:n} of {b:n} M points, {r:n} M points/s</source>
        <translation>{what} : {a} points sur {b} M, {r} M points/s</translation>
    </message>
    <message>
        <source>{what}: {a:n} M of {b:n} M points, {r:n} M points/s</source>
        <translation>{what} : {a} M points sur {b} M, {r} M points/s</translation>
    </message>
    <message>
        <source>{what}: {a:n} of {b:n} points, {r:n} M points/s</source>
        <translation>{what} : {a} points sur {b}, {r} M points/s</translation>
    </message>
    <message>
        <source>{what}: {a:n} points, {r:n} M points/s</source>
        <translation>{what} : {a} points, {r} M points/s</translation>
    </message>
    <message>
        <source>{what}: {a:n} M points, {r:n} M points/s</source>
        <translation>{what} : {a} M points, {r} M points/s</translation>
    </message>
    <message>
        <source>at least {n:n} points</source>
        <translation>au moins {n} points</translation>
    </message>
    <message>
        <source>at most {n:n}° of tilt</source>
        <translation>au plus {n}° d&apos;écart d&apos;inclinaison</translation>
    </message>
    <message>
        <source>stop criterion {n:n}</source>
        <translation>critère d&apos;arrêt {n}</translation>
    </message>
    <message>
        <source>random seed {n:n}</source>
        <translation>point initial aléatoire {n}</translation>
    </message>
</context>
<context>
    <name>options of files</name>
    <message>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Decimal</source>
        <translation>Décimale</translation>
    </message>
    <message>
        <source>Epoch</source>
        <translation>Époque</translation>
    </message>
    <message>
        <source>Grid unit</source>
        <translation>Unité de la grille</translation>
    </message>
    <message>
        <source>Height unit</source>
        <translation>Unité des hauteurs</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordre</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Attitude</source>
        <translation>Attitude</translation>
    </message>
    <message>
        <source>Separator</source>
        <translation>Séparateur</translation>
    </message>
    <message>
        <source>Time base</source>
        <translation>Base de temps</translation>
    </message>
    <message>
        <source>Time field</source>
        <translation>Champ du temps</translation>
    </message>
    <message>
        <source>Time from</source>
        <translation>Temps depuis</translation>
    </message>
    <message>
        <source>Time unit</source>
        <translation>Unité de temps</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>as is</source>
        <translation>tel quel</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>automatique</translation>
    </message>
    <message>
        <source>big endian</source>
        <translation>gros-boutistes (big-endian)</translation>
    </message>
    <message>
        <source>little endian</source>
        <translation>petit-boutistes (little-endian)</translation>
    </message>
    <message>
        <source>dms</source>
        <translation>degrés, minutes, secondes</translation>
    </message>
    <message>
        <source>enu</source>
        <translation>est, nord, haut (enu)</translation>
    </message>
    <message>
        <source>ned</source>
        <translation>nord, est, bas (ned)</translation>
    </message>
    <message>
        <source>neu</source>
        <translation>nord, est, haut (neu)</translation>
    </message>
    <message>
        <source>nwu</source>
        <translation>nord, ouest, haut (nwu)</translation>
    </message>
    <message>
        <source>wander-ned</source>
        <translation>wander, ned</translation>
    </message>
    <message>
        <source>wander-nwu</source>
        <translation>wander, nwu</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>grille</translation>
    </message>
    <message>
        <source>international feet</source>
        <translation>pieds internationaux</translation>
    </message>
    <message>
        <source>us survey feet</source>
        <translation>pieds d&apos;arpentage américains</translation>
    </message>
    <message>
        <source>us survey foot</source>
        <translation>pied d&apos;arpentage américain</translation>
    </message>
    <message>
        <source>latitude longitude</source>
        <translation>latitude, longitude</translation>
    </message>
    <message>
        <source>longitude latitude</source>
        <translation>longitude, latitude</translation>
    </message>
    <message>
        <source>second</source>
        <translation>seconde</translation>
    </message>
    <message>
        <source>centimetre</source>
        <translation>centimètre</translation>
    </message>
    <message>
        <source>kilometre</source>
        <translation>kilomètre</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>pouce</translation>
    </message>
    <message>
        <source>yard</source>
        <translation>yard</translation>
    </message>
    <message>
        <source>fathom</source>
        <translation>brasse</translation>
    </message>
    <message>
        <source>minute</source>
        <translation>minute</translation>
    </message>
    <message>
        <source>hour</source>
        <translation>heure</translation>
    </message>
    <message>
        <source>millisecond</source>
        <translation>milliseconde</translation>
    </message>
    <message>
        <source>microsecond</source>
        <translation>microseconde</translation>
    </message>
    <message>
        <source>nanosecond</source>
        <translation>nanoseconde</translation>
    </message>
    <message>
        <source>minus wander</source>
        <translation>moins l&apos;angle de dérive (wander)</translation>
    </message>
    <message>
        <source>start</source>
        <translation>début</translation>
    </message>
    <message>
        <source>true</source>
        <translation>vrai</translation>
    </message>
    <message>
        <source>zero</source>
        <translation>zéro</translation>
    </message>
    <message>
        <source>as in the file</source>
        <translation>comme dans le fichier</translation>
    </message>
    <message>
        <source>X from, to</source>
        <translation>X de, à</translation>
    </message>
    <message>
        <source>Y from, to</source>
        <translation>Y de, à</translation>
    </message>
    <message>
        <source>Z from, to</source>
        <translation>Z de, à</translation>
    </message>
    <message>
        <source>Time from, to</source>
        <translation>Temps de, à</translation>
    </message>
    <message>
        <source>Written by</source>
        <translation>Écrit par</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Résolution</translation>
    </message>
    <message>
        <source>Attributes</source>
        <translation>Attributs</translation>
    </message>
    <message>
        <source>Fields</source>
        <translation>Champs</translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>Commentaires</translation>
    </message>
    <message>
        <source>Viewpoint</source>
        <translation>Point de vue</translation>
    </message>
    <message>
        <source>{n:n} per second</source>
        <translation>{n} par seconde</translation>
    </message>
    <message>
        <source>{a:n} to {b:n} deg</source>
        <translation>de {a} à {b}°</translation>
    </message>
    <message>
        <source>{a:n}, {b:n} s (first {n:n} points)</source>
        <translation>{a}, {b} s ({n} premiers points)</translation>
    </message>
    <message>
        <source>{n:n} in {k:n} scans</source>
        <translation>{n} en {k} balayages</translation>
    </message>
    <message>
        <source>La fenêtre en français</source>
        <translation>La fenêtre en français</translation>
    </message>
    <message>
        <source>&amp;Français</source>
        <translation>&amp;Français</translation>
    </message>
    <message>
        <source>&amp;English</source>
        <translation>&amp;English</translation>
    </message>
    <message>
        <source>Lan&amp;guage · Langue</source>
        <translation>Langue · &amp;Language</translation>
    </message>
    <message>
        <source>The window in English</source>
        <translation>La fenêtre en anglais (English)</translation>
    </message>
    <message>
        <source>The trajectory covers the line.</source>
        <translation>La trajectoire couvre la ligne.</translation>
    </message>
    <message>
        <source>The trajectory covers every line.</source>
        <translation>La trajectoire couvre toutes les lignes.</translation>
    </message>
    <message>
        <source>Standard deviations of the boresight from all targets proposed: {sigmas:list}.</source>
        <translation>Écarts-types attendus des angles de visée, avec toutes les cibles proposées : {sigmas}.</translation>
    </message>
    <message>
        <source>Standard deviations of the boresight from all targets proposed and of {picked:kept}, picked already: {sigmas:list}.</source>
        <translation>Écarts-types attendus des angles de visée, avec toutes les cibles proposées et celles déjà désignées ({picked}) : {sigmas}.</translation>
    </message>
</context>
<context>
    <name>script</name>
    <message>
        <source>S&amp;cript of this project…</source>
        <translation>Scri&amp;pt de ce projet…</translation>
    </message>
    <message>
        <source>Script</source>
        <translation>Script</translation>
    </message>
    <message>
        <source>Show the Python that makes this project again from its raw files</source>
        <translation>Montrer le Python qui refait ce projet à partir de ses fichiers bruts</translation>
    </message>
    <message>
        <source>These steps make the project as it stands again from its raw files, in Python, with the same numbers. They can be edited and run without the window.</source>
        <translation>Ces étapes refont le projet tel qu&apos;il est à partir de ses fichiers bruts, en Python, avec les mêmes nombres. Elles peuvent être modifiées et exécutées sans la fenêtre.</translation>
    </message>
    <message>
        <source>Script of this project</source>
        <translation>Script de ce projet</translation>
    </message>
    <message>
        <source>Copy the script</source>
        <translation>Copier le script</translation>
    </message>
    <message>
        <source>The script is copied</source>
        <translation>Le script est copié</translation>
    </message>
    <message>
        <source>Save the script</source>
        <translation>Enregistrer le script</translation>
    </message>
    <message>
        <source>Python (*.py)</source>
        <translation>Python (*.py)</translation>
    </message>
    <message>
        <source>wander</source>
        <translation>dérive (wander)</translation>
    </message>
    <message>
        <source>velocity x</source>
        <translation>vitesse x</translation>
    </message>
    <message>
        <source>velocity y</source>
        <translation>vitesse y</translation>
    </message>
    <message>
        <source>velocity z</source>
        <translation>vitesse z</translation>
    </message>
    <message>
        <source>acceleration x</source>
        <translation>accélération x</translation>
    </message>
    <message>
        <source>acceleration y</source>
        <translation>accélération y</translation>
    </message>
    <message>
        <source>acceleration z</source>
        <translation>accélération z</translation>
    </message>
    <message>
        <source>gps_time</source>
        <translation>gps_time</translation>
    </message>
    <message>
        <source>intensity</source>
        <translation>intensité</translation>
    </message>
    <message>
        <source>return_number</source>
        <translation>return_number</translation>
    </message>
    <message>
        <source>number_of_returns</source>
        <translation>number_of_returns</translation>
    </message>
    <message>
        <source>rate x</source>
        <translation>rotation x</translation>
    </message>
    <message>
        <source>rate y</source>
        <translation>rotation y</translation>
    </message>
    <message>
        <source>rate z</source>
        <translation>rotation z</translation>
    </message>
    <message>
        <source>classification</source>
        <translation>classification</translation>
    </message>
</context>
<context>
    <name>start</name>
    <message>
        <source>Boresight calibration</source>
        <translation>Étalonnage des angles de visée</translation>
    </message>
    <message>
        <source>Drop raw lines and a trajectory anywhere on this window, or begin here.</source>
        <translation>Déposez des lignes brutes et une trajectoire n&apos;importe où sur cette fenêtre, ou commencez ici.</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Commencer</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>Projets récents</translation>
    </message>
    <message>
        <source>Three-minute tour</source>
        <translation>Visite en trois minutes</translation>
    </message>
    <message>
        <source>Three-minute &amp;tour</source>
        <translation>&amp;Visite en trois minutes</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Visite</translation>
    </message>
    <message>
        <source>Calibrate the built-in survey, led step by step</source>
        <translation>Étalonner le levé intégré, guidé pas à pas</translation>
    </message>
    <message>
        <source>From a trajectory and raw lines</source>
        <translation>À partir d&apos;une trajectoire et de lignes brutes</translation>
    </message>
    <message>
        <source>A folder with a project.json</source>
        <translation>Un dossier avec un project.json</translation>
    </message>
    <message>
        <source>Demo survey</source>
        <translation>Levé de démonstration</translation>
    </message>
    <message>
        <source>A quay with two boards, seen on six lines</source>
        <translation>Un quai avec deux panneaux, vus sur six lignes</translation>
    </message>
    <message>
        <source>Which boards and lines, before anything is surveyed</source>
        <translation>Quels panneaux et quelles lignes, avant tout levé</translation>
    </message>
    <message>
        <source>Not found: {folder:kept}</source>
        <translation>Introuvable : {folder}</translation>
    </message>
    <message>
        <source>Saved {when:kept}, in {folder:kept}</source>
        <translation>Enregistré le {when}, dans {folder}</translation>
    </message>
    <message>
        <source>Saved {when:kept}; has unsaved work, in {folder:kept}</source>
        <translation>Enregistré le {when} ; contient du travail non enregistré, dans {folder}</translation>
    </message>
    <message>
        <source>Projects appear here once you have opened one.</source>
        <translation>Les projets apparaîtront ici dès que vous en aurez ouvert un.</translation>
    </message>
    <message>
        <source>Tour, step {n:n} of {all:n}</source>
        <translation>Visite, étape {n} sur {all}</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Terminer la visite</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>start of the tour</source>
        <translation>début de la visite</translation>
    </message>
    <message>
        <source>The vessel has passed this quay six times; each line has its colour. The scanner is not mounted as its drawing says, so the same wall stands in six places. Hold Ctrl and click the board in the middle of the view.</source>
        <translation>Le navire est passé six fois devant ce quai ; chaque ligne a sa couleur. Le scanneur n&apos;est pas monté comme son plan le dit : le même mur se trouve donc à six endroits. Maintenez Ctrl et cliquez sur le panneau au milieu de la vue.</translation>
    </message>
    <message>
        <source>The plane of the board was found on every line. Press Return to accept it.</source>
        <translation>Le plan du panneau a été trouvé sur chaque ligne. Appuyez sur Entrée pour l&apos;accepter.</translation>
    </message>
    <message>
        <source>One board cannot tell all three angles. This second one leans back: Ctrl+click it and press Return.</source>
        <translation>Un seul panneau ne donne pas les trois angles. Celui-ci est incliné vers l&apos;arrière : Ctrl+clic dessus, puis Entrée.</translation>
    </message>
    <message>
        <source>Press F9 to estimate the boresight. Roll, pitch and yaw appear on the right, with sigmas that count the errors of the trajectory.</source>
        <translation>Appuyez sur F9 pour estimer les angles de visée. Roulis, tangage et lacet apparaissent à droite, avec des écarts-types qui tiennent compte des erreurs de la trajectoire.</translation>
    </message>
    <message>
        <source>Do the lines agree now? Press F7 and Ctrl+click the plane in the middle: a validation plane takes no part in the adjustment. Accept it with Return.</source>
        <translation>Les lignes s&apos;accordent-elles maintenant ? Appuyez sur F7, puis Ctrl+clic sur le plan au milieu : un plan de validation ne prend pas part à l&apos;ajustement. Acceptez-le avec Entrée.</translation>
    </message>
    <message>
        <source>Press F10: the histograms below show how far the lines were from each other before, and are after. B switches the view between the two.</source>
        <translation>Appuyez sur F10 : les histogrammes en bas montrent de combien les lignes différaient avant, et diffèrent après. B fait passer la vue de l&apos;un à l&apos;autre.</translation>
    </message>
    <message>
        <source>That is all there is to it. Ctrl+E writes the report that you sign; each step on the left says what is missing and what comes next.</source>
        <translation>C&apos;est tout. Ctrl+E écrit le rapport que vous signez ; chaque étape à gauche dit ce qui manque et ce qui vient ensuite.</translation>
    </message>
    <message>
        <source>Lines in 3D</source>
        <translation>Lignes en 3D</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>Page d&apos;accueil</translation>
    </message>
</context>
<context>
    <name>theme</name>
    <message>
        <source>T&amp;heme</source>
        <translation>T&amp;hème</translation>
    </message>
    <message>
        <source>&amp;System default</source>
        <translation>&amp;Réglage du système</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>C&amp;lair</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Sombre</translation>
    </message>
    <message>
        <source>Light or dark as the system is, also when that changes</source>
        <translation>Clair ou sombre comme le système, y compris quand celui-ci change</translation>
    </message>
    <message>
        <source>Dark text on a light ground</source>
        <translation>Texte sombre sur fond clair</translation>
    </message>
    <message>
        <source>Light text on a dark ground</source>
        <translation>Texte clair sur fond sombre</translation>
    </message>
    <message>
        <source>System</source>
        <translation>Système</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
</context>
<context>
    <name>settings</name>
    <message>
        <source>Sett&amp;ings…</source>
        <translation>Pré&amp;férences…</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Préférences</translation>
    </message>
    <message>
        <source>Language, view, report, and the library of sensors</source>
        <translation>Langue, vue, rapport et bibliothèque de capteurs</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Général</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenêtre</translation>
    </message>
    <message>
        <source>System default</source>
        <translation>Réglage du système</translation>
    </message>
    <message>
        <source>Language of the window; the report has its own in step 5</source>
        <translation>Langue de la fenêtre ; le rapport a la sienne à l&apos;étape 5</translation>
    </message>
    <message>
        <source>Size of points</source>
        <translation>Taille des points</translation>
    </message>
    <message>
        <source>Size of a drawn point</source>
        <translation>Taille d&apos;un point dessiné</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>pixels</translation>
    </message>
    <message>
        <source>million</source>
        <translation>million(s)</translation>
    </message>
    <message>
        <source>Points drawn at most</source>
        <translation>Points dessinés au plus</translation>
    </message>
    <message>
        <source>Points drawn while the view rests, at most; a slow computer draws fewer</source>
        <translation>Points dessinés au plus quand la vue est au repos ; un ordinateur lent en dessine moins</translation>
    </message>
    <message>
        <source>Reports also state the boresight as another program has it</source>
        <translation>Les rapports donnent aussi les angles de visée tels qu&apos;un autre programme les écrit</translation>
    </message>
    <message>
        <source>New projects begin with</source>
        <translation>Les nouveaux projets commencent avec</translation>
    </message>
    <message>
        <source>Restore defaults</source>
        <translation>Rétablir les valeurs par défaut</translation>
    </message>
    <message>
        <source>The settings of a new user; your own sensors stay</source>
        <translation>Les préférences d&apos;un nouvel utilisateur ; vos propres capteurs restent</translation>
    </message>
</context>
<context>
    <name>sensors</name>
    <message>
        <source>Sensors</source>
        <translation>Capteurs</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Capteur</translation>
    </message>
    <message>
        <source>What makers state of their instruments, one standard deviation. Where it says so, hold the figures against the data sheet of yours.</source>
        <translation>Ce que les fabricants indiquent de leurs instruments, un écart-type. Là où c&apos;est demandé, vérifiez les valeurs sur la fiche technique du vôtre.</translation>
    </message>
    <message>
        <source>Add scanner…</source>
        <translation>Ajouter un scanneur…</translation>
    </message>
    <message>
        <source>Add INS/GNSS…</source>
        <translation>Ajouter une INS/GNSS…</translation>
    </message>
    <message>
        <source>Copy…</source>
        <translation>Copier…</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>Modifier…</translation>
    </message>
    <message>
        <source>A sensor of your own that begins with these figures</source>
        <translation>Un capteur à vous qui commence avec ces valeurs</translation>
    </message>
    <message>
        <source>Your own only; copy the others</source>
        <translation>Les vôtres seulement ; copiez les autres</translation>
    </message>
    <message>
        <source>Your own only</source>
        <translation>Les vôtres seulement</translation>
    </message>
    <message>
        <source>(your own)</source>
        <translation>(le vôtre)</translation>
    </message>
    <message>
        <source>(own)</source>
        <translation>(le mien)</translation>
    </message>
    <message>
        <source>range {a:n} mm, direction {b:n}°, beam {c:n} mrad</source>
        <translation>distance {a} mm, direction {b}°, faisceau {c} mrad</translation>
    </message>
    <message>
        <source>Maker and model</source>
        <translation>Fabricant et modèle</translation>
    </message>
    <message>
        <source>Where the figures come from</source>
        <translation>Origine des valeurs</translation>
    </message>
    <message>
        <source>Data sheet, with its date</source>
        <translation>Fiche technique, avec sa date</translation>
    </message>
    <message>
        <source>From memory</source>
        <translation>De mémoire</translation>
    </message>
    <message>
        <source>Nobody has held the figures against the data sheet</source>
        <translation>Personne n&apos;a vérifié les valeurs sur la fiche technique</translation>
    </message>
    <message>
        <source>Standard deviation of the range, millimetres</source>
        <translation>Écart-type de la distance, en millimètres</translation>
    </message>
    <message>
        <source>Standard deviation of the beam&apos;s direction, both ways across it, degrees</source>
        <translation>Écart-type de la direction du faisceau, dans les deux sens en travers, en degrés</translation>
    </message>
    <message>
        <source>How far the beam spreads, full angle in milliradians</source>
        <translation>Divergence du faisceau, angle total en milliradians</translation>
    </message>
    <message>
        <source>Range (1 σ)</source>
        <translation>Distance (1 σ)</translation>
    </message>
    <message>
        <source>Beam angular noise (1 σ)</source>
        <translation>Bruit angulaire du faisceau (1 σ)</translation>
    </message>
    <message>
        <source>Divergence</source>
        <translation>Divergence</translation>
    </message>
    <message>
        <source>Other (enter specifications)</source>
        <translation>Autre (saisir les caractéristiques)</translation>
    </message>
    <message>
        <source>RTK</source>
        <translation>RTK</translation>
    </message>
    <message>
        <source>PPK</source>
        <translation>PPK</translation>
    </message>
    <message>
        <source>degraded GNSS</source>
        <translation>GNSS dégradé</translation>
    </message>
    <message>
        <source>With RTK</source>
        <translation>Avec RTK</translation>
    </message>
    <message>
        <source>With PPK</source>
        <translation>Avec PPK</translation>
    </message>
    <message>
        <source>With degraded GNSS</source>
        <translation>Avec GNSS dégradé</translation>
    </message>
    <message>
        <source>Fills in the LiDAR noise; change it where your instrument&apos;s differs</source>
        <translation>Remplit le bruit du LiDAR ; modifiez-le si celui de votre instrument diffère</translation>
    </message>
    <message>
        <source>Fills in the sigmas of position and attitude, used where there is no accuracy file</source>
        <translation>Remplit les écarts-types de position et d&apos;attitude, utilisés sans fichier de précision</translation>
    </message>
    <message>
        <source>none given</source>
        <translation>non donné</translation>
    </message>
    <message>
        <source>Sigma of the beam&apos;s direction; at 0 the noise is the same on each axis</source>
        <translation>Écart-type de la direction du faisceau ; à 0 le bruit est le même sur chaque axe</translation>
    </message>
    <message>
        <source>Apogee Series Hardware Manual APOGEEHM.1.5, 2.3.3 (land, 60 s without GNSS, RTK before)</source>
        <translation>Apogee Series Hardware Manual APOGEEHM.1.5, 2.3.3 (à terre, 60 s sans GNSS, RTK avant)</translation>
    </message>
    <message>
        <source>Apogee Series Hardware Manual APOGEEHM.1.5, 2.3.3 (land, no outage); the base 10 km away</source>
        <translation>Apogee Series Hardware Manual APOGEEHM.1.5, 2.3.3 (à terre, sans coupure) ; la base à 10 km</translation>
    </message>
    <message>
        <source>HDL-32E user&apos;s manual 63-9113: range, accuracy taken for noise; direction and beam assumed</source>
        <translation>Manuel HDL-32E 63-9113 : distance, exactitude prise pour bruit ; direction et faisceau supposés</translation>
    </message>
    <message>
        <source>No data sheet at hand; DGNSS without fixed ambiguities</source>
        <translation>Aucune fiche technique sous la main ; DGNSS sans ambiguïtés fixées</translation>
    </message>
    <message>
        <source>No data sheet at hand; POSPac, antennas 2 m apart, the base 10 km away</source>
        <translation>Aucune fiche technique sous la main ; POSPac, antennes à 2 m l&apos;une de l&apos;autre, la base à 10 km</translation>
    </message>
    <message>
        <source>Heading: POS MV V4 User Guide (2009), page 1-8, antennas 2 m apart; the rest without a data sheet, the base 10 km away</source>
        <translation>Cap : POS MV V4 User Guide (2009), page 1-8, antennes à 2 m l&apos;une de l&apos;autre ; le reste sans fiche technique, la base à 10 km</translation>
    </message>
    <message>
        <source>No data sheet at hand; precision, and the resolution of the angle, taken for its sigma</source>
        <translation>Aucune fiche technique sous la main ; précision, et résolution de l&apos;angle prise pour son écart-type</translation>
    </message>
    <message>
        <source>No data sheet at hand; rounded up</source>
        <translation>Aucune fiche technique sous la main ; arrondi vers le haut</translation>
    </message>
    <message>
        <source>No data sheet at hand; some 60 s without GNSS, rounded up</source>
        <translation>Aucune fiche technique sous la main ; quelque 60 s sans GNSS, arrondi vers le haut</translation>
    </message>
    <message>
        <source>Ouster OS1 data sheet (128 channels up to +22.5 deg; no date): repeatability with a strong signal</source>
        <translation>Fiche technique Ouster OS1 (128 canaux jusqu&apos;à +22,5° ; sans date) : répétabilité avec un signal fort</translation>
    </message>
    <message>
        <source>PandarXT user manual: range, precision; direction and beam assumed</source>
        <translation>Manuel PandarXT : distance, précision ; direction et faisceau supposés</translation>
    </message>
    <message>
        <source>RIEGL VUX-1UAV data sheet: precision; the resolution of the angle, taken for its sigma</source>
        <translation>Fiche technique RIEGL VUX-1UAV : précision ; résolution de l&apos;angle prise pour son écart-type</translation>
    </message>
    <message>
        <source>Thesis, section 1.2.1, table 1.1, after Zoller + Fröhlich (2022); the beam spreads by less</source>
        <translation>Thèse, section 1.2.1, tableau 1.1, d&apos;après Zoller + Fröhlich (2022) ; le faisceau diverge moins</translation>
    </message>
    <message>
        <source>Thesis, section 1.2.2, table 1.2, after iXblue (2019); the base 10 km away</source>
        <translation>Thèse, section 1.2.2, tableau 1.2, d&apos;après iXblue (2019) ; la base à 10 km</translation>
    </message>
</context>
<context>
    <name>design</name>
    <message>
        <source>The plan has been changed since: this is of the plan as it was.</source>
        <translation>Le plan a été modifié depuis : ceci vaut pour le plan tel qu&apos;il était.</translation>
    </message>
    <message>
        <source>Looking at this plan</source>
        <translation>Examen de ce plan</translation>
    </message>
    <message>
        <source>Looking at this plan …</source>
        <translation>Examen de ce plan…</translation>
    </message>
    <message>
        <source>Foretelling</source>
        <translation>Prévision</translation>
    </message>
    <message>
        <source>Weighing</source>
        <translation>Évaluation</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>Panneaux</translation>
    </message>
    <message>
        <source>Boards along</source>
        <translation>Panneaux le long du mur</translation>
    </message>
    <message>
        <source>Boards along, m</source>
        <translation>Panneaux le long du mur, m</translation>
    </message>
    <message>
        <source>Boards along (m)</source>
        <translation>Panneaux le long du mur (m)</translation>
    </message>
    <message>
        <source>Boards up</source>
        <translation>Hauteur des panneaux</translation>
    </message>
    <message>
        <source>Boards up, m</source>
        <translation>Hauteur des panneaux, m</translation>
    </message>
    <message>
        <source>Boards up (m)</source>
        <translation>Hauteur des panneaux (m)</translation>
    </message>
    <message>
        <source>From level</source>
        <translation>Sur l&apos;horizontale</translation>
    </message>
    <message>
        <source>From level, deg</source>
        <translation>Sur l&apos;horizontale, °</translation>
    </message>
    <message>
        <source>From level (deg)</source>
        <translation>Sur l&apos;horizontale (°)</translation>
    </message>
    <message>
        <source>From level
(deg)</source>
        <translation>Sur l&apos;horiz.
(°)</translation>
    </message>
    <message>
        <source>Headings</source>
        <translation>Caps</translation>
    </message>
    <message>
        <source>Headings, deg</source>
        <translation>Caps, °</translation>
    </message>
    <message>
        <source>Headings (deg)</source>
        <translation>Caps (°)</translation>
    </message>
    <message>
        <source>Distances, m</source>
        <translation>Distances, m</translation>
    </message>
    <message>
        <source>Distances (m)</source>
        <translation>Distances (m)</translation>
    </message>
    <message>
        <source>Off the wall</source>
        <translation>Distance au mur</translation>
    </message>
    <message>
        <source>Time on site</source>
        <translation>Temps sur le site</translation>
    </message>
    <message>
        <source>Where boards may hang, to the right; a list of numbers, {low:n} to {high:n} m</source>
        <translation>Où des panneaux peuvent être posés, vers la droite ; liste de nombres, de {low} à {high} m, séparés par des points-virgules ou des blancs</translation>
    </message>
    <message>
        <source>Heights of boards above the POS; a list of numbers, {low:n} to {high:n} m</source>
        <translation>Hauteurs des panneaux au-dessus du POS ; liste de nombres, de {low} à {high} m, séparés par des points-virgules ou des blancs</translation>
    </message>
    <message>
        <source>Inclinations: 90 upright, less leans back, more forward; a list of numbers, {low:n} to {high:n} deg</source>
        <translation>Inclinaisons : 90 vertical, moins penche en arrière, plus en avant ; liste de nombres, de {low} à {high}°, séparés par des points-virgules ou des blancs</translation>
    </message>
    <message>
        <source>That may be sailed; a list of numbers, {low:n} to {high:n} deg</source>
        <translation>Qui peuvent être suivis ; liste de nombres, de {low} à {high}°, séparés par des points-virgules ou des blancs</translation>
    </message>
    <message>
        <source>At which a line may pass the site; a list of numbers, {low:n} to {high:n} m</source>
        <translation>Auxquelles une ligne peut passer le site ; liste de nombres, de {low} à {high} m, séparés par des points-virgules ou des blancs</translation>
    </message>
    <message>
        <source>Boards that are hung, {low:n} to {high:n}</source>
        <translation>Panneaux à poser, de {low} à {high}</translation>
    </message>
    <message>
        <source>Lines that are sailed, {low:n} to {high:n}</source>
        <translation>Lignes à parcourir, de {low} à {high}</translation>
    </message>
    <message>
        <source>No line comes nearer to the wall than this, {low:n} to {high:n} m</source>
        <translation>Aucune ligne ne passe plus près du mur, de {low} à {high} m</translation>
    </message>
    <message>
        <source>Time on site for lines, {low:n} to {high:n} min</source>
        <translation>Temps sur le site pour les lignes, de {low} à {high} min</translation>
    </message>
    <message>
        <source>{what}: give at least one number in {unit}.</source>
        <translation>{what} : donnez au moins un nombre en {unit}.</translation>
    </message>
    <message>
        <source>{what}: “{part:kept}” is not a number; give {unit}.</source>
        <translation>{what} : « {part} » n&apos;est pas un nombre ; donnez-le en {unit}.</translation>
    </message>
    <message>
        <source>{what}: {value:n} is out of range; give {low:n} to {high:n} {unit}.</source>
        <translation>{what} : {value} est hors limites ; donnez de {low} à {high} {unit}.</translation>
    </message>
    <message>
        <source>{what}: {value:n} {unit} is out of range; give {low:n} to {high:n} {unit2}.</source>
        <translation>{what} : {value} {unit} est hors limites ; donnez de {low} à {high} {unit2}.</translation>
    </message>
    <message>
        <source>{what}: give 1 to 24 letters.</source>
        <translation>{what} : donnez de 1 à 24 lettres.</translation>
    </message>
    <message>
        <source>no.</source>
        <translation>n°</translation>
    </message>
    <message>
        <source>Wall and system: the plan&apos;s.</source>
        <translation>Mur et système : ceux du plan.</translation>
    </message>
    <message>
        <source>Wall and system: the site file&apos;s, “{title:kept}”.</source>
        <translation>Mur et système : ceux du fichier de site, « {title} ».</translation>
    </message>
    <message>
        <source>Wall and system: the site file&apos;s, “{title:kept}”. There anyway: {there:kept}.</source>
        <translation>Mur et système : ceux du fichier de site, « {title} ». Déjà en place : {there}.</translation>
    </message>
    <message>
        <source>In which turn it is sailed; the order counts, {low:n} to {high:n} no.</source>
        <translation>Son rang dans l&apos;ordre de parcours ; l&apos;ordre compte ; de {low} à {high}</translation>
    </message>
    <message>
        <source>Clockwise from north, {low:n} to {high:n} deg</source>
        <translation>Dans le sens horaire depuis le nord, de {low} à {high}°</translation>
    </message>
    <message>
        <source>From the middle of the site, when that is abeam, {low:n} to {high:n} m</source>
        <translation>Depuis le milieu du site, quand il est par le travers, de {low} à {high} m</translation>
    </message>
    <message>
        <source>On which side the site lies</source>
        <translation>De quel côté se trouve le site</translation>
    </message>
    <message>
        <source>Over ground, {low:n} to {high:n} m/s</source>
        <translation>Sur le fond, de {low} à {high} m/s</translation>
    </message>
    <message>
        <source>As it is painted on the board</source>
        <translation>Tel qu&apos;il est peint sur le panneau</translation>
    </message>
    <message>
        <source>To the right on the wall, as seen from the water, {low:n} to {high:n} m</source>
        <translation>Vers la droite sur le mur, vu de l&apos;eau, de {low} à {high} m</translation>
    </message>
    <message>
        <source>From the wall towards the water; negative is behind it, {low:n} to {high:n} m</source>
        <translation>Du mur vers l&apos;eau ; négatif derrière le mur ; de {low} à {high} m</translation>
    </message>
    <message>
        <source>Of its middle above the vessel&apos;s POS, {low:n} to {high:n} m</source>
        <translation>De son milieu au-dessus du POS du navire, de {low} à {high} m</translation>
    </message>
    <message>
        <source>90 is upright, less leans back, more leans forward, {low:n} to {high:n} deg</source>
        <translation>90 est vertical, moins penche en arrière, plus penche en avant ; de {low} à {high}°</translation>
    </message>
    <message>
        <source>Azimuth, {low:n} to {high:n} deg</source>
        <translation>Azimut, de {low} à {high}°</translation>
    </message>
    <message>
        <source>Of a board; diameter of a ball, {low:n} to {high:n} m</source>
        <translation>D&apos;un panneau ; diamètre d&apos;une sphère ; de {low} à {high} m</translation>
    </message>
    <message>
        <source>Of a board, along it, {low:n} to {high:n} m</source>
        <translation>D&apos;un panneau, le long de celui-ci, de {low} à {high} m</translation>
    </message>
    <message>
        <source>How far one line may see it off its shape, {low:n} to {high:n} mm. Empty: plan&apos;s</source>
        <translation>De combien une ligne peut la voir hors de sa forme, de {low} à {high} mm. Vide : celle du plan</translation>
    </message>
    <message>
        <source>plan&apos;s</source>
        <translation>du plan</translation>
    </message>
    <message>
        <source>Line
(no.)</source>
        <translation>Ligne
(n°)</translation>
    </message>
    <message>
        <source>Site on</source>
        <translation>Site à</translation>
    </message>
    <message>
        <source>Along
(m)</source>
        <translation>Le long
(m)</translation>
    </message>
    <message>
        <source>Off
(m)</source>
        <translation>Au mur
(m)</translation>
    </message>
    <message>
        <source>Faces
(deg)</source>
        <translation>Face à
(°)</translation>
    </message>
    <message>
        <source>Width
(m)</source>
        <translation>Largeur
(m)</translation>
    </message>
    <message>
        <source>Height
(m)</source>
        <translation>Hauteur
(m)</translation>
    </message>
    <message>
        <source>Flatness
(mm)</source>
        <translation>Planéité
(mm)</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>Le long</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Au mur</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Face à</translation>
    </message>
    <message>
        <source>Flatness</source>
        <translation>Planéité</translation>
    </message>
    <message>
        <source>Line, no.</source>
        <translation>Ligne, n°</translation>
    </message>
    <message>
        <source>Heading, deg</source>
        <translation>Cap, °</translation>
    </message>
    <message>
        <source>Distance, m</source>
        <translation>Distance, m</translation>
    </message>
    <message>
        <source>Speed, m/s</source>
        <translation>Vitesse, m/s</translation>
    </message>
    <message>
        <source>Along, m</source>
        <translation>Le long, m</translation>
    </message>
    <message>
        <source>Off, m</source>
        <translation>Au mur, m</translation>
    </message>
    <message>
        <source>Up, m</source>
        <translation>Haut, m</translation>
    </message>
    <message>
        <source>Faces, deg</source>
        <translation>Face à, °</translation>
    </message>
    <message>
        <source>Width, m</source>
        <translation>Largeur, m</translation>
    </message>
    <message>
        <source>Flatness, mm</source>
        <translation>Planéité, mm</translation>
    </message>
    <message>
        <source>Lines of the plan</source>
        <translation>Lignes du plan</translation>
    </message>
    <message>
        <source>Targets of the plan</source>
        <translation>Cibles du plan</translation>
    </message>
    <message>
        <source>Add the selected line the other way round (Insert)</source>
        <translation>Ajouter la ligne choisie en sens inverse (Inser)</translation>
    </message>
    <message>
        <source>Sail the selected line again (Ctrl+D)</source>
        <translation>Parcourir la ligne choisie une fois de plus (Ctrl+D)</translation>
    </message>
    <message>
        <source>Remove the selected line (Delete)</source>
        <translation>Retirer la ligne choisie (Suppr)</translation>
    </message>
    <message>
        <source>Sail it one turn earlier (Alt+Up)</source>
        <translation>La parcourir un rang plus tôt (Alt+Haut)</translation>
    </message>
    <message>
        <source>Sail it one turn later (Alt+Down)</source>
        <translation>La parcourir un rang plus tard (Alt+Bas)</translation>
    </message>
    <message>
        <source>Add board</source>
        <translation>Ajouter un panneau</translation>
    </message>
    <message>
        <source>Add ball</source>
        <translation>Ajouter une sphère</translation>
    </message>
    <message>
        <source>Hang one more board, {aside:n} m to the right (Insert)</source>
        <translation>Poser un panneau de plus, {aside} m à droite (Inser)</translation>
    </message>
    <message>
        <source>Put up a ball of {wide:n} m, {aside:n} m to the right</source>
        <translation>Poser une sphère de {wide} m, {aside} m à droite</translation>
    </message>
    <message>
        <source>Remove the selected target (Delete)</source>
        <translation>Retirer la cible choisie (Suppr)</translation>
    </message>
    <message>
        <source>{name:kept}: another target has this name; give it another.</source>
        <translation>{name} : une autre cible porte ce nom ; donnez-en un autre.</translation>
    </message>
    <message>
        <source>order of lines</source>
        <translation>ordre des lignes</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Plus tôt</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Plus tard</translation>
    </message>
    <message>
        <source>heading of line {k:n}</source>
        <translation>cap de la ligne {k}</translation>
    </message>
    <message>
        <source>distance of line {k:n}</source>
        <translation>distance de la ligne {k}</translation>
    </message>
    <message>
        <source>side of line {k:n}</source>
        <translation>côté de la ligne {k}</translation>
    </message>
    <message>
        <source>speed of line {k:n}</source>
        <translation>vitesse de la ligne {k}</translation>
    </message>
    <message>
        <source>name of target {k:n}</source>
        <translation>nom de la cible {k}</translation>
    </message>
    <message>
        <source>along of target {k:n}</source>
        <translation>position le long du mur de la cible {k}</translation>
    </message>
    <message>
        <source>off of target {k:n}</source>
        <translation>distance au mur de la cible {k}</translation>
    </message>
    <message>
        <source>up of target {k:n}</source>
        <translation>hauteur au-dessus du POS de la cible {k}</translation>
    </message>
    <message>
        <source>lean of target {k:n}</source>
        <translation>inclinaison de la cible {k}</translation>
    </message>
    <message>
        <source>facing of target {k:n}</source>
        <translation>azimut de la cible {k}</translation>
    </message>
    <message>
        <source>width of target {k:n}</source>
        <translation>largeur de la cible {k}</translation>
    </message>
    <message>
        <source>height of target {k:n}</source>
        <translation>hauteur de la cible {k}</translation>
    </message>
    <message>
        <source>flatness of target {k:n}</source>
        <translation>planéité de la cible {k}</translation>
    </message>
    <message>
        <source>turn line {k:n}</source>
        <translation>tourner la ligne {k}</translation>
    </message>
    <message>
        <source>move line {k:n}</source>
        <translation>déplacer la ligne {k}</translation>
    </message>
    <message>
        <source>move target</source>
        <translation>déplacer la cible</translation>
    </message>
    <message>
        <source>move {name:kept}</source>
        <translation>déplacer {name}</translation>
    </message>
    <message>
        <source>hang target</source>
        <translation>poser la cible</translation>
    </message>
    <message>
        <source>duplicate line</source>
        <translation>dupliquer la ligne</translation>
    </message>
    <message>
        <source>add line</source>
        <translation>ajouter une ligne</translation>
    </message>
    <message>
        <source>remove line</source>
        <translation>retirer la ligne</translation>
    </message>
    <message>
        <source>add ball</source>
        <translation>ajouter une sphère</translation>
    </message>
    <message>
        <source>add board</source>
        <translation>ajouter un panneau</translation>
    </message>
    <message>
        <source>remove target</source>
        <translation>retirer la cible</translation>
    </message>
    <message>
        <source>best plan</source>
        <translation>meilleur plan</translation>
    </message>
    <message>
        <source>wall faces</source>
        <translation>orientation du mur</translation>
    </message>
    <message>
        <source>system</source>
        <translation>système</translation>
    </message>
    <message>
        <source>title</source>
        <translation>titre</translation>
    </message>
    <message>
        <source>own numbers</source>
        <translation>valeurs saisies</translation>
    </message>
    <message>
        <source>Scenarios (F9) change one thing at a time: lines, inclination, size and combination of boards as the thesis does, and with this plan distance, height, repeated lines, speed and POS. Simulated surveys (F10) show whether the sigmas hold.</source>
        <translation>Les scénarios (F9) changent une chose à la fois : lignes, inclinaison, taille et combinaison de panneaux comme dans la thèse et, avec ce plan, distance, hauteur, répétition des lignes, vitesse et POS. Les levés simulés (F10) montrent si les écarts-types tiennent.</translation>
    </message>
    <message>
        <source>less time on site</source>
        <translation>moins de temps sur le site</translation>
    </message>
    <message>
        <source>errors of simulated surveys</source>
        <translation>erreurs des levés simulés</translation>
    </message>
    <message>
        <source>Which figure is shown</source>
        <translation>Figure affichée</translation>
    </message>
    <message>
        <source>{name} (thesis&apos;s wall and boards)</source>
        <translation>{name} (mur et panneaux de la thèse)</translation>
    </message>
    <message>
        <source>Figure: {title}</source>
        <translation>Figure : {title}</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>lignes</translation>
    </message>
    <message>
        <source>inclination</source>
        <translation>inclinaison</translation>
    </message>
    <message>
        <source>size</source>
        <translation>taille</translation>
    </message>
    <message>
        <source>targets</source>
        <translation>cibles</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>distance</translation>
    </message>
    <message>
        <source>repeats</source>
        <translation>répétitions</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>vitesse</translation>
    </message>
    <message>
        <source>Site from above: lines</source>
        <translation>Site vu de dessus : lignes</translation>
    </message>
    <message>
        <source>east (m)</source>
        <translation>est (m)</translation>
    </message>
    <message>
        <source>north (m)</source>
        <translation>nord (m)</translation>
    </message>
    <message>
        <source>along the wall (m)</source>
        <translation>le long du mur (m)</translation>
    </message>
    <message>
        <source>height of the POS</source>
        <translation>hauteur du POS</translation>
    </message>
    <message>
        <source>{heading:n}°, {distance:n} m</source>
        <translation>{heading}°, à {distance} m</translation>
    </message>
    <message>
        <source>{along:n}, {up:n} m</source>
        <translation>{along} ; {up} m</translation>
    </message>
    <message>
        <source>Drag a line nearer or farther, its arrow to turn it (in steps of 5 deg, with Shift freely). Keys: Page up and down choose a line, Left and Right turn it, Up and Down move it; Insert adds, Delete removes.</source>
        <translation>Faites glisser une ligne pour la rapprocher ou l&apos;éloigner, sa flèche pour la tourner (par pas de 5°, librement avec Maj). Clavier : Page précédente et suivante choisissent une ligne, Gauche et Droite la tournent, Haut et Bas la déplacent ; Inser ajoute, Suppr retire.</translation>
    </message>
    <message>
        <source>Wall from the water: targets</source>
        <translation>Mur vu de l&apos;eau : cibles</translation>
    </message>
    <message>
        <source>Wall from the water</source>
        <translation>Mur vu de l&apos;eau</translation>
    </message>
    <message>
        <source>Drag a target along the wall and up (in steps of {wide:n} m, with Shift of {fine:n} m). Keys: Page up and down choose a target, the arrows move it; Insert adds a board, Delete removes.</source>
        <translation>Faites glisser une cible le long du mur et en hauteur (par pas de {wide} m, de {fine} m avec Maj). Clavier : Page précédente et suivante choisissent une cible, les flèches la déplacent ; Inser ajoute un panneau, Suppr retire.</translation>
    </message>
    <message>
        <source>this plan</source>
        <translation>ce plan</translation>
    </message>
    <message>
        <source>thesis</source>
        <translation>thèse</translation>
    </message>
    <message>
        <source>open</source>
        <translation>indéterminé</translation>
    </message>
    <message>
        <source>Target or line that is left out</source>
        <translation>Cible ou ligne laissée de côté</translation>
    </message>
    <message>
        <source>Largest σ (deg)</source>
        <translation>Plus grand σ (°)</translation>
    </message>
    <message>
        <source>Largest of the three sigmas without it</source>
        <translation>Le plus grand des trois écarts-types sans elle</translation>
    </message>
    <message>
        <source>That many times as large as with it</source>
        <translation>Combien de fois plus grand qu&apos;avec elle</translation>
    </message>
    <message>
        <source>Expected sigmas (deg, 1 sigma)</source>
        <translation>Écarts-types attendus (°)</translation>
    </message>
    <message>
        <source>Sigma of {angle}, this plan, degrees</source>
        <translation>Écart-type du {angle}, ce plan, degrés</translation>
    </message>
    <message>
        <source>Sigma of {angle}, thesis, degrees</source>
        <translation>Écart-type du {angle}, thèse, degrés</translation>
    </message>
    <message>
        <source>Correlations; near 1 or −1 two angles are hardly told apart</source>
        <translation>Corrélations ; près de 1 ou de −1, deux angles se distinguent à peine</translation>
    </message>
    <message>
        <source>Correlation: roll–pitch {a:n}, roll–yaw {b:n}, pitch–yaw {c:n}</source>
        <translation>Corrélation : roulis–tangage {a} ; roulis–lacet {b} ; tangage–lacet {c}</translation>
    </message>
    <message>
        <source>Correlation: roll–pitch –, roll–yaw –, pitch–yaw –</source>
        <translation>Corrélation : roulis–tangage – ; roulis–lacet – ; tangage–lacet –</translation>
    </message>
    <message>
        <source>Points per sighting</source>
        <translation>Points par observation</translation>
    </message>
    <message>
        <source>What each is worth</source>
        <translation>Ce que vaut chacune</translation>
    </message>
    <message>
        <source>What each target and line is worth</source>
        <translation>Ce que vaut chaque cible et chaque ligne</translation>
    </message>
    <message>
        <source>On site: no line yet</source>
        <translation>Sur le site : pas encore de ligne</translation>
    </message>
    <message>
        <source>On site: {min:n} min for {n:n} lines, turns included</source>
        <translation>Sur le site : {min} min pour {n} lignes, demi-tours compris</translation>
    </message>
    <message>
        <source>Nothing to calibrate with yet: add a target and at least two lines.</source>
        <translation>Rien encore pour étalonner : ajoutez une cible et au moins deux lignes.</translation>
    </message>
    <message>
        <source>POS as good as stated</source>
        <translation>POS aussi bon qu&apos;annoncé</translation>
    </message>
    <message>
        <source>POS half to twice as poor</source>
        <translation>POS de deux fois meilleur à deux fois moins bon</translation>
    </message>
    <message>
        <source>What the best plan has smallest</source>
        <translation>Ce que le meilleur plan a de plus petit</translation>
    </message>
    <message>
        <source>How good the POS will be on the day: the mean counts</source>
        <translation>Qualité du POS le jour venu : la moyenne compte</translation>
    </message>
    <message>
        <source>About how many plans to look at where there are too many to look at all, 100 to 1,000,000</source>
        <translation>Nombre approximatif de plans à examiner quand il y en a trop pour les examiner tous, de 100 à 1 000 000</translation>
    </message>
    <message>
        <source>Site file…</source>
        <translation>Fichier de site…</translation>
    </message>
    <message>
        <source>Read wall, system and limits of a site, and what stands there anyway</source>
        <translation>Lire le mur, le système et les limites d&apos;un site, et ce qui s&apos;y trouve déjà</translation>
    </message>
    <message>
        <source>Without file</source>
        <translation>Sans fichier</translation>
    </message>
    <message>
        <source>Take wall and system of the plan again</source>
        <translation>Reprendre le mur et le système du plan</translation>
    </message>
    <message>
        <source>Find the best plan</source>
        <translation>Chercher le meilleur plan</translation>
    </message>
    <message>
        <source>Search in the background; the best plan becomes this plan, and one undo goes back</source>
        <translation>Chercher en arrière-plan ; le meilleur plan devient ce plan, et une annulation revient en arrière</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>Minimiser</translation>
    </message>
    <message>
        <source>Expect</source>
        <translation>Prévoir</translation>
    </message>
    <message>
        <source>Plans</source>
        <translation>Plans</translation>
    </message>
    <message>
        <source>{criterion} is {value:n} deg; {n:n} plans looked at, which is all there are. The best plan is shown; undo goes back to the one before.</source>
        <translation>{criterion} : {value}° ; {n} plans examinés, c&apos;est-à-dire tous. Le meilleur plan est affiché ; l&apos;annulation revient au précédent.</translation>
    </message>
    <message>
        <source>{criterion} is {value:n} deg; {n:n} plans looked at, of many more. The best plan is shown; undo goes back to the one before.</source>
        <translation>{criterion} : {value}° ; {n} plans examinés, parmi bien d&apos;autres. Le meilleur plan est affiché ; l&apos;annulation revient au précédent.</translation>
    </message>
    <message>
        <source>The largest of the three sigmas</source>
        <translation>Le plus grand des trois écarts-types</translation>
    </message>
    <message>
        <source>The sigma of roll</source>
        <translation>L&apos;écart-type du roulis</translation>
    </message>
    <message>
        <source>The sigma of pitch</source>
        <translation>L&apos;écart-type du tangage</translation>
    </message>
    <message>
        <source>The sigma of yaw</source>
        <translation>L&apos;écart-type du lacet</translation>
    </message>
    <message>
        <source>The root mean square of the three sigmas (a-optimality)</source>
        <translation>La moyenne quadratique des trois écarts-types (A-optimalité)</translation>
    </message>
    <message>
        <source>The radius of a ball as large as the confidence ellipsoid (d-optimality)</source>
        <translation>Le rayon d&apos;une sphère aussi grande que l&apos;ellipsoïde de confiance (D-optimalité)</translation>
    </message>
    <message>
        <source>Every survey has boards off their shape, LiDAR noise, POS errors that drift and a rolling vessel, and is adjusted as a real one. Their answers scatter about the truth: as much as foretold, or not. The surveys are of the plan as it stands when they begin.</source>
        <translation>Chaque levé a des panneaux hors de leur forme, le bruit du LiDAR, des erreurs du POS qui dérivent et un navire qui roule, et il est compensé comme un vrai. Les résultats se dispersent autour de la vérité : autant que prévu, ou non. Les levés sont ceux du plan tel qu&apos;il est quand ils commencent.</translation>
    </message>
    <message>
        <source>How many surveys to simulate and adjust, {a:n} to {b:n}</source>
        <translation>Nombre de levés à simuler et à compenser, de {a} à {b}</translation>
    </message>
    <message>
        <source>Seed of chance: another one gives other surveys, the same one the same</source>
        <translation>Point initial du hasard : un autre donne d&apos;autres levés, le même les mêmes</translation>
    </message>
    <message>
        <source>The adjustment is told how flat the targets are</source>
        <translation>La compensation connaît la planéité des cibles</translation>
    </message>
    <message>
        <source>Otherwise it takes their flatness from the data, as with a real survey</source>
        <translation>Sinon elle tire leur planéité des données, comme pour un vrai levé</translation>
    </message>
    <message>
        <source>Simulate surveys</source>
        <translation>Simuler des levés</translation>
    </message>
    <message>
        <source>Simulate and adjust them in the background; the plan stays as it is</source>
        <translation>Les simuler et les compenser en arrière-plan ; le plan reste tel qu&apos;il est</translation>
    </message>
    <message>
        <source>Stop; {n:n} surveys or more that are finished are shown</source>
        <translation>Arrêter ; à partir de {n} levés terminés, ceux-ci sont affichés</translation>
    </message>
    <message>
        <source>Surveys</source>
        <translation>Levés</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Point initial</translation>
    </message>
    <message>
        <source>Title of the plan</source>
        <translation>Titre du plan</translation>
    </message>
    <message>
        <source>Title of the plan, as it stands on the field plan</source>
        <translation>Titre du plan, tel qu&apos;il figure sur le plan de terrain</translation>
    </message>
    <message>
        <source>Class of the POS: what data sheets state for such, rounded</source>
        <translation>Classe du POS : ce qu&apos;annoncent les fiches techniques, arrondi</translation>
    </message>
    <message>
        <source>Stochastic model of the POS errors: correlated in time, or uncorrelated</source>
        <translation>Modèle stochastique des erreurs du POS : corrélées dans le temps, ou non corrélées</translation>
    </message>
    <message>
        <source>POS error north, 1 sigma, {low:n} to {high:n} mm</source>
        <translation>Erreur du POS vers le nord, écart-type, de {low} à {high} mm</translation>
    </message>
    <message>
        <source>POS error east, 1 sigma, {low:n} to {high:n} mm</source>
        <translation>Erreur du POS vers l&apos;est, écart-type, de {low} à {high} mm</translation>
    </message>
    <message>
        <source>POS error up, 1 sigma, {low:n} to {high:n} mm</source>
        <translation>Erreur du POS vers le haut, écart-type, de {low} à {high} mm</translation>
    </message>
    <message>
        <source>POS error of roll, 1 sigma, {low:n} to {high:n} deg</source>
        <translation>Erreur du POS en roulis, écart-type, de {low} à {high}°</translation>
    </message>
    <message>
        <source>POS error of pitch, 1 sigma, {low:n} to {high:n} deg</source>
        <translation>Erreur du POS en tangage, écart-type, de {low} à {high}°</translation>
    </message>
    <message>
        <source>POS error of heading, 1 sigma, {low:n} to {high:n} deg</source>
        <translation>Erreur du POS en cap, écart-type, de {low} à {high}°</translation>
    </message>
    <message>
        <source>For how long position errors stay alike, {low:n} to {high:n} s</source>
        <translation>Durée pendant laquelle les erreurs de position restent semblables, de {low} à {high} s</translation>
    </message>
    <message>
        <source>For how long attitude errors stay alike, {low:n} to {high:n} s</source>
        <translation>Durée pendant laquelle les erreurs d&apos;attitude restent semblables, de {low} à {high} s</translation>
    </message>
    <message>
        <source>How far one line sees a target off its shape, {low:n} to {high:n} mm</source>
        <translation>De combien une ligne voit une cible hors de sa forme, de {low} à {high} mm</translation>
    </message>
    <message>
        <source>Pulses of the scanner, {low:n} to {high:n} kHz</source>
        <translation>Impulsions du scanneur, de {low} à {high} kHz</translation>
    </message>
    <message>
        <source>Profiles of the scanner, {low:n} to {high:n} Hz</source>
        <translation>Profils du scanneur, de {low} à {high} Hz</translation>
    </message>
    <message>
        <source>Noise of a range, 1 sigma, {low:n} to {high:n} mm</source>
        <translation>Bruit d&apos;une distance, écart-type, de {low} à {high} mm</translation>
    </message>
    <message>
        <source>Farthest the scanner sees, {low:n} to {high:n} m</source>
        <translation>Portée du scanneur, de {low} à {high} m</translation>
    </message>
    <message>
        <source>From one line to the next, with the turn, {low:n} to {high:n} min</source>
        <translation>D&apos;une ligne à la suivante, demi-tour compris, de {low} à {high} min</translation>
    </message>
    <message>
        <source>Azimuth the wall faces; the whole site turns, {low:n} to {high:n} deg</source>
        <translation>Azimut vers lequel le mur fait face ; tout le site tourne ; de {low} à {high}°</translation>
    </message>
    <message>
        <source>Adjustment takes</source>
        <translation>Compensation avec</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>North, east, up</source>
        <translation>Nord, est, haut</translation>
    </message>
    <message>
        <source>Roll, pitch, heading</source>
        <translation>Roulis, tangage, cap</translation>
    </message>
    <message>
        <source>Position, attitude drift in</source>
        <translation>Dérive position, attitude en</translation>
    </message>
    <message>
        <source>Targets are flat to</source>
        <translation>Cibles planes à</translation>
    </message>
    <message>
        <source>Pulses, profiles</source>
        <translation>Impulsions, profils</translation>
    </message>
    <message>
        <source>Range noise, reach</source>
        <translation>Bruit de distance, portée</translation>
    </message>
    <message>
        <source>A line takes</source>
        <translation>Durée d&apos;une ligne</translation>
    </message>
    <message>
        <source>Wall faces</source>
        <translation>Le mur fait face à</translation>
    </message>
    <message>
        <source>Title: give the plan a name.</source>
        <translation>Titre : donnez un nom au plan.</translation>
    </message>
    <message>
        <source>A plan has at most {n:n} lines; remove one first.</source>
        <translation>Un plan a au plus {n} lignes ; retirez-en une d&apos;abord.</translation>
    </message>
    <message>
        <source>A plan has at most {n:n} targets; remove one first.</source>
        <translation>Un plan a au plus {n} cibles ; retirez-en une d&apos;abord.</translation>
    </message>
    <message>
        <source>After the survey: open its project in the main window, and this plan here, and compare (F11). Targets go by their names, lines by their headings.</source>
        <translation>Après le levé : ouvrez son projet dans la fenêtre principale, ce plan ici, et comparez (F11). Les cibles se retrouvent par leur nom, les lignes par leur cap.</translation>
    </message>
    <message>
        <source>&amp;New plan</source>
        <translation>&amp;Nouveau plan</translation>
    </message>
    <message>
        <source>Begin with the thesis&apos;s plan</source>
        <translation>Commencer par le plan de la thèse</translation>
    </message>
    <message>
        <source>&amp;Open plan…</source>
        <translation>&amp;Ouvrir un plan…</translation>
    </message>
    <message>
        <source>Open a plan</source>
        <translation>Ouvrir un plan</translation>
    </message>
    <message>
        <source>&amp;Save plan</source>
        <translation>&amp;Enregistrer le plan</translation>
    </message>
    <message>
        <source>Save the plan</source>
        <translation>Enregistrer le plan</translation>
    </message>
    <message>
        <source>Save plan &amp;as…</source>
        <translation>Enregistrer le plan &amp;sous…</translation>
    </message>
    <message>
        <source>Save the plan in another file</source>
        <translation>Enregistrer le plan dans un autre fichier</translation>
    </message>
    <message>
        <source>&amp;Field plan…</source>
        <translation>&amp;Plan de terrain…</translation>
    </message>
    <message>
        <source>Field plan</source>
        <translation>Plan de terrain</translation>
    </message>
    <message>
        <source>Write a page for the field as PDF: drawing, boards, lines in their order</source>
        <translation>Écrire une page pour le terrain en PDF : dessin, panneaux, lignes dans leur ordre</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>Close this window; the plan stays</source>
        <translation>Fermer cette fenêtre ; le plan reste</translation>
    </message>
    <message>
        <source>Add &amp;line</source>
        <translation>Ajouter une &amp;ligne</translation>
    </message>
    <message>
        <source>Add the selected line the other way round</source>
        <translation>Ajouter la ligne choisie en sens inverse</translation>
    </message>
    <message>
        <source>&amp;Duplicate line</source>
        <translation>D&amp;upliquer la ligne</translation>
    </message>
    <message>
        <source>Sail the selected line again</source>
        <translation>Parcourir la ligne choisie une fois de plus</translation>
    </message>
    <message>
        <source>Line &amp;earlier</source>
        <translation>Ligne plus &amp;tôt</translation>
    </message>
    <message>
        <source>Sail the selected line a turn earlier</source>
        <translation>Parcourir la ligne choisie un rang plus tôt</translation>
    </message>
    <message>
        <source>Line la&amp;ter</source>
        <translation>Ligne plus tar&amp;d</translation>
    </message>
    <message>
        <source>Sail the selected line a turn later</source>
        <translation>Parcourir la ligne choisie un rang plus tard</translation>
    </message>
    <message>
        <source>Add &amp;board</source>
        <translation>Ajouter un &amp;panneau</translation>
    </message>
    <message>
        <source>Hang one more board</source>
        <translation>Poser un panneau de plus</translation>
    </message>
    <message>
        <source>Add b&amp;all</source>
        <translation>Ajouter une &amp;sphère</translation>
    </message>
    <message>
        <source>Put up one more ball</source>
        <translation>Poser une sphère de plus</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Panneau</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Sphère</translation>
    </message>
    <message>
        <source>&amp;Fit the 3D view</source>
        <translation>&amp;Cadrer la vue 3D</translation>
    </message>
    <message>
        <source>Look at all of the site in 3D again</source>
        <translation>Revoir tout le site en 3D</translation>
    </message>
    <message>
        <source>Sc&amp;enarios</source>
        <translation>S&amp;cénarios</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>Scénarios</translation>
    </message>
    <message>
        <source>Change one thing at a time, in both stochastic models</source>
        <translation>Changer une chose à la fois, dans les deux modèles stochastiques</translation>
    </message>
    <message>
        <source>Simulate &amp;surveys…</source>
        <translation>&amp;Simuler des levés…</translation>
    </message>
    <message>
        <source>Sail this plan many times in the simulator: do the sigmas hold?</source>
        <translation>Parcourir ce plan de nombreuses fois dans le simulateur : les écarts-types tiennent-ils ?</translation>
    </message>
    <message>
        <source>Compare with the &amp;open project</source>
        <translation>C&amp;omparer au projet ouvert</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>Foretold and obtained sigmas of the survey in the main window</source>
        <translation>Écarts-types prévus et obtenus du levé de la fenêtre principale</translation>
    </message>
    <message>
        <source>&amp;Work</source>
        <translation>&amp;Calcul</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Figures</translation>
    </message>
    <message>
        <source>POS and scanner</source>
        <translation>POS et scanneur</translation>
    </message>
    <message>
        <source>{title:kept}[*] – design of a site – LISPAC</source>
        <translation>{title}[*] – plan d&apos;étalonnage d&apos;un site – LISPAC</translation>
    </message>
    <message>
        <source>Done: the figures are beside the views</source>
        <translation>Terminé : les figures sont à côté des vues</translation>
    </message>
    <message>
        <source>{project:kept} against {plan:kept}: 1 sigma, deg</source>
        <translation>{project} comparé à {plan} : écart-type, °</translation>
    </message>
    <message>
        <source>Ctrl+click on a target selects it, on the wall hangs the selected one there; drag a dot beside it to move it along the wall, up, or off it</source>
        <translation>Ctrl+clic sur une cible la choisit, sur le mur y pose la cible choisie ; faites glisser un point à côté d&apos;elle pour la déplacer le long du mur, en hauteur ou vers l&apos;eau</translation>
    </message>
    <message>
        <source>No project is open: open the one that was surveyed by this plan in the main window first.</source>
        <translation>Aucun projet n&apos;est ouvert : ouvrez d&apos;abord dans la fenêtre principale celui qui a été levé selon ce plan.</translation>
    </message>
    <message>
        <source>Finding the best plan</source>
        <translation>Recherche du meilleur plan</translation>
    </message>
    <message>
        <source>Simulating surveys</source>
        <translation>Simulation des levés</translation>
    </message>
    <message>
        <source>Comparing with the survey</source>
        <translation>Comparaison au levé</translation>
    </message>
    <message>
        <source>Writing the field plan</source>
        <translation>Écriture du plan de terrain</translation>
    </message>
    <message>
        <source>A plan needs a target and a line; add one of each before saving.</source>
        <translation>Un plan demande une cible et une ligne ; ajoutez-en une de chaque avant d&apos;enregistrer.</translation>
    </message>
    <message>
        <source>Starting the search</source>
        <translation>Démarrage de la recherche</translation>
    </message>
    <message>
        <source>Starting the surveys</source>
        <translation>Démarrage des levés</translation>
    </message>
    <message>
        <source>Fit view</source>
        <translation>Cadrer</translation>
    </message>
    <message>
        <source>{what} (deg)</source>
        <translation>{what} (°)</translation>
    </message>
    <message>
        <source>surveys</source>
        <translation>levés</translation>
    </message>
    <message>
        <source>{angle}: {ratio:n} ± {sigma:n}</source>
        <translation>{angle} : {ratio} ± {sigma}</translation>
    </message>
    <message>
        <source>once</source>
        <translation>une fois</translation>
    </message>
    <message>
        <source>{n:n} times</source>
        <translation>{n} fois</translation>
    </message>
    <message>
        <source>{n:n} m/s</source>
        <translation>{n} m/s</translation>
    </message>
    <message>
        <source>navigation, post-processed</source>
        <translation>navigation, post-traité</translation>
    </message>
    <message>
        <source>survey, post-processed</source>
        <translation>levé, post-traité</translation>
    </message>
    <message>
        <source>survey, RTK</source>
        <translation>levé, RTK</translation>
    </message>
    <message>
        <source>tactical, post-processed</source>
        <translation>tactique, post-traité</translation>
    </message>
    <message>
        <source>tactical, RTK</source>
        <translation>tactique, RTK</translation>
    </message>
    <message>
        <source>{heading:n} deg, {distance:n} m to starboard</source>
        <translation>{heading}°, à {distance} m à tribord</translation>
    </message>
    <message>
        <source>{heading:n} deg, {distance:n} m to port</source>
        <translation>{heading}°, à {distance} m à bâbord</translation>
    </message>
    <message>
        <source>Line {k:n} ({name})</source>
        <translation>Ligne {k} ({name})</translation>
    </message>
    <message>
        <source>Design a site…</source>
        <translation>Concevoir un site…</translation>
    </message>
    <message>
        <source>deg</source>
        <translation>°</translation>
    </message>
    <message>
        <source>kHz</source>
        <translation>kHz</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>min</source>
        <translation>min</translation>
    </message>
    <message>
        <source>POS</source>
        <translation>POS</translation>
    </message>
    <message>
        <source>simulate surveys: do the sigmas hold?</source>
        <translation>simuler des levés : les écarts-types tiennent-ils ?</translation>
    </message>
    <message>
        <source>compare the plan with the open project</source>
        <translation>comparer le plan au projet ouvert</translation>
    </message>
    <message>
        <source>F10</source>
        <translation>F10</translation>
    </message>
    <message>
        <source>F11</source>
        <translation>F11</translation>
    </message>
    <message>
        <source>{n:n} points looked at ({part:n} of {all:n})</source>
        <translation>{n} points examinés ({part} sur {all})</translation>
    </message>
    <message>
        <source>{message}, {n:n} surveys/s</source>
        <translation>{message}, {n} levés/s</translation>
    </message>
    <message>
        <source>{message}, {n:n} plans/s</source>
        <translation>{message}, {n} plans/s</translation>
    </message>
    <message>
        <source>Sensors of the plan</source>
        <translation>Capteurs du plan</translation>
    </message>
    <message>
        <source>The sigmas of what is chosen go into the plan; what is not chosen stays as it is.</source>
        <translation>Les écarts-types de ce qui est choisi passent dans le plan ; ce qui n&apos;est pas choisi reste tel quel.</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>Reprendre</translation>
    </message>
    <message>
        <source>From the sensor library…</source>
        <translation>De la bibliothèque de capteurs…</translation>
    </message>
    <message>
        <source>Take the sigmas of a scanner and of an INS/GNSS from the library</source>
        <translation>Reprendre de la bibliothèque les écarts-types d&apos;un scanneur et d&apos;un INS/GNSS</translation>
    </message>
    <message>
        <source>sensors</source>
        <translation>capteurs</translation>
    </message>
</context>
<context>
    <name>units</name>
    <message>
        <source>{n:n} ft</source>
        <translation>{n} ft</translation>
    </message>
    <message>
        <source>{n:n} ftUS</source>
        <translation>{n} ftUS</translation>
    </message>
    <message>
        <source>{n:n} mrad</source>
        <translation>{n} mrad</translation>
    </message>
    <message>
        <source>ft</source>
        <translation>ft</translation>
    </message>
    <message>
        <source>ftUS</source>
        <translation>ftUS</translation>
    </message>
    <message>
        <source>mrad</source>
        <translation>mrad</translation>
    </message>
</context>
<context>
    <name>gui/dialogs/settings.py</name>
    <message>
        <source>Angles</source>
        <translation>Angles</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Longueurs</translation>
    </message>
    <message>
        <source>Degrees</source>
        <translation>Degrés</translation>
    </message>
    <message>
        <source>Milliradians</source>
        <translation>Milliradians</translation>
    </message>
    <message>
        <source>Arc minutes and seconds</source>
        <translation>Minutes et secondes d&apos;arc</translation>
    </message>
    <message>
        <source>Metres and millimetres</source>
        <translation>Mètres et millimètres</translation>
    </message>
    <message>
        <source>Unit of the boresight, of attitudes and of their sigmas in the window. Headings and inclinations stay in degrees; files, reports and scripts have their own units</source>
        <translation>Unité des angles de visée, des attitudes et de leurs écarts-types dans la fenêtre. Les caps et les inclinaisons restent en degrés ; fichiers, rapports et scripts gardent leurs unités</translation>
    </message>
    <message>
        <source>Unit of lengths and distances in the window; files, reports and scripts stay metric</source>
        <translation>Unité des longueurs et des distances dans la fenêtre ; fichiers, rapports et scripts restent métriques</translation>
    </message>
    <message>
        <source>International feet (ft)</source>
        <translation>Pieds internationaux (ft)</translation>
    </message>
    <message>
        <source>US survey feet (ftUS)</source>
        <translation>Pieds d&apos;arpentage américains (ftUS)</translation>
    </message>
</context>
<context>
    <name>cache</name>
    <message>
        <source>Cache</source>
        <translation>Cache</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>Usual folder</source>
        <translation>Dossier habituel</translation>
    </message>
    <message>
        <source>Empty the cache…</source>
        <translation>Vider le cache…</translation>
    </message>
    <message>
        <source>Remove {title} from the library?</source>
        <translation>Retirer {title} de la bibliothèque ?</translation>
    </message>
    <message>
        <source>Its figures go for good, also where the settings are cancelled. Projects keep theirs.</source>
        <translation>Ses valeurs sont perdues pour de bon, même si les réglages sont annulés. Les projets gardent les leurs.</translation>
    </message>
    <message>
        <source>Remove…</source>
        <translation>Retirer…</translation>
    </message>
    <message>
        <source>Empty the cache?</source>
        <translation>Vider le cache ?</translation>
    </message>
    <message>
        <source>Empty</source>
        <translation>Vider</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>vide</translation>
    </message>
    <message>
        <source>{n:n} MB</source>
        <translation>{n} Mo</translation>
    </message>
    <message>
        <source>Folder for the cache</source>
        <translation>Dossier du cache</translation>
    </message>
    <message>
        <source>Another folder for the demo survey, compiled code and lists of fonts; projects stay where they are, and what lies in the former folder too</source>
        <translation>Un autre dossier pour le levé de démonstration, le code compilé et les listes de polices ; les projets restent où ils sont, et le contenu de l&apos;ancien dossier aussi</translation>
    </message>
    <message>
        <source>The folder for caches of the system</source>
        <translation>Le dossier de cache du système</translation>
    </message>
    <message>
        <source>Remove what the program can make again</source>
        <translation>Supprimer ce que le programme peut refaire</translation>
    </message>
    <message>
        <source>The demo survey is open; close it, then empty the cache.</source>
        <translation>Le levé de démonstration est ouvert ; fermez-le, puis videz le cache.</translation>
    </message>
    <message>
        <source>The demo survey goes, with what was picked in it, and code that is compiled again when it is needed. Projects, settings and sensors stay.</source>
        <translation>Le levé de démonstration disparaît, avec ce qui y a été désigné, ainsi que du code qui sera recompilé au besoin. Projets, paramètres et capteurs restent.</translation>
    </message>
</context>
<context>
    <name>study of visibility</name>
    <message>
        <source>Terrestrial</source>
        <translation>Terrestre</translation>
    </message>
    <message>
        <source>Marine</source>
        <translation>Marin</translation>
    </message>
    <message>
        <source>terrestrial</source>
        <translation>terrestre</translation>
    </message>
    <message>
        <source>marine</source>
        <translation>marin</translation>
    </message>
    <message>
        <source>Roll {n:n} deg</source>
        <translation>Roulis {n}°</translation>
    </message>
    <message>
        <source>Pitch {n:n} deg</source>
        <translation>Tangage {n}°</translation>
    </message>
    <message>
        <source>Yaw {n:n} deg</source>
        <translation>Lacet {n}°</translation>
    </message>
    <message>
        <source>Lever arm {axis:kept} {n:n} cm</source>
        <translation>Bras de levier {axis} {n} cm</translation>
    </message>
    <message>
        <source>Range offset {n:n} cm</source>
        <translation>Décalage de distance {n} cm</translation>
    </message>
    <message>
        <source>Scan-angle offset {n:n} deg</source>
        <translation>Décalage d&apos;angle de balayage {n}°</translation>
    </message>
    <message>
        <source>different</source>
        <translation>autre</translation>
    </message>
    <message>
        <source>the same</source>
        <translation>comme la thèse</translation>
    </message>
    <message>
        <source>The choice of table 3.2 lies near the board that faces the beams ({n:n} deg here), where a roll error moves points along it.</source>
        <translation>Le choix du tableau 3.2 est proche du panneau face aux faisceaux ({n}° ici), où une erreur de roulis déplace les points le long de celui-ci.</translation>
    </message>
    <message>
        <source>Appendix C.2.1 names {a:n} and then {b:n} deg for the same figure; {c:n} is the upper end of what it keeps, and so is the best here.</source>
        <translation>L&apos;annexe C.2.1 donne {a}° puis {b}° pour la même figure ; {c}° est la borne supérieure de ce qu&apos;elle retient, et c&apos;est aussi le meilleur ici.</translation>
    </message>
    <message>
        <source>The lines differ by {a:n} mm and {b:n} deg at {c:n} deg, {d:n} mm and {e:n} deg at {f:n} deg.</source>
        <translation>Les lignes diffèrent de {a} mm et {b}° à {c}°, de {d} mm et {e}° à {f}°.</translation>
    </message>
    <message>
        <source>Table 3.2 chooses an inclination that appendix C.2.6 does not keep ({a:n} to {b:n} deg).</source>
        <translation>Le tableau 3.2 choisit une inclinaison que l&apos;annexe C.2.6 ne retient pas ({a}° à {b}°).</translation>
    </message>
    <message>
        <source>At {n:n} deg parallel and diagonal lines meet the board at nearly equal angles, so that the offset shifts both alike.</source>
        <translation>À {n}°, les lignes parallèles et diagonales rencontrent le panneau sous des angles presque égaux, si bien que ce décalage les déplace de même.</translation>
    </message>
    <message>
        <source>With the scanner along the body axes this offset is a roll, to the last digit; the thesis has {a:n} deg for the one, {b:n} for the other, and {c:n} in appendix C.2.7, where the error is {d:n} and not {e:n} deg.</source>
        <translation>Avec le scanneur le long des axes du navire, ce décalage est un roulis, au dernier chiffre près ; la thèse a {a}° pour l&apos;un, {b}° pour l&apos;autre, et {c}° à l&apos;annexe C.2.7, où l&apos;erreur est de {d}° et non de {e}°.</translation>
    </message>
    <message>
        <source>A board that leans back shows roll more than an upright one, since beams climb to it by {n:n} deg; the thesis considers {a:n} to {b:n} deg only, and of these the upright one is best here too.</source>
        <translation>Un panneau penché en arrière montre mieux le roulis qu&apos;un panneau vertical, car les faisceaux y montent de {n}° ; la thèse ne considère que {a}° à {b}°, et parmi ces inclinaisons la verticale est ici aussi la meilleure.</translation>
    </message>
    <message>
        <source>Why is not known.</source>
        <translation>On ne sait pas pourquoi.</translation>
    </message>
    <message>
        <source>The lines differ by {a:n} mm and {b:n} deg at {c:n} deg.</source>
        <translation>Les lignes diffèrent de {a} mm et {b}° à {c}°.</translation>
    </message>
</context>
<context>
    <name>warnings</name>
    <message>
        <source>&amp;Warnings</source>
        <translation>Avert&amp;issements</translation>
    </message>
    <message>
        <source>All there is to be warned of; each leads to its cause</source>
        <translation>Tout ce dont il faut être averti ; chaque avertissement mène à sa cause</translation>
    </message>
    <message>
        <source>S&amp;teps</source>
        <translation>Étapes &amp;du travail</translation>
    </message>
    <message>
        <source>Go to step {n:n} of the workflow</source>
        <translation>Aller à l’étape {n} du travail</translation>
    </message>
    <message>
        <source>the warnings, all in one list</source>
        <translation>les avertissements, dans une seule liste</translation>
    </message>
    <message>
        <source>Ctrl + 1, 2, 3, 4, 5</source>
        <translation>Ctrl + 1, 2, 3, 4, 5</translation>
    </message>
    <message>
        <source>go to a step of the workflow</source>
        <translation>aller à une étape du travail</translation>
    </message>
    <message>
        <source>Serious</source>
        <translation>Grave</translation>
    </message>
    <message>
        <source>Look at this</source>
        <translation>À examiner</translation>
    </message>
    <message>
        <source>Taken for granted</source>
        <translation>Tenu pour acquis</translation>
    </message>
    <message>
        <source>Click, or press Enter, to go to the cause</source>
        <translation>Cliquer, ou appuyer sur Entrée, pour aller à la cause</translation>
    </message>
    <message>
        <source>{n:n} serious</source>
        <translation>graves : {n:n}</translation>
    </message>
    <message>
        <source>{n:n} to look at</source>
        <translation>à examiner : {n:n}</translation>
    </message>
    <message>
        <source>{n:n} assumptions</source>
        <translation>hypothèses : {n}</translation>
    </message>
    <message>
        <source>Click one, or press Enter on it, to go to its cause.</source>
        <translation>Cliquez sur un avertissement, ou appuyez sur Entrée, pour aller à sa cause.</translation>
    </message>
    <message>
        <source>Click to see them all (F12)</source>
        <translation>Cliquer pour les voir tous (F12)</translation>
    </message>
    <message>
        <source>Estimating again; these are the warnings from before the change.</source>
        <translation>Nouvelle estimation en cours ; ces avertissements sont ceux d&apos;avant la modification.</translation>
    </message>
    <message>
        <source>Open or make a project: its warnings appear here.</source>
        <translation>Ouvrez ou créez un projet : ses avertissements apparaissent ici.</translation>
    </message>
    <message>
        <source>Nothing to warn of. What the files, picks and figures give cause for appears here.</source>
        <translation>Aucun avertissement. Ce que les fichiers, les pointés et les chiffres donnent à signaler apparaît ici.</translation>
    </message>
    <message>
        <source>1 warning</source>
        <translation>1 avertissement</translation>
    </message>
    <message>
        <source>{n:n} warnings</source>
        <translation>{n:n} avertissements</translation>
    </message>
    <message>
        <source>No warnings</source>
        <translation>Aucun avertissement</translation>
    </message>
</context>
<context>
    <name>mounting sketch</name>
    <message>
        <source>From above</source>
        <translation>Vu de dessus</translation>
    </message>
    <message>
        <source>From starboard</source>
        <translation>Vu de tribord</translation>
    </message>
    <message>
        <source>bow +X</source>
        <translation>étrave +X</translation>
    </message>
    <message>
        <source>stern</source>
        <translation>poupe</translation>
    </message>
    <message>
        <source>port +Y</source>
        <translation>bâbord +Y</translation>
    </message>
    <message>
        <source>up +Z</source>
        <translation>haut +Z</translation>
    </message>
    <message>
        <source>Where the scanner sits on the vessel</source>
        <translation>Emplacement du scanneur sur le navire</translation>
    </message>
    <message>
        <source>The scanner at its lever arm, to scale; the vessel about it is of no particular size. Grey: axes of the body. Coloured: axes of the scanner as turned by the prior boresight, small turns shown larger.</source>
        <translation>Le scanneur au bout de son bras de levier, à l&apos;échelle ; le navire autour n&apos;a pas de taille particulière. En gris : axes du corps. En couleur : axes du scanneur tournés des angles de visée a priori, les petites rotations étant agrandies.</translation>
    </message>
</context>
<context>
    <name>manual</name>
    <message>
        <source>Ma&amp;nual</source>
        <translation>&amp;Manuel</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Manuel</translation>
    </message>
    <message>
        <source>The manual in the browser; it needs no network</source>
        <translation>Le manuel dans le navigateur ; il n&apos;a pas besoin de réseau</translation>
    </message>
    <message>
        <source>Opening the manual</source>
        <translation>Ouverture du manuel</translation>
    </message>
    <message>
        <source>This &amp;step in the manual</source>
        <translation>Cette é&amp;tape dans le manuel</translation>
    </message>
    <message>
        <source>This step</source>
        <translation>Cette étape</translation>
    </message>
    <message>
        <source>What the manual says of the step that is open</source>
        <translation>Ce que le manuel dit de l&apos;étape ouverte</translation>
    </message>
</context>
<context>
    <name>window</name>
    <message>
        <source>From {low:kept} to {high:kept}</source>
        <translation>De {low} à {high}</translation>
    </message>
    <message>
        <source>{typed:kept} is not between {low:kept} and {high:kept}: {text:kept} is kept</source>
        <translation>{typed} n’est pas entre {low} et {high} : {text} est gardé</translation>
    </message>
</context>
<context>
    <name>methods dialog</name>
    <message>
        <source>Compare with other &amp;methods…</source>
        <translation>Comparer à d’autres &amp;méthodes…</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>Méthodes</translation>
    </message>
    <message>
        <source>What the validation planes and the scene itself say of the boresight</source>
        <translation>Ce que les plans de validation et la scène elle-même disent des angles de visée</translation>
    </message>
    <message>
        <source>What the boresight was found with</source>
        <translation>Ce avec quoi les angles de visée ont été trouvés</translation>
    </message>
    <message>
        <source>That the answer rests on</source>
        <translation>Sur lesquelles repose la réponse</translation>
    </message>
    <message>
        <source>Targets, planes, natural surfaces or objects that it rests on</source>
        <translation>Cibles, plans, surfaces naturelles ou objets sur lesquels elle repose</translation>
    </message>
    <message>
        <source>Roll off (sigma)</source>
        <translation>Écart de roulis (sigma)</translation>
    </message>
    <message>
        <source>Pitch off (sigma)</source>
        <translation>Écart de tangage (sigma)</translation>
    </message>
    <message>
        <source>Yaw off (sigma)</source>
        <translation>Écart de lacet (sigma)</translation>
    </message>
    <message>
        <source>Difference of roll from the first row, over its sigma</source>
        <translation>Écart de roulis par rapport à la première ligne du tableau, sur son sigma</translation>
    </message>
    <message>
        <source>Difference of pitch from the first row, over its sigma</source>
        <translation>Écart de tangage par rapport à la première ligne du tableau, sur son sigma</translation>
    </message>
    <message>
        <source>Difference of yaw from the first row, over its sigma</source>
        <translation>Écart de lacet par rapport à la première ligne du tableau, sur son sigma</translation>
    </message>
    <message>
        <source>Answers of other methods</source>
        <translation>Réponses des autres méthodes</translation>
    </message>
    <message>
        <source>Comparison with other methods</source>
        <translation>Comparaison avec d’autres méthodes</translation>
    </message>
    <message>
        <source>What other methods say of the same lines; the targets take part in none of them. An answer that two methods give can be trusted more. The answers are kept with the project and stand in the report.</source>
        <translation>Ce que d’autres méthodes disent des mêmes lignes ; les cibles n’ont part à aucune. Une réponse que donnent deux méthodes est plus digne de confiance. Les réponses sont gardées avec le projet et figurent dans le rapport.</translation>
    </message>
    <message>
        <source>Run other methods</source>
        <translation>Lancer les autres méthodes</translation>
    </message>
    <message>
        <source>Adjust the validation planes and the surfaces of the scene, and do a patch test on objects looked for; one undo step</source>
        <translation>Compenser les plans de validation et les surfaces de la scène, et faire un patch test sur des objets recherchés ; une seule étape à annuler</translation>
    </message>
    <message>
        <source>Not asked yet: {what}</source>
        <translation>Pas encore interrogée : {what}</translation>
    </message>
    <message>
        <source>Asking other methods</source>
        <translation>Interrogation d’autres méthodes</translation>
    </message>
    <message>
        <source>alternative methods</source>
        <translation>méthodes alternatives</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Cibles</translation>
    </message>
</context>
<context>
    <name>line quality dialog</name>
    <message>
        <source>&amp;Differences between lines…</source>
        <translation>Écarts entre &amp;lignes…</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Écarts</translation>
    </message>
    <message>
        <source>How far every two lines are apart where the scene is flat, as shown</source>
        <translation>De combien les lignes s’écartent deux à deux là où la scène est plane, telles que montrées</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Première</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>Seconde</translation>
    </message>
    <message>
        <source>The line whose normals are taken</source>
        <translation>La ligne dont on prend les normales</translation>
    </message>
    <message>
        <source>The line that is compared with it</source>
        <translation>La ligne qu’on lui compare</translation>
    </message>
    <message>
        <source>Facing</source>
        <translation>Orientation</translation>
    </message>
    <message>
        <source>Level: within 10 deg of the horizontal; upright: of the vertical</source>
        <translation>De niveau : à 10 deg près de l’horizontale ; vertical : à 10 deg près de la verticale</translation>
    </message>
    <message>
        <source>Flat places that both lines saw</source>
        <translation>Endroits plans que les deux lignes ont vus</translation>
    </message>
    <message>
        <source>Median (mm)</source>
        <translation>Médiane (mm)</translation>
    </message>
    <message>
        <source>Along the normal, positive where the second is nearer to the vessel</source>
        <translation>Le long de la normale, positif où la seconde est plus près du navire</translation>
    </message>
    <message>
        <source>RMSD (mm)</source>
        <translation>EMQ (mm)</translation>
    </message>
    <message>
        <source>Root mean square of the differences</source>
        <translation>Écart quadratique moyen</translation>
    </message>
    <message>
        <source>Robust (mm)</source>
        <translation>Robuste (mm)</translation>
    </message>
    <message>
        <source>1.4826 times the median absolute deviation from the median</source>
        <translation>1,4826 fois l’écart absolu médian à la médiane</translation>
    </message>
    <message>
        <source>95 % (mm)</source>
        <translation>95 % (mm)</translation>
    </message>
    <message>
        <source>Largest (mm)</source>
        <translation>Plus grand (mm)</translation>
    </message>
    <message>
        <source>Of the differences without their signs</source>
        <translation>Des écarts sans leurs signes</translation>
    </message>
    <message>
        <source>the prior boresight</source>
        <translation>les angles de visée a priori</translation>
    </message>
    <message>
        <source>the estimated boresight</source>
        <translation>les angles de visée estimés</translation>
    </message>
    <message>
        <source>Differences between lines</source>
        <translation>Écarts entre lignes</translation>
    </message>
    <message>
        <source>How far every two lines are apart where the scene is flat, measured along the normal, with the lines placed by {which}. Nothing is changed by it.</source>
        <translation>De combien les lignes s’écartent deux à deux là où la scène est plane, mesuré le long de la normale, les lignes étant placées avec {which}. Rien n’en est changé.</translation>
    </message>
    <message>
        <source>Places where lines are apart, from above</source>
        <translation>Endroits où les lignes s’écartent, vus d’en haut</translation>
    </message>
    <message>
        <source>Comparing the lines</source>
        <translation>Comparaison des lignes</translation>
    </message>
    <message>
        <source>all</source>
        <translation>toutes</translation>
    </message>
    <message>
        <source>level</source>
        <translation>de niveau</translation>
    </message>
    <message>
        <source>upright</source>
        <translation>vertical</translation>
    </message>
    <message>
        <source>sloped</source>
        <translation>incliné</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>&amp;Look in:</source>
        <translation>&amp;Regarder dans :</translation>
    </message>
    <message>
        <source>Files of &amp;type:</source>
        <translation>Fichiers de &amp;type :</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Lecteur</translation>
    </message>
    <message>
        <source>File Folder</source>
        <translation>Dossier de fichiers</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Raccourci</translation>
    </message>
    <message>
        <source>Alias</source>
        <translation>Alias</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Inconnu</translation>
    </message>
</context>
<context>
    <name>options of points</name>
    <message>
        <source>Withheld points</source>
        <translation>Points retenus (withheld)</translation>
    </message>
    <message>
        <source>Excluded classes</source>
        <translation>Classes exclues</translation>
    </message>
    <message>
        <source>Only points with</source>
        <translation>Seulement les points avec</translation>
    </message>
    <message>
        <source>Largest range (m)</source>
        <translation>Portée maximale (m)</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>exclus</translation>
    </message>
    <message>
        <source>at the full hour</source>
        <translation>à l&apos;heure pleine</translation>
    </message>
</context>
</TS>
