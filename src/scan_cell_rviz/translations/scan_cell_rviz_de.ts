<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>JointTurn</name>
    <message>
        <source>%1 turns most along the path: from %2 to %3 degrees</source>
        <translation>%1 dreht auf der Bahn am weitesten: von %2 bis %3 Grad</translation>
    </message>
    <message>
        <source>; its range is %1 to %2 degrees.</source>
        <translation>; sein Bereich ist %1 bis %2 Grad.</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>all outputs off</source>
        <translation>alle Ausgänge aus</translation>
    </message>
    <message>
        <source>output %1 on</source>
        <translation>Ausgang %1 an</translation>
    </message>
    <message>
        <source>%1: %2 mm/s, %3</source>
        <translation>%1: %2 mm/s, %3</translation>
    </message>
    <message>
        <source>on the way to or from the path</source>
        <translation>auf dem Weg zur Bahn oder von ihr weg</translation>
    </message>
    <message>
        <source>waypoint %1</source>
        <translation>Bahnpunkt %1</translation>
    </message>
    <message>
        <source>
The robot does not get there.</source>
        <translation>
Der Roboter kommt nicht dorthin.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source> degrees</source>
        <translation> Grad</translation>
    </message>
    <message>
        <source>%1 poses%2; %3 (dark) to %4 mm/s (yellow), to the path and away grey</source>
        <translation>%1 Posen%2; %3 (dunkel) bis %4 mm/s (gelb), zur Bahn und zurück grau</translation>
    </message>
    <message>
        <source> of the dry run</source>
        <translation> des Trockenlaufs</translation>
    </message>
    <message>
        <source>none was asked for</source>
        <translation>es wurde keine verlangt</translation>
    </message>
    <message>
        <source>one came of %1, not of this run</source>
        <translation>es kam eine von %1, nicht von diesem Lauf</translation>
    </message>
</context>
<context>
    <name>Signs</name>
    <message>
        <source>1 day</source>
        <translation>1 Tag</translation>
    </message>
    <message>
        <source>%1 days</source>
        <translation>%1 Tage</translation>
    </message>
</context>
<context>
    <name>UnitsShown</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> deg</source>
        <translation> Grad</translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::Band</name>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Lasers</source>
        <translation>Laser</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Zelle</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::BrushTool</name>
    <message>
        <source>Brush: hold the left button and go over the points.</source>
        <translation>Pinsel: linke Taste halten und über die Punkte fahren.</translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::CellLink</name>
    <message>
        <source>%1, %2 frames, %3 points</source>
        <translation>%1, %2 Bilder, %3 Punkte</translation>
    </message>
    <message>
        <source>The cell is busy: wait until it is free.</source>
        <translation>Die Zelle ist belegt: warten, bis sie frei ist.</translation>
    </message>
    <message>
        <source>%1 is not running: start the cell with recipes:=FOLDER.</source>
        <translation>%1 läuft nicht: die Zelle mit recipes:=ORDNER starten.</translation>
    </message>
    <message>
        <source>dry run: %1</source>
        <translation>Trockenlauf: %1</translation>
    </message>
    <message>
        <source>%1, %2 waypoints passed</source>
        <translation>%1, %2 Wegpunkte durchfahren</translation>
    </message>
    <message>
        <source>There is no recipe in %1 yet. This command makes that of the demo&apos;s part; then press Refresh. Step 4 of the README says what it needs.</source>
        <translation>In %1 gibt es noch kein Rezept. Dieser Befehl macht das für das Teil der Demo; dann „Neu laden“ drücken. Schritt 4 der README sagt, was er braucht.</translation>
    </message>
    <message>
        <source>%1 is not running: start the cell with recipes:=FOLDER. The folder need not be there: this command makes it, with the recipe of the demo&apos;s part. Step 4 of the README says what it needs.</source>
        <translation>%1 läuft nicht: die Zelle mit recipes:=ORDNER starten. Den Ordner muss es nicht geben: dieser Befehl macht ihn, mit dem Rezept für das Teil der Demo. Schritt 4 der README sagt, was er braucht.</translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::CleanPage</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>R&amp;edo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Dr&amp;op all</source>
        <translation>Alle ver&amp;werfen</translation>
    </message>
    <message>
        <source>Sho&amp;w hidden</source>
        <translation>Verborgenes &amp;zeigen</translation>
    </message>
    <message>
        <source>Save into the &amp;recipe</source>
        <translation>Ins Re&amp;zept sichern</translation>
    </message>
    <message>
        <source>Delete what is in the shape</source>
        <translation>Löschen, was in der Form liegt</translation>
    </message>
    <message>
        <source>Keep only what is in the shape</source>
        <translation>Nur behalten, was in der Form liegt</translation>
    </message>
    <message>
        <source>Hide what is in the shape</source>
        <translation>Verbergen, was in der Form liegt</translation>
    </message>
    <message>
        <source>Show only what is in the shape</source>
        <translation>Nur zeigen, was in der Form liegt</translation>
    </message>
    <message>
        <source>Hidden points are out of view, and out of the way of brush, clicks and clusters. They are still part of the scan: an edit whose shape they are in takes them, too</source>
        <translation>Verborgene Punkte sind nicht zu sehen und stehen Pinsel, Klicks und Haufen nicht im Weg. Sie gehören weiter zum Scan: eine Änderung, in deren Form sie liegen, nimmt auch sie</translation>
    </message>
    <message>
        <source>How far a polygon goes before and behind the first place (0.1 to 10000 mm)</source>
        <translation>Wie weit ein Polygon vor und hinter die erste Stelle reicht (0,1 bis 10000 mm)</translation>
    </message>
    <message>
        <source>Of the brush (0.1 to 10000 mm)</source>
        <translation>Des Pinsels (0,1 bis 10000 mm)</translation>
    </message>
    <message>
        <source>Points farther apart are two clusters (0.1 to 10000 mm)</source>
        <translation>Punkte mit größerem Abstand sind zwei Haufen (0,1 bis 10000 mm)</translation>
    </message>
    <message>
        <source>Edits in force</source>
        <translation>Geltende Änderungen</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Bo&amp;x</source>
        <translation>&amp;Quader</translation>
    </message>
    <message>
        <source>&amp;Polygon</source>
        <translation>&amp;Polygon</translation>
    </message>
    <message>
        <source>P&amp;lane</source>
        <translation>&amp;Ebene</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>P&amp;insel</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Apply the box</source>
        <translation>Quader an&amp;wenden</translation>
    </message>
    <message>
        <source>First drag its arrows, rings and faces in the view</source>
        <translation>Vorher in der Ansicht an seinen Pfeilen, Ringen und Flächen ziehen</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>Ti&amp;efe</translation>
    </message>
    <message>
        <source>Cluster &amp;gap</source>
        <translation>Haufena&amp;bstand</translation>
    </message>
    <message>
        <source>%1 of %2 points stay.</source>
        <translation>%1 von %2 Punkten bleiben.</translation>
    </message>
    <message>
        <source> %1 of them are hidden.</source>
        <translation> %1 davon sind verborgen.</translation>
    </message>
    <message>
        <source>No scan is in view: scan a part, or choose a run.</source>
        <translation>Kein Scan zu sehen: ein Teil scannen oder einen Lauf wählen.</translation>
    </message>
    <message>
        <source>Ta&amp;ke over the recipe&apos;s edits (%1)</source>
        <translation>Än&amp;derungen des Rezepts übernehmen (%1)</translation>
    </message>
    <message>
        <source>&amp;Cluster</source>
        <translation>&amp;Haufen</translation>
    </message>
    <message>
        <source>Brus&amp;h radius</source>
        <translation>Pinselr&amp;adius</translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::ClusterTool</name>
    <message>
        <source>Cluster: click a point; everything connected to it is deleted, or alone is kept.</source>
        <translation>Haufen: einen Punkt anklicken; alles, was mit ihm zusammenhängt, wird gelöscht oder allein behalten.</translation>
    </message>
    <message>
        <source>No point is there. </source>
        <translation>Dort ist kein Punkt. </translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::DesignPage</name>
    <message>
        <source>%1 waypoints in %2 segments, %3 mm long</source>
        <translation>%1 Wegpunkte in %2 Abschnitten, %3 mm lang</translation>
    </message>
    <message>
        <source>Pic&amp;k in the view</source>
        <translation>In der &amp;Ansicht wählen</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>An&amp;sicht drehen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>R&amp;edo</source>
        <translation>&amp;Wieder</translation>
    </message>
    <message>
        <source>&amp;Clear</source>
        <translation>&amp;Leeren</translation>
    </message>
    <message>
        <source>&amp;Make the path</source>
        <translation>&amp;Bahn erzeugen</translation>
    </message>
    <message>
        <source>Save as a ne&amp;w recipe</source>
        <translation>Als neues Rezept s&amp;ichern</translation>
    </message>
    <message>
        <source>Whose reference the path is made on</source>
        <translation>Auf dessen Referenz die Bahn entsteht</translation>
    </message>
    <message>
        <source>through picked places</source>
        <translation>durch gewählte Stellen</translation>
    </message>
    <message>
        <source>along the edge</source>
        <translation>entlang der Kante</translation>
    </message>
    <message>
        <source>a raster</source>
        <translation>ein Raster</translation>
    </message>
    <message>
        <source>Clicks on the reference become places of the path, in their order</source>
        <translation>Klicks auf die Referenz werden Stellen der Bahn, in ihrer Reihenfolge</translation>
    </message>
    <message>
        <source>The mouse turns the view</source>
        <translation>Die Maus dreht die Ansicht</translation>
    </message>
    <message>
        <source>Of the new recipe and its folder</source>
        <translation>Des neuen Rezepts und seines Ordners</translation>
    </message>
    <message>
        <source>A recipe as the one above, but with this path; it counts as made, not proven</source>
        <translation>Ein Rezept wie das obige, aber mit dieser Bahn; es gilt als erstellt, nicht als bewährt</translation>
    </message>
    <message>
        <source>&amp;Reference of</source>
        <translation>&amp;Referenz von</translation>
    </message>
    <message>
        <source>W&amp;ay</source>
        <translation>&amp;Verfahren</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>Saved as %1: prove it, then scan a part.</source>
        <translation>Gesichert als %1: erst bewähren, dann ein Teil scannen.</translation>
    </message>
    <message>
        <source>Choose the recipe whose reference it is.</source>
        <translation>Das Rezept wählen, dessen Referenz gemeint ist.</translation>
    </message>
    <message>
        <source>%1 places picked</source>
        <translation>%1 Stellen gewählt</translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::EditDisplay</name>
    <message>
        <source>%1 points stay</source>
        <translation>%1 Punkte bleiben</translation>
    </message>
    <message>
        <source>being drawn</source>
        <translation>wird gezeichnet</translation>
    </message>
    <message>
        <source>; %1 % of all are drawn, as many as this computer draws in time</source>
        <translation>; %1 % aller Punkte sind gezeichnet: so viele, wie dieser Rechner rechtzeitig zeichnet</translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::EditSession</name>
    <message>
        <source>keep only %1: %2 points went</source>
        <translation>nur behalten, %1: %2 Punkte weg</translation>
    </message>
    <message>
        <source>delete %1: %2 points went</source>
        <translation>löschen, %1: %2 Punkte weg</translation>
    </message>
    <message>
        <source>, %1 of them hidden</source>
        <translation>, %1 davon verborgen</translation>
    </message>
    <message>
        <source>%1: %2 points would go; %3</source>
        <translation>%1: %2 Punkte gingen weg; %3</translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::EditTool</name>
    <message>
        <source>The frame of the scan is not known to rviz.</source>
        <translation>rviz kennt das Koordinatensystem des Scans nicht.</translation>
    </message>
    <message>
        <source>No scan is in view: scan a part, or choose a run.</source>
        <translation>Kein Scan zu sehen: ein Teil scannen oder einen Lauf wählen.</translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::FitPage</name>
    <message>
        <source>✔ Accepted</source>
        <translation>✔ Angenommen</translation>
    </message>
    <message>
        <source>✖ Refused: %1</source>
        <translation>✖ Abgelehnt: %1</translation>
    </message>
    <message>
        <source>! Unusable: %1</source>
        <translation>! Unbrauchbar: %1</translation>
    </message>
    <message>
        <source>Nobody has decided yet.</source>
        <translation>Noch hat niemand entschieden.</translation>
    </message>
    <message>
        <source>Approved by %1</source>
        <translation>Freigegeben von %1</translation>
    </message>
    <message>
        <source>Refused by %1</source>
        <translation>Abgelehnt von %1</translation>
    </message>
    <message>
        <source>&amp;Approve</source>
        <translation>&amp;Freigeben</translation>
    </message>
    <message>
        <source>Re&amp;fuse</source>
        <translation>Ab&amp;lehnen</translation>
    </message>
    <message>
        <source>Open re&amp;port</source>
        <translation>&amp;Bericht öffnen</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Waypoints that the verdict is about</source>
        <translation>Bahnpunkte, um die es im Urteil geht</translation>
    </message>
    <message>
        <source>What the verdict is about; the view turns to the chosen one</source>
        <translation>Worum es im Urteil geht; die Ansicht wendet sich dem gewählten zu</translation>
    </message>
    <message>
        <source>Who decides; kept with the run</source>
        <translation>Wer entscheidet; bleibt beim Lauf</translation>
    </message>
    <message>
        <source>Why; kept with the run</source>
        <translation>Warum; bleibt beim Lauf</translation>
    </message>
    <message>
        <source>Your &amp;name</source>
        <translation>Ihr &amp;Name</translation>
    </message>
    <message>
        <source>N&amp;ote</source>
        <translation>N&amp;otiz</translation>
    </message>
    <message>
        <source>No part was scanned yet.</source>
        <translation>Es wurde noch kein Teil gescannt.</translation>
    </message>
    <message>
        <source>waypoint %1 at %2, %3, %4 mm</source>
        <translation>Bahnpunkt %1 bei %2, %3, %4 mm</translation>
    </message>
    <message>
        <source>The path may be worked; type your name first</source>
        <translation>Der Pfad darf gefahren werden; zuerst den Namen eintragen</translation>
    </message>
    <message>
        <source>The path may not be worked; type your name first</source>
        <translation>Der Pfad darf nicht gefahren werden; zuerst den Namen eintragen</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Grenze</translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::HistoryPage</name>
    <message>
        <source>accepted</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>abgelehnt: %1</translation>
    </message>
    <message>
        <source>unusable: %1</source>
        <translation>unbrauchbar: %1</translation>
    </message>
    <message>
        <source>Started (UTC)</source>
        <translation>Beginn (UTC)</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Decision</source>
        <translation>Entscheidung</translation>
    </message>
    <message>
        <source>&amp;Refresh</source>
        <translation>Ne&amp;u laden</translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::PartPage</name>
    <message>
        <source>proven %1</source>
        <translation>bewährt %1</translation>
    </message>
    <message>
        <source>never proven</source>
        <translation>nie bewährt</translation>
    </message>
    <message>
        <source>out of date: %1</source>
        <translation>veraltet: %1</translation>
    </message>
    <message>
        <source>&amp;Scan and fit</source>
        <translation>&amp;Scannen und anpassen</translation>
    </message>
    <message>
        <source>Part types</source>
        <translation>Teilearten</translation>
    </message>
    <message>
        <source>Kept with the run, such as the part&apos;s serial number</source>
        <translation>Bleibt beim Lauf, etwa die Seriennummer des Teils</translation>
    </message>
    <message>
        <source>Moves the robot: scans the part, fits the path of its type to it and writes the report</source>
        <translation>Bewegt den Roboter: scannt das Teil, passt ihm die Bahn seiner Art an und schreibt den Bericht</translation>
    </message>
    <message>
        <source>&amp;Refresh</source>
        <translation>Ne&amp;u laden</translation>
    </message>
    <message>
        <source>&amp;Note</source>
        <translation>&amp;Notiz</translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::PassSession</name>
    <message>
        <source>start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>end</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>via</source>
        <translation>Zwischenpunkt</translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::PassesPage</name>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>NO</source>
        <translation>NEIN</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>&amp;Drag in the view</source>
        <translation>In der &amp;Ansicht ziehen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>R&amp;edo</source>
        <translation>&amp;Wieder</translation>
    </message>
    <message>
        <source>&amp;Can the robot do it?</source>
        <translation>&amp;Kann es der Roboter?</translation>
    </message>
    <message>
        <source>&amp;Save into the recipe</source>
        <translation>Ins Rezept s&amp;ichern</translation>
    </message>
    <message>
        <source>Whose scan program it is</source>
        <translation>Wessen Scanprogramm es ist</translation>
    </message>
    <message>
        <source>Poses of the flange in each pass</source>
        <translation>Posen des Flanschs in jeder Bahn</translation>
    </message>
    <message>
        <source>Choose one: its pass can be dragged, and the view turns there</source>
        <translation>Eine wählen: ihre Bahn lässt sich ziehen, und die Ansicht dreht sich dorthin</translation>
    </message>
    <message>
        <source>Pass</source>
        <translation>Bahn</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Pose</translation>
    </message>
    <message>
        <source>x [mm]</source>
        <translation>x [mm]</translation>
    </message>
    <message>
        <source>y [mm]</source>
        <translation>y [mm]</translation>
    </message>
    <message>
        <source>z [mm]</source>
        <translation>z [mm]</translation>
    </message>
    <message>
        <source>Reachable</source>
        <translation>Erreichbar</translation>
    </message>
    <message>
        <source>Arrows and rings at the poses of the pass that is chosen; nothing moves</source>
        <translation>Pfeile und Ringe an den Posen der gewählten Bahn; nichts bewegt sich</translation>
    </message>
    <message>
        <source>Asks the cell again, from where the robot stands now</source>
        <translation>Fragt die Zelle neu, von dort, wo der Roboter jetzt steht</translation>
    </message>
    <message>
        <source>The recipe then counts as made anew, not proven</source>
        <translation>Das Rezept gilt dann als neu erstellt, nicht als bewährt</translation>
    </message>
    <message>
        <source>&amp;Recipe</source>
        <translation>&amp;Rezept</translation>
    </message>
    <message>
        <source>%1 has no scan program.</source>
        <translation>%1 hat kein Scanprogramm.</translation>
    </message>
    <message>
        <source>asked once nothing is under way</source>
        <translation>wird gefragt, sobald nichts mehr läuft</translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::PathDisplay</name>
    <message>
        <source>%1 waypoints, %2 edited, %3 deleted</source>
        <translation>%1 Wegpunkte, %2 bearbeitet, %3 gelöscht</translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::PathPage</name>
    <message>
        <source>&amp;Move</source>
        <translation>&amp;Verschieben</translation>
    </message>
    <message>
        <source>&amp;Set</source>
        <translation>&amp;Setzen</translation>
    </message>
    <message>
        <source>&amp;Add after</source>
        <translation>D&amp;anach einfügen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>R&amp;edo</source>
        <translation>Wi&amp;eder</translation>
    </message>
    <message>
        <source>Dr&amp;op all</source>
        <translation>Alles ver&amp;werfen</translation>
    </message>
    <message>
        <source>Waypoints of the adapted path</source>
        <translation>Wegpunkte des angepassten Pfads</translation>
    </message>
    <message>
        <source>Choose one, or a row of them with Shift; the view turns there</source>
        <translation>Einen wählen, oder mit Umschalt eine Reihe; die Ansicht dreht sich dorthin</translation>
    </message>
    <message>
        <source>Edits of the path in force</source>
        <translation>Geltende Änderungen am Pfad</translation>
    </message>
    <message>
        <source>Why; kept with the run</source>
        <translation>Warum; wird mit dem Lauf aufgehoben</translation>
    </message>
    <message>
        <source>Adapts the part again from its files, does the edits, and makes programs and report: a new run, which needs a dry run of its own</source>
        <translation>Passt den Pfad aus den Dateien des Laufs noch einmal an, macht die Änderungen, Programme und Bericht: ein neuer Lauf, der seinen eigenen Trockenlauf braucht</translation>
    </message>
    <message>
        <source>Half way to the next one of its segment; after the last one, where it is</source>
        <translation>Auf halbem Weg zum nächsten seines Abschnitts; nach dem letzten, wo dieser ist</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Along %1 (-1000 to 1000 mm)</source>
        <translation>Entlang %1 (-1000 bis 1000 mm)</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>um %1</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Right-handed (-180 to 180 degrees)</source>
        <translation>Rechtshändig (-180 bis 180 Grad)</translation>
    </message>
    <message>
        <source>Process value, such as speed or an output. A value that the path does not have yet is first set to 0 for all waypoints except the selected ones</source>
        <translation>Prozesswert, etwa Geschwindigkeit oder ein Ausgang. Einer, den der Pfad nicht hat, wird zuerst für alle Wegpunkte gesetzt: auf 0, außer für die gewählten</translation>
    </message>
    <message>
        <source>As the path&apos;s file has it, without a unit</source>
        <translation>Wie ihn die Datei des Pfads hat, ohne Einheit</translation>
    </message>
    <message>
        <source>Axes of the tool at each waypoint</source>
        <translation>Achsen des Werkzeugs an jedem Wegpunkt</translation>
    </message>
    <message>
        <source>Axes of the path&apos;s frame</source>
        <translation>Achsen des Rahmens, in dem der Pfad liegt</translation>
    </message>
    <message>
        <source>&amp;Pick in the view</source>
        <translation>In der Ansicht &amp;picken</translation>
    </message>
    <message>
        <source>Click a waypoint in the view; its handles move and turn it</source>
        <translation>In der Ansicht auf einen Wegpunkt klicken; seine Griffe verschieben und drehen ihn</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>Ansi&amp;cht</translation>
    </message>
    <message>
        <source>The mouse turns the view, and drags the handles of the waypoint</source>
        <translation>Die Maus dreht die Ansicht und zieht an den Griffen des Wegpunkts</translation>
    </message>
    <message>
        <source>A&amp;xes</source>
        <translation>A&amp;chsen</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Um</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>&amp;Note</source>
        <translation>&amp;Notiz</translation>
    </message>
    <message>
        <source>%1 waypoints</source>
        <translation>%1 Wegpunkte</translation>
    </message>
    <message>
        <source>No adapted path is in view: choose an accepted run.</source>
        <translation>Kein angepasster Pfad ist zu sehen: einen angenommenen Lauf wählen.</translation>
    </message>
    <message>
        <source>Tu&amp;rn</source>
        <translation>D&amp;rehen</translation>
    </message>
    <message>
        <source>Make it a run of its o&amp;wn</source>
        <translation>Einen e&amp;igenen Lauf daraus machen</translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::PathTable</name>
    <message>
        <source>added</source>
        <translation>eingefügt</translation>
    </message>
    <message>
        <source>edited</source>
        <translation>bearbeitet</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Abschnitt</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Von Hand</translation>
    </message>
    <message>
        <source>x [mm]</source>
        <translation>x [mm]</translation>
    </message>
    <message>
        <source>y [mm]</source>
        <translation>y [mm]</translation>
    </message>
    <message>
        <source>z [mm]</source>
        <translation>z [mm]</translation>
    </message>
    <message>
        <source>Off by [mm]</source>
        <translation>Fehler [mm]</translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::PickTool</name>
    <message>
        <source>Click places on the reference, in the order of the path.</source>
        <translation>Stellen auf der Referenz anklicken, in der Reihenfolge der Bahn.</translation>
    </message>
    <message>
        <source>No reference is in view: choose a recipe on the page of new paths.</source>
        <translation>Keine Referenz zu sehen: auf der Seite für neue Bahnen ein Rezept wählen.</translation>
    </message>
    <message>
        <source>Nothing of the reference was there. Click on it.</source>
        <translation>Dort war nichts von der Referenz. Bitte auf sie klicken.</translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::PlaneTool</name>
    <message>
        <source>Plane: click three points. The viewer&apos;s side is deleted, or alone is kept.</source>
        <translation>Ebene: drei Punkte anklicken. Die Seite des Betrachters wird gelöscht oder allein behalten.</translation>
    </message>
    <message>
        <source>No point is there. </source>
        <translation>Dort ist kein Punkt. </translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::PolygonTool</name>
    <message>
        <source>Polygon: click its corners, the first on the cloud; Return or a double click closes it, Escape starts again.</source>
        <translation>Polygon: Ecken anklicken, die erste auf der Wolke; Eingabe oder Doppelklick schließt es, Esc beginnt neu.</translation>
    </message>
    <message>
        <source>No point is there. </source>
        <translation>Dort ist kein Punkt. </translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::Seat</name>
    <message>
        <source>S&amp;top</source>
        <translation>S&amp;topp</translation>
    </message>
    <message>
        <source>&amp;1 Part</source>
        <translation>&amp;1 Teil</translation>
    </message>
    <message>
        <source>&amp;2 Clean</source>
        <translation>&amp;2 Säubern</translation>
    </message>
    <message>
        <source>&amp;3 Fit</source>
        <translation>&amp;3 Anpassung</translation>
    </message>
    <message>
        <source>Stops the robot and ends what is under way. It is not an emergency stop.</source>
        <translation>Hält den Roboter an und beendet, was läuft. Es ist kein Not-Halt.</translation>
    </message>
    <message>
        <source>No program here opens %1</source>
        <translation>Hier öffnet kein Programm %1</translation>
    </message>
    <message>
        <source>Saved into %1: scan a part again, or prove the recipe.</source>
        <translation>In %1 gesichert: ein Teil neu scannen oder das Rezept bewähren.</translation>
    </message>
    <message>
        <source>Nothing is under way.</source>
        <translation>Nichts läuft.</translation>
    </message>
    <message>
        <source>Another seat or program has the cell.</source>
        <translation>Ein anderer Platz oder ein Programm hat die Zelle.</translation>
    </message>
    <message>
        <source>Done. %1</source>
        <translation>Fertig. %1</translation>
    </message>
    <message>
        <source>&amp;4 Path</source>
        <translation>&amp;4 Pfad</translation>
    </message>
    <message>
        <source>&amp;5 Work</source>
        <translation>&amp;5 Arbeit</translation>
    </message>
    <message>
        <source>&amp;6 History</source>
        <translation>&amp;6 Verlauf</translation>
    </message>
    <message>
        <source>&amp;7 Teach</source>
        <translation>&amp;7 Teachen</translation>
    </message>
    <message>
        <source>&amp;8 New path</source>
        <translation>&amp;8 Neue Bahn</translation>
    </message>
    <message>
        <source>&amp;9 Passes</source>
        <translation>&amp;9 Scanbahnen</translation>
    </message>
    <message>
        <source>F&amp;it the view</source>
        <translation>In die &amp;Mitte holen</translation>
    </message>
    <message>
        <source>Brings what the page is about into the middle of the 3D view</source>
        <translation>Bringt das, worum es auf der Seite geht, in die Mitte der 3D-Ansicht</translation>
    </message>
    <message>
        <source>edits of the scan (page 2)</source>
        <translation>Bearbeitungen des Scans (Seite 2)</translation>
    </message>
    <message>
        <source>edits of the path (page 4)</source>
        <translation>Bearbeitungen des Pfads (Seite 4)</translation>
    </message>
    <message>
        <source>Not completed: %1</source>
        <translation>Nicht bis zum Ende ausgeführt: %1</translation>
    </message>
    <message>
        <source>Dry run done. %1</source>
        <translation>Trockenlauf fertig. %1</translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::SeatPanel</name>
    <message>
        <source>The cell is at work</source>
        <translation>Die Zelle arbeitet</translation>
    </message>
    <message>
        <source>What this seat began is still under way.</source>
        <translation>Was dieser Platz begonnen hat, läuft noch.</translation>
    </message>
    <message>
        <source>&amp;Stop it and close</source>
        <translation>&amp;Anhalten und schließen</translation>
    </message>
    <message>
        <source>&amp;Leave it running and close</source>
        <translation>&amp;Laufen lassen und schließen</translation>
    </message>
    <message>
        <source>&amp;Do not close</source>
        <translation>&amp;Nicht schließen</translation>
    </message>
    <message>
        <source>Edits are not saved</source>
        <translation>Bearbeitungen sind nicht gespeichert</translation>
    </message>
    <message>
        <source>Not saved: %1.</source>
        <translation>Nicht gespeichert: %1.</translation>
    </message>
    <message>
        <source>&amp;Close without them</source>
        <translation>Ohne sie s&amp;chließen</translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::StagesBox</name>
    <message>
        <source>Automatic stages</source>
        <translation>Automatische Stufen</translation>
    </message>
    <message>
        <source>Save the &amp;stages into the recipe</source>
        <translation>&amp;Stufen ins Rezept sichern</translation>
    </message>
    <message>
        <source>Shows which of the points left by the edits each stage would remove</source>
        <translation>Zeigt, was jede Stufe von dem nähme, was die Änderungen lassen</translation>
    </message>
    <message>
        <source>; usually %1</source>
        <translation>; üblich %1</translation>
    </message>
    <message>
        <source>%1: not tried</source>
        <translation>%1: nicht versucht</translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::TeachLink</name>
    <message>
        <source>Pose %1 of %2: %3, %4, %5 mm in %6</source>
        <translation>Pose %1 von %2: %3, %4, %5 mm in %6</translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::TeachPage</name>
    <message>
        <source>Ta&amp;ke the pose</source>
        <translation>Pose über&amp;nehmen</translation>
    </message>
    <message>
        <source>What a button moves: one joint, or the flange along the axes of the robot&apos;s base or its own</source>
        <translation>Was eine Taste bewegt: eine Achse, oder den Flansch entlang der Achsen der Roboterbasis oder seiner eigenen</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Axes of the base</source>
        <translation>Richtungen der Basis</translation>
    </message>
    <message>
        <source>Axes of the flange</source>
        <translation>Richtungen des Flansches</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Of the programmed speed (1 to 100 %); the driver refuses more than its max_jog_override</source>
        <translation>Der programmierten Geschwindigkeit (1 bis 100 %); der Treiber verweigert mehr als sein max_jog_override</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>&amp;Bewegen</translation>
    </message>
    <message>
        <source>S&amp;peed</source>
        <translation>&amp;Geschwindigkeit</translation>
    </message>
    <message>
        <source>File of taught poses (CSV) on the cell&apos;s computer: made where there is none. Calibration, tool and world read such files.</source>
        <translation>Datei geteachter Posen (CSV) auf dem Rechner der Zelle: wird angelegt, wo keine ist. Kalibrierung, Werkzeug und Welt lesen solche Dateien.</translation>
    </message>
    <message>
        <source>Appends the flange&apos;s pose to the file. The robot must stand still.</source>
        <translation>Hängt die Pose des Flansches an die Datei an. Der Roboter muss stehen.</translation>
    </message>
    <message>
        <source>C&amp;hoose...</source>
        <translation>&amp;Wählen ...</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>Posen</translation>
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
        <source>about X</source>
        <translation>um X</translation>
    </message>
    <message>
        <source>about Y</source>
        <translation>um Y</translation>
    </message>
    <message>
        <source>about Z</source>
        <translation>um Z</translation>
    </message>
    <message>
        <source>J%1</source>
        <translation>J%1</translation>
    </message>
    <message>
        <source>The robot moves while it is held, by the mouse or the space bar</source>
        <translation>Der Roboter bewegt sich, solange sie gehalten wird, mit der Maus oder der Leertaste</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>The robot moves.</source>
        <translation>Der Roboter bewegt sich.</translation>
    </message>
    <message>
        <source>The robot&apos;s driver is not running.</source>
        <translation>Der Treiber des Roboters läuft nicht.</translation>
    </message>
    <message>
        <source>This window did not answer for a moment: press the button again.</source>
        <translation>Dieses Fenster antwortete kurz nicht: die Taste noch einmal drücken.</translation>
    </message>
    <message>
        <source>File of taught poses</source>
        <translation>Datei geteachter Posen</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::WaypointTool</name>
    <message>
        <source>Click a waypoint, and with Shift another one for all between them.</source>
        <translation>Auf einen Wegpunkt klicken, und mit Umschalt auf einen anderen für alle dazwischen.</translation>
    </message>
    <message>
        <source>No adapted path is in view: choose an accepted run.</source>
        <translation>Kein angepasster Pfad ist zu sehen: einen angenommenen Lauf wählen.</translation>
    </message>
</context>
<context>
    <name>scan_cell_rviz::WorkPage</name>
    <message>
        <source>Pre&amp;view</source>
        <translation>&amp;Vorschau</translation>
    </message>
    <message>
        <source>Preview the dr&amp;y run</source>
        <translation>V&amp;orschau des Trockenlaufs</translation>
    </message>
    <message>
        <source>&amp;Dry run</source>
        <translation>Trocken&amp;lauf</translation>
    </message>
    <message>
        <source>&amp;Work</source>
        <translation>&amp;Arbeiten</translation>
    </message>
    <message>
        <source>Moves the robot along the path: lifted, slow, with the tool off</source>
        <translation>Bewegt den Roboter die Bahn entlang: angehoben, langsam, mit dem Werkzeug aus</translation>
    </message>
    <message>
        <source>Moves the robot along the path with the tool on. The cell refuses it until the path was run dry once.</source>
        <translation>Bewegt den Roboter die Bahn entlang, mit dem Werkzeug an. Die Zelle verweigert es, bis die Bahn einmal trocken gefahren wurde.</translation>
    </message>
    <message>
        <source>Moves nothing: shows the way, the robot at each of its poses, and where it cannot follow</source>
        <translation>Bewegt nichts: zeigt den Weg, den Roboter an jeder seiner Posen, und wo er nicht folgen kann</translation>
    </message>
    <message>
        <source>The same for the dry run</source>
        <translation>Dasselbe für den Trockenlauf</translation>
    </message>
    <message>
        <source>Pose of the preview</source>
        <translation>Pose der Vorschau</translation>
    </message>
    <message>
        <source>Pose of the tool&apos;s tip at which the robot&apos;s ghost stands</source>
        <translation>Pose der Werkzeugspitze, an der der durchscheinende Roboter steht</translation>
    </message>
    <message>
        <source>What the robot cannot do</source>
        <translation>Was der Roboter nicht kann</translation>
    </message>
    <message>
        <source>Where the robot cannot follow: the view turns there</source>
        <translation>Wo der Roboter nicht folgen kann: die Ansicht wendet sich dorthin</translation>
    </message>
    <message>
        <source>The robot can follow the whole way.</source>
        <translation>Der Roboter kann dem ganzen Weg folgen.</translation>
    </message>
    <message numerus="yes">
        <source>The robot cannot follow it: %n fault(s).</source>
        <translation>
            <numerusform>Der Roboter kann ihm nicht folgen: %n Fehler.</numerusform>
            <numerusform>Der Roboter kann ihm nicht folgen: %n Fehler.</numerusform>
        </translation>
    </message>
    <message>
        <source>Dry run. </source>
        <translation>Trockenlauf. </translation>
    </message>
    <message>
        <source>Work. </source>
        <translation>Arbeit. </translation>
    </message>
    <message>
        <source>Scan a part first.</source>
        <translation>Zuerst ein Teil scannen.</translation>
    </message>
    <message>
        <source>%1: approved by %2</source>
        <translation>%1: freigegeben von %2</translation>
    </message>
    <message>
        <source>%1: approve it first</source>
        <translation>%1: erst freigeben</translation>
    </message>
    <message>
        <source>Work it again?</source>
        <translation>Noch einmal bearbeiten?</translation>
    </message>
    <message>
        <source>The part of this run was worked already (%1).</source>
        <translation>Das Teil dieses Laufs wurde schon bearbeitet (%1).</translation>
    </message>
    <message>
        <source>Dry runs: %1. Worked: %2.</source>
        <translation>Trockenläufe: %1. Bearbeitet: %2.</translation>
    </message>
    <message>
        <source> The last one ended early, after %1 waypoints.</source>
        <translation> Die letzte Bearbeitung endete vorzeitig, nach %1 Wegpunkten.</translation>
    </message>
    <message>
        <source>%1: its path was not accepted</source>
        <translation>%1: sein Pfad wurde nicht angenommen</translation>
    </message>
    <message>
        <source>%1: refused by %2</source>
        <translation>%1: abgelehnt von %2</translation>
    </message>
</context>
</TS>
