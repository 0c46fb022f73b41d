<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR" sourcelanguage="en">
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
        <source>Language · &amp;Langue</source>
        <translation>&amp;Langue · Language</translation>
    </message>
    <message>
        <source>&amp;English</source>
        <translation>&amp;English</translation>
    </message>
    <message>
        <source>&amp;Français</source>
        <translation>&amp;Français</translation>
    </message>
    <message>
        <source>The window in English</source>
        <translation>La fenêtre en anglais</translation>
    </message>
    <message>
        <source>The window changes when the running task has ended</source>
        <translation>La fenêtre changera quand la tâche en cours sera terminée</translation>
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
        <source>Bring it back</source>
        <translation>Le récupérer</translation>
    </message>
    <message>
        <source>Forget it</source>
        <translation>L&apos;oublier</translation>
    </message>
    <message>
        <source>{name} is open in another window already.</source>
        <translation>{name} est déjà ouvert dans une autre fenêtre.</translation>
    </message>
    <message>
        <source>It is open in {where:kept}. Of two windows the one that saves last overwrites the other.</source>
        <translation>Il est ouvert ici : {where}. De deux fenêtres, celle qui enregistre en dernier écrase l&apos;autre.</translation>
    </message>
    <message>
        <source>Close it here</source>
        <translation>Le fermer ici</translation>
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
        <source>Lines are added to the open project and checked against its trajectory; what has been picked stays. Files of another survey make a new project.</source>
        <translation>Les lignes sont ajoutées au projet ouvert et confrontées à sa trajectoire ; ce qui a été choisi reste. Les fichiers d&apos;un autre levé font un nouveau projet.</translation>
    </message>
    <message>
        <source>Add to {name}</source>
        <translation>Ajouter à {name}</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>Nouveau projet</translation>
    </message>
    <message>
        <source>Save the changes to {name}?</source>
        <translation>Enregistrer les modifications de {name} ?</translation>
    </message>
    <message>
        <source>Without saving, what was picked and computed since is lost.</source>
        <translation>Sans enregistrement, ce qui a été choisi et calculé depuis est perdu.</translation>
    </message>
    <message>
        <source>{name} was found and is not accepted yet.</source>
        <translation>{name} a été trouvé et n&apos;est pas encore accepté.</translation>
    </message>
    <message>
        <source>Only accepted targets take part in the adjustment.</source>
        <translation>Seules les cibles acceptées prennent part à l&apos;ajustement.</translation>
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
        <source>Without saving, what was changed since is lost.</source>
        <translation>Sans enregistrement, ce qui a été modifié depuis est perdu.</translation>
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
</TS>
