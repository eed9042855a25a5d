<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>editor/document</name>
    <message>
        <source>look at an earlier step</source>
        <translation>Blick auf einen früheren Schritt</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Quadrat</translation>
    </message>
    <message>
        <source>Leaf</source>
        <translation>Blatt</translation>
    </message>
    <message>
        <source>Disc</source>
        <translation>Scheibe</translation>
    </message>
    <message>
        <source>%1 mm across</source>
        <translation>%1 mm Durchmesser</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Valley</source>
        <translation>Tal</translation>
    </message>
    <message>
        <source>Mountain</source>
        <translation>Berg</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>Faltung</translation>
    </message>
    <message>
        <source>Place on the crease, x</source>
        <translation>Stelle auf dem Falz, x</translation>
    </message>
    <message>
        <source>Place on the crease, y</source>
        <translation>Stelle auf dem Falz, y</translation>
    </message>
    <message>
        <source>Closed curve</source>
        <translation>Geschlossene Kurve</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Enden</translation>
    </message>
    <message>
        <source>At the first and last point</source>
        <translation>Im ersten und letzten Punkt</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Senkrecht</translation>
    </message>
    <message>
        <source>Horizontal</source>
        <translation>Waagerecht</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>About x</source>
        <translation>Um x</translation>
    </message>
    <message>
        <source>About y</source>
        <translation>Um y</translation>
    </message>
    <message>
        <source>To the right</source>
        <translation>Nach rechts</translation>
    </message>
    <message>
        <source>Upwards</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>Reihenfolge</translation>
    </message>
    <message>
        <source>In order</source>
        <translation>Nacheinander</translation>
    </message>
    <message>
        <source>All together</source>
        <translation>Alle zusammen</translation>
    </message>
    <message>
        <source>Folds</source>
        <translation>Faltungen</translation>
    </message>
    <message>
        <source>Names, parted by commas; empty: all folds</source>
        <translation>Namen, durch Kommas getrennt; leer: alle Faltungen</translation>
    </message>
    <message>
        <source>From x</source>
        <translation>Von x</translation>
    </message>
    <message>
        <source>From y</source>
        <translation>Von y</translation>
    </message>
    <message>
        <source>To x</source>
        <translation>Bis x</translation>
    </message>
    <message>
        <source>To y</source>
        <translation>Bis y</translation>
    </message>
    <message>
        <source>Point %1, x</source>
        <translation>Punkt %1, x</translation>
    </message>
    <message>
        <source>Point %1, y</source>
        <translation>Punkt %1, y</translation>
    </message>
    <message>
        <source>Left of the line</source>
        <translation>Links der Linie</translation>
    </message>
    <message>
        <source>Right of the line</source>
        <translation>Rechts der Linie</translation>
    </message>
    <message>
        <source>The paper that was chosen</source>
        <translation>Das gewählte Papier</translation>
    </message>
    <message>
        <source>Moving side</source>
        <translation>Bewegte Seite</translation>
    </message>
    <message>
        <source>All layers</source>
        <translation>Alle Lagen</translation>
    </message>
    <message>
        <source>Top layers</source>
        <translation>Oberste Lagen</translation>
    </message>
    <message>
        <source>Straight down through all</source>
        <translation>Senkrecht durch alle</translation>
    </message>
    <message>
        <source>Only the edges of the path</source>
        <translation>Nur die Kanten des Pfades</translation>
    </message>
    <message>
        <source>Chosen layers (%1)</source>
        <translation>Gewählte Lagen (%1)</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>How many layers</source>
        <translation>Wie viele Lagen</translation>
    </message>
    <message>
        <source>%1: valley, %2°</source>
        <translation>%1: Tal, %2°</translation>
    </message>
    <message>
        <source>%1: mountain, %2°</source>
        <translation>%1: Berg, %2°</translation>
    </message>
    <message>
        <source>%1 to %2°</source>
        <translation>%1 auf %2°</translation>
    </message>
    <message>
        <source>unfold %1</source>
        <translation>%1 aufklappen</translation>
    </message>
    <message>
        <source>unfold all together</source>
        <translation>alle zusammen aufklappen</translation>
    </message>
    <message>
        <source>unfold all in order</source>
        <translation>alle nacheinander aufklappen</translation>
    </message>
    <message>
        <source>fold %1 again</source>
        <translation>%1 wieder falten</translation>
    </message>
    <message>
        <source>fold all again together</source>
        <translation>alle zusammen wieder falten</translation>
    </message>
    <message>
        <source>fold all again in order</source>
        <translation>alle nacheinander wieder falten</translation>
    </message>
    <message>
        <source>tear</source>
        <translation>Riss</translation>
    </message>
    <message>
        <source>mend all</source>
        <translation>alles flicken</translation>
    </message>
    <message>
        <source>mend</source>
        <translation>flicken</translation>
    </message>
    <message>
        <source>new edge</source>
        <translation>neue Kante</translation>
    </message>
    <message>
        <source>straight cut</source>
        <translation>gerader Schnitt</translation>
    </message>
    <message>
        <source>curve cut</source>
        <translation>Kurvenschnitt</translation>
    </message>
    <message>
        <source>turn over</source>
        <translation>wenden</translation>
    </message>
    <message>
        <source>rotate by %1°</source>
        <translation>um %1° drehen</translation>
    </message>
    <message>
        <source>move by %1 mm</source>
        <translation>um %1 mm verschieben</translation>
    </message>
    <message>
        <source>Folded</source>
        <translation>Gefaltet</translation>
    </message>
    <message>
        <source>crease pattern, %1 creases, folded</source>
        <translation>Faltmuster, %1 Falze, gefaltet</translation>
    </message>
    <message>
        <source>crease pattern, %1 creases</source>
        <translation>Faltmuster, %1 Falze</translation>
    </message>
</context>
<context>
    <name>editor/session</name>
    <message>
        <source>Folding the model</source>
        <translation>Das Modell wird gefaltet</translation>
    </message>
    <message>
        <source>removal of step %1</source>
        <translation>Entfernen von Schritt %1</translation>
    </message>
    <message>
        <source>turning over</source>
        <translation>Wenden</translation>
    </message>
    <message>
        <source>rotation</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>mending</source>
        <translation>Flicken</translation>
    </message>
    <message>
        <source>unfolding</source>
        <translation>Aufklappen</translation>
    </message>
    <message>
        <source>folding again</source>
        <translation>erneutes Falten</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>change of step %1</source>
        <translation>Änderung von Schritt %1</translation>
    </message>
    <message>
        <source>meets at %1</source>
        <translation>trifft bei %1</translation>
    </message>
    <message>
        <source>slide</source>
        <translation>Schieberegler</translation>
    </message>
    <message>
        <source>unfold</source>
        <translation>aufklappen</translation>
    </message>
    <message>
        <source>how it opens</source>
        <translation>Art des Öffnens</translation>
    </message>
    <message>
        <source>Making the film</source>
        <translation>Der Film wird vorbereitet</translation>
    </message>
    <message>
        <source>The film cannot be made</source>
        <translation>Der Film kann nicht gezeigt werden</translation>
    </message>
    <message>
        <source>This cannot be done</source>
        <translation>Das geht nicht</translation>
    </message>
    <message>
        <source>Paper meets paper</source>
        <translation>Papier stößt auf Papier</translation>
    </message>
    <message>
        <source>Finding the way</source>
        <translation>Der Weg wird gesucht</translation>
    </message>
    <message>
        <source>Fold the sheet in half</source>
        <translation>Das Blatt halbieren</translation>
    </message>
    <message>
        <source>Fold all layers once more</source>
        <translation>Alle Lagen noch einmal falten</translation>
    </message>
    <message>
        <source>Cut the margin</source>
        <translation>Den Rand schneiden</translation>
    </message>
    <message>
        <source>Open the leaf</source>
        <translation>Das Blatt öffnen</translation>
    </message>
    <message>
        <source>Look at it from all sides</source>
        <translation>Von allen Seiten ansehen</translation>
    </message>
    <message>
        <source>Your first leaf</source>
        <translation>Ihr erstes Blatt</translation>
    </message>
    <message>
        <source>That was another movement than this leaf needs. Press Ctrl+Z to take it back and try again, or go on by yourself and close this card.</source>
        <translation>Das war eine andere Bewegung, als dieses Blatt braucht. Mit Strg+Z nehmen Sie sie zurück und versuchen es noch einmal; oder Sie machen allein weiter und schließen diese Karte.</translation>
    </message>
    <message>
        <source>Take the lower right corner of the sheet and drag it onto the upper left one. The crease that appears becomes the mid-vein. Press Enter.</source>
        <translation>Fassen Sie die untere rechte Ecke des Blattes und ziehen Sie sie auf die obere linke. Der Falz, der erscheint, wird zur Mittelrippe. Drücken Sie die Eingabetaste.</translation>
    </message>
    <message>
        <source>Hold Shift, which takes all layers, and drag the upper left corner onto the folded edge, so that the new crease starts in the lower left corner. Press Enter.</source>
        <translation>Halten Sie die Umschalttaste, die alle Lagen nimmt, und ziehen Sie die obere linke Ecke auf die gefaltete Kante, sodass der neue Falz in der unteren linken Ecke beginnt. Drücken Sie die Eingabetaste.</translation>
    </message>
    <message>
        <source>Click points across the paper, from outside to outside: far out on the mid-vein, near on the other side. Enter ends the curve, Enter again cuts through all layers.</source>
        <translation>Klicken Sie Punkte quer über das Papier, von außen nach außen: weit draußen an der Mittelrippe, nah auf der anderen Seite. Die Eingabetaste beendet die Kurve, noch einmal gedrückt schneidet sie durch alle Lagen.</translation>
    </message>
    <message>
        <source>Press Ctrl+U to unfold everything, or drag the sliders of the folds.</source>
        <translation>Mit Strg+U klappen Sie alles auf; oder Sie ziehen die Regler der Faltungen.</translation>
    </message>
    <message>
        <source>Drag with the right mouse button, or on the empty ground, to turn the leaf about.</source>
        <translation>Ziehen Sie mit der rechten Maustaste oder auf dem leeren Grund, um das Blatt zu drehen.</translation>
    </message>
    <message>
        <source>One cut through the layers of a bud makes a whole margin: this is how leaves grow lobes. Save it, or press Space to see how it came to be.</source>
        <translation>Ein Schnitt durch die Lagen einer Knospe ergibt einen ganzen Rand: So bekommen Blätter ihre Lappen. Speichern Sie es, oder drücken Sie die Leertaste und sehen Sie, wie es entstanden ist.</translation>
    </message>
    <message>
        <source>new colours</source>
        <translation>neue Farben</translation>
    </message>
    <message>
        <source>new title</source>
        <translation>neuer Titel</translation>
    </message>
    <message>
        <source>choice of another folded state</source>
        <translation>Wahl eines anderen Faltzustands</translation>
    </message>
    <message>
        <source>Looking for folded states</source>
        <translation>Faltzustände werden gesucht</translation>
    </message>
    <message>
        <source>This state cannot be shown</source>
        <translation>Dieser Zustand kann nicht gezeigt werden</translation>
    </message>
    <message>
        <source>There are no folded states to choose from</source>
        <translation>Es gibt keine Faltzustände, aus denen gewählt werden könnte</translation>
    </message>
    <message>
        <source>It cannot lie on top there</source>
        <translation>Das kann dort nicht oben liegen</translation>
    </message>
    <message>
        <source>choice of the paper on top</source>
        <translation>Wahl des oben liegenden Papiers</translation>
    </message>
    <message>
        <source>Looking for the state</source>
        <translation>Der Zustand wird gesucht</translation>
    </message>
    <message>
        <source>Counting folded states</source>
        <translation>Faltzustände werden gezählt</translation>
    </message>
    <message>
        <source>Odd number of creases: %1</source>
        <translation>Ungerade Zahl von Falzen: %1</translation>
    </message>
    <message>
        <source>Kawasaki: %1°</source>
        <translation>Kawasaki: %1°</translation>
    </message>
    <message>
        <source>Maekawa: %1</source>
        <translation>Maekawa: %1</translation>
    </message>
    <message>
        <source>Big-little-big</source>
        <translation>Groß-klein-groß</translation>
    </message>
    <message>
        <source>Paper through paper</source>
        <translation>Papier durch Papier</translation>
    </message>
</context>
<context>
    <name>editor/snap</name>
    <message>
        <source>corner</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>vertex</source>
        <translation>Eckpunkt</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>%1/%2</source>
        <translation>%1/%2</translation>
    </message>
    <message>
        <source>crossing</source>
        <translation>Kreuzung</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>crease</source>
        <translation>Falz</translation>
    </message>
    <message>
        <source>tear</source>
        <translation>Riss</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1° and %2°</source>
        <translation>%1° und %2°</translation>
    </message>
</context>
<context>
    <name>editor/tools</name>
    <message>
        <source>Onto the nearest edges</source>
        <translation>Auf die nächsten Kanten</translation>
    </message>
    <message>
        <source>Puts both ends onto the edges nearest to them</source>
        <translation>Legt beide Enden auf die nächstgelegenen Kanten</translation>
    </message>
    <message>
        <source>Draw an edge across the paper: drag, or click both ends</source>
        <translation>Eine Kante über das Papier zeichnen: ziehen oder beide Enden anklicken</translation>
    </message>
    <message>
        <source>Release or click where the edge ends; Esc drops it</source>
        <translation>Loslassen oder klicken, wo die Kante endet; Esc verwirft sie</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>0 is unfolded, 180 flat; below 0 the fold turns the other way</source>
        <translation>0 ist offen, 180 flach; unter 0 geht die Faltung andersherum</translation>
    </message>
    <message>
        <source>Pull the paper over the crease, or back, then release</source>
        <translation>Das Papier über den Falz ziehen oder zurück, dann loslassen</translation>
    </message>
    <message>
        <source>Enter sets the angle, Esc leaves it; arrow keys turn by 15°, or type it</source>
        <translation>Eingabe setzt den Winkel, Esc lässt ihn; Pfeiltasten drehen um 15°, oder tippen Sie ihn</translation>
    </message>
    <message>
        <source>There is no fold yet; make one with the fold tool</source>
        <translation>Es gibt noch keine Faltung; machen Sie eine mit dem Faltwerkzeug</translation>
    </message>
    <message>
        <source>Press on a crease and pull to open or close its fold</source>
        <translation>Auf einen Falz drücken und ziehen, um ihn zu öffnen oder zu schließen</translation>
    </message>
    <message>
        <source>Click the control points of a curve, or draw it in one stroke</source>
        <translation>Die Kontrollpunkte einer Kurve anklicken oder sie in einem Zug zeichnen</translation>
    </message>
    <message>
        <source>Click the next point; Backspace takes the last one back</source>
        <translation>Den nächsten Punkt anklicken; die Rücktaste nimmt den letzten zurück</translation>
    </message>
    <message>
        <source>Go on clicking points; Enter or a double click ends the curve, a click on its start closes it</source>
        <translation>Weitere Punkte anklicken; Eingabe oder Doppelklick beendet die Kurve, ein Klick auf ihren Anfang schließt sie</translation>
    </message>
    <message>
        <source>Enter cuts; drag points, double-click the curve for one more, click a piece to keep or drop it</source>
        <translation>Eingabe schneidet; Punkte ziehen, Doppelklick auf die Kurve für einen weiteren, Klick auf ein Stück behält oder verwirft es</translation>
    </message>
    <message>
        <source>Place of the active control point</source>
        <translation>Stelle des aktiven Kontrollpunkts</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Geschlossen</translation>
    </message>
    <message>
        <source>The curve comes back to where it starts</source>
        <translation>Die Kurve kehrt zu ihrem Anfang zurück</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>All layers</source>
        <translation>Alle Lagen</translation>
    </message>
    <message>
        <source>Uppermost</source>
        <translation>Oberste</translation>
    </message>
    <message>
        <source>As drawn on the sheet</source>
        <translation>Wie auf dem Blatt gezeichnet</translation>
    </message>
    <message>
        <source>Straight through everything</source>
        <translation>Gerade durch alles</translation>
    </message>
    <message>
        <source>Which layers are taken; the wheel with Ctrl walks them</source>
        <translation>Welche Lagen genommen werden; das Rad mit Strg geht sie durch</translation>
    </message>
    <message>
        <source>How many</source>
        <translation>Wie viele</translation>
    </message>
    <message>
        <source>Layers taken, the one that is seen first</source>
        <translation>Genommene Lagen, die sichtbare zuerst</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Length of the drawn line; its first end stays</source>
        <translation>Länge der gezeichneten Linie; ihr erstes Ende bleibt</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Direction of the line on the sheet, counted from the x axis</source>
        <translation>Richtung der Linie auf dem Blatt, von der x-Achse gezählt</translation>
    </message>
    <message>
        <source>Add the layers that must come along</source>
        <translation>Die Lagen dazunehmen, die mitmüssen</translation>
    </message>
    <message>
        <source>Without them the fold would stretch the paper</source>
        <translation>Ohne sie würde die Faltung das Papier dehnen</translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>Faltung</translation>
    </message>
    <message>
        <source>Valley</source>
        <translation>Tal</translation>
    </message>
    <message>
        <source>Mountain</source>
        <translation>Berg</translation>
    </message>
    <message>
        <source>A valley turns the paper towards you, a mountain away (V, M)</source>
        <translation>Ein Tal dreht das Papier zu Ihnen, ein Berg von Ihnen weg (V, M)</translation>
    </message>
    <message>
        <source>How far the paper turns; 180 is flat</source>
        <translation>Wie weit sich das Papier dreht; 180 ist flach</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Andere Seite</translation>
    </message>
    <message>
        <source>Turn the other side of the line instead (Tab)</source>
        <translation>Stattdessen die andere Seite der Linie drehen (Tab)</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name of the fold line; empty: a number</source>
        <translation>Name der Faltlinie; leer: eine Nummer</translation>
    </message>
    <message>
        <source>This flap</source>
        <translation>Diese Klappe</translation>
    </message>
    <message>
        <source>Top layers</source>
        <translation>Oberste Lagen</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Picked</source>
        <translation>Ausgewählte</translation>
    </message>
    <message>
        <source>Which layers fold; Ctrl and the wheel walk through them, Ctrl and a click picks</source>
        <translation>Welche Lagen gefaltet werden; Strg und das Rad gehen sie durch, Strg und ein Klick wählt</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>How many layers from the top</source>
        <translation>Wie viele Lagen von oben</translation>
    </message>
    <message>
        <source>Show layers</source>
        <translation>Lagen zeigen</translation>
    </message>
    <message>
        <source>opens &quot;%1&quot;</source>
        <translation>öffnet „%1“</translation>
    </message>
    <message>
        <source>Release where the paper is to lie; Shift takes all layers, Alt the top one, Ctrl and the wheel more or fewer</source>
        <translation>Loslassen, wo das Papier liegen soll; Umschalt nimmt alle Lagen, Alt die oberste, Strg und das Rad mehr oder weniger</translation>
    </message>
    <message>
        <source>Draw the line right across the paper, then release</source>
        <translation>Die Linie ganz über das Papier ziehen, dann loslassen</translation>
    </message>
    <message>
        <source>Enter opens the fold again, Esc leaves it</source>
        <translation>Eingabe öffnet die Faltung wieder, Esc lässt sie</translation>
    </message>
    <message>
        <source>The paper would have to stretch at the marked hinge; add the layers that must come along</source>
        <translation>Das Papier müsste sich am markierten Falz dehnen; nehmen Sie die Lagen dazu, die mitmüssen</translation>
    </message>
    <message>
        <source>This fold cannot be made; move the line by its handles, or choose other layers</source>
        <translation>Diese Faltung geht nicht; verschieben Sie die Linie an ihren Griffen, oder wählen Sie andere Lagen</translation>
    </message>
    <message>
        <source>Enter folds, Esc drops it; V valley, M mountain, Tab the other side, drag the handles</source>
        <translation>Eingabe faltet, Esc verwirft; V Tal, M Berg, Tab die andere Seite, an den Griffen ziehen</translation>
    </message>
    <message>
        <source>Drag a corner, an edge or any paper to fold it over; press beside the paper to draw a fold line across</source>
        <translation>Eine Ecke, eine Kante oder irgendein Papier ziehen, um es umzufalten; neben dem Papier drücken, um eine Faltlinie zu zeichnen</translation>
    </message>
    <message>
        <source>stays</source>
        <translation>bleibt</translation>
    </message>
    <message>
        <source>Stays</source>
        <translation>Bleibt</translation>
    </message>
    <message>
        <source>The marked side</source>
        <translation>Die markierte Seite</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Picked pieces</source>
        <translation>Ausgewählte Stücke</translation>
    </message>
    <message>
        <source>Which paper stays after the cut; click a piece to keep or drop it</source>
        <translation>Welches Papier nach dem Schnitt bleibt; Klick auf ein Stück behält oder verwirft es</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Von Hand</translation>
    </message>
    <message>
        <source>Through two points</source>
        <translation>Durch zwei Punkte</translation>
    </message>
    <message>
        <source>Point onto point</source>
        <translation>Punkt auf Punkt</translation>
    </message>
    <message>
        <source>Line onto line</source>
        <translation>Linie auf Linie</translation>
    </message>
    <message>
        <source>Through a point, square to a line</source>
        <translation>Durch einen Punkt, senkrecht zu einer Linie</translation>
    </message>
    <message>
        <source>Point onto line, through a point</source>
        <translation>Punkt auf Linie, durch einen Punkt</translation>
    </message>
    <message>
        <source>Two points onto two lines</source>
        <translation>Zwei Punkte auf zwei Linien</translation>
    </message>
    <message>
        <source>Point onto line, square to a line</source>
        <translation>Punkt auf Linie, senkrecht zu einer Linie</translation>
    </message>
    <message>
        <source>Bisector of a corner</source>
        <translation>Winkelhalbierende</translation>
    </message>
    <message>
        <source>Mirrored in a line</source>
        <translation>An einer Linie gespiegelt</translation>
    </message>
    <message>
        <source>Onto the nearest edge</source>
        <translation>Auf die nächste Kante</translation>
    </message>
    <message>
        <source>Draw a line; it is laid onto the edge nearest to it</source>
        <translation>Eine Linie zeichnen; sie wird auf die nächste Kante gelegt</translation>
    </message>
    <message>
        <source>No line does this; pick again</source>
        <translation>Keine Linie leistet das; wählen Sie neu</translation>
    </message>
    <message>
        <source>Click a point (%1 of %2)</source>
        <translation>Einen Punkt anklicken (%1 von %2)</translation>
    </message>
    <message>
        <source>Click an edge or a crease (%1 of %2)</source>
        <translation>Eine Kante oder einen Falz anklicken (%1 von %2)</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>How the line is placed: drawn, or by what it must do</source>
        <translation>Wie die Linie entsteht: gezeichnet oder durch das, was sie leisten muss</translation>
    </message>
    <message>
        <source>Solution</source>
        <translation>Lösung</translation>
    </message>
    <message>
        <source>Several lines do this (Space: the next)</source>
        <translation>Mehrere Linien leisten das (Leertaste: die nächste)</translation>
    </message>
    <message>
        <source>Line %1 of %2: Space shows the next, Enter folds</source>
        <translation>Linie %1 von %2: Leertaste zeigt die nächste, Eingabe faltet</translation>
    </message>
    <message>
        <source>Draw the fold line: drag, or click both ends</source>
        <translation>Die Faltlinie zeichnen: ziehen oder beide Enden anklicken</translation>
    </message>
    <message>
        <source>%1 mm on the sheet, %2 mm in space</source>
        <translation>%1 mm auf dem Blatt, %2 mm im Raum</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
    <message>
        <source>On the sheet</source>
        <translation>Auf dem Blatt</translation>
    </message>
    <message>
        <source>In space</source>
        <translation>Im Raum</translation>
    </message>
    <message>
        <source>Fold angle</source>
        <translation>Faltwinkel</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>Facet</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Click the second point</source>
        <translation>Den zweiten Punkt anklicken</translation>
    </message>
    <message>
        <source>Click two points of the paper</source>
        <translation>Zwei Punkte des Papiers anklicken</translation>
    </message>
    <message>
        <source>Click three points: the angle is at the second</source>
        <translation>Drei Punkte anklicken: der Winkel liegt am zweiten</translation>
    </message>
    <message>
        <source>Click an edge or a crease</source>
        <translation>Eine Kante oder einen Falz anklicken</translation>
    </message>
    <message>
        <source>Click a facet</source>
        <translation>Eine Fläche anklicken</translation>
    </message>
    <message>
        <source>Mend</source>
        <translation>Flicken</translation>
    </message>
    <message>
        <source>The whole tear</source>
        <translation>Den ganzen Riss</translation>
    </message>
    <message>
        <source>One edge</source>
        <translation>Eine Kante</translation>
    </message>
    <message>
        <source>How much a click mends; Alt: one edge</source>
        <translation>Wie viel ein Klick flickt; Alt: eine Kante</translation>
    </message>
    <message>
        <source>All that are torn here</source>
        <translation>Alle, die hier gerissen sind</translation>
    </message>
    <message>
        <source>Only this layer</source>
        <translation>Nur diese Lage</translation>
    </message>
    <message>
        <source>Which of the torn edges that lie on each other</source>
        <translation>Welche der gerissenen Kanten, die aufeinanderliegen</translation>
    </message>
    <message>
        <source>Mend everything</source>
        <translation>Alles flicken</translation>
    </message>
    <message>
        <source>Mends every torn edge whose sides lie together</source>
        <translation>Flickt jede gerissene Kante, deren Seiten beieinanderliegen</translation>
    </message>
    <message>
        <source>Nothing is torn</source>
        <translation>Nichts ist gerissen</translation>
    </message>
    <message>
        <source>The sides of this tear have moved apart; fold them back together first</source>
        <translation>Die Seiten dieses Risses liegen nicht mehr beieinander; falten Sie sie zuerst wieder zusammen</translation>
    </message>
    <message>
        <source>Click to mend this tear</source>
        <translation>Klicken, um diesen Riss zu flicken</translation>
    </message>
    <message>
        <source>Click a torn edge to mend it</source>
        <translation>Eine gerissene Kante anklicken, um sie zu flicken</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Facets</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Eckpunkte</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>Innen</translation>
    </message>
    <message>
        <source>Facets fold, a point names the side that moves, a line is a mirror, inside is the paper that a cut keeps</source>
        <translation>Flächen werden gefaltet, ein Punkt nennt die bewegte Seite, eine Linie ist ein Spiegel, innen ist das Papier, das ein Schnitt behält</translation>
    </message>
    <message>
        <source>Selected: %1; Shift and a click adds, Esc clears</source>
        <translation>Ausgewählt: %1; Umschalt und Klick fügt hinzu, Esc leert die Auswahl</translation>
    </message>
    <message>
        <source>Click a facet, or drag a rectangle around several</source>
        <translation>Eine Fläche anklicken oder ein Rechteck um mehrere ziehen</translation>
    </message>
    <message>
        <source>Click what is to be selected; Shift adds</source>
        <translation>Anklicken, was ausgewählt werden soll; Umschalt fügt hinzu</translation>
    </message>
    <message>
        <source>Draw a cut across the paper: drag, or click both ends</source>
        <translation>Einen Schnitt über das Papier zeichnen: ziehen oder beide Enden anklicken</translation>
    </message>
    <message>
        <source>Release or click where the cut ends; Esc drops it</source>
        <translation>Loslassen oder klicken, wo der Schnitt endet; Esc verwirft ihn</translation>
    </message>
    <message>
        <source>Enter cuts; drag the ends, click a piece to keep or drop it, or drag the mark to the side that stays</source>
        <translation>Eingabe schneidet; Enden ziehen, Klick auf ein Stück behält oder verwirft es, oder die Marke auf die Seite ziehen, die bleibt</translation>
    </message>
    <message>
        <source>Length of the tear along its edges</source>
        <translation>Länge des Risses entlang seiner Kanten</translation>
    </message>
    <message>
        <source>All that have an edge here</source>
        <translation>Alle, die hier eine Kante haben</translation>
    </message>
    <message>
        <source>Alt while tearing takes only this layer</source>
        <translation>Alt beim Reißen nimmt nur diese Lage</translation>
    </message>
    <message>
        <source>Drag along the edges and release where the tear ends; Alt tears only this layer</source>
        <translation>An den Kanten entlangziehen und loslassen, wo der Riss endet; Alt reißt nur diese Lage</translation>
    </message>
    <message>
        <source>Click along the edges; a click inside an edge or a double click ends the tear</source>
        <translation>An den Kanten entlang klicken; ein Klick in eine Kante oder ein Doppelklick beendet den Riss</translation>
    </message>
    <message>
        <source>Enter tears the paper; Esc leaves it whole</source>
        <translation>Eingabe reißt das Papier; Esc lässt es ganz</translation>
    </message>
    <message>
        <source>Press and drag along one of the marked edges</source>
        <translation>Drücken und an einer der markierten Kanten entlangziehen</translation>
    </message>
    <message>
        <source>Press where an edge begins, such as at the border, and drag along it</source>
        <translation>Drücken, wo eine Kante beginnt, etwa am Rand, und an ihr entlangziehen</translation>
    </message>
    <message>
        <source>Fans the layers under the line out, to be picked by a click (K)</source>
        <translation>Fächert die Lagen unter der Linie auf, um sie anzuklicken (K)</translation>
    </message>
    <message>
        <source>Layer %1 of %2</source>
        <translation>Lage %1 von %2</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Counted from the one that is seen</source>
        <translation>Von der sichtbaren aus gezählt</translation>
    </message>
    <message>
        <source>Bring on top</source>
        <translation>Nach oben holen</translation>
    </message>
    <message>
        <source>Finds the folded state nearest to this one that has it so</source>
        <translation>Sucht den nächstliegenden Faltzustand, in dem es so ist</translation>
    </message>
    <message>
        <source>Enter brings layer %1 on top; click again or Tab for the next of %2</source>
        <translation>Eingabe holt Lage %1 nach oben; noch ein Klick oder Tab wählt die nächste von %2</translation>
    </message>
    <message>
        <source>Only one layer lies there</source>
        <translation>Dort liegt nur eine Lage</translation>
    </message>
    <message>
        <source>Click the folded model where another layer is to be on top</source>
        <translation>Auf das gefaltete Modell klicken, wo eine andere Lage oben liegen soll</translation>
    </message>
    <message>
        <source>Enter adds the edge</source>
        <translation>Eingabe fügt die Kante hinzu</translation>
    </message>
    <message>
        <source>Enter adds the edge and the marked part: it goes from edge to edge</source>
        <translation>Eingabe fügt die Kante samt dem markierten Teil hinzu: sie reicht von Kante zu Kante</translation>
    </message>
</context>
<context>
    <name>examples/gallery</name>
    <message>
        <source>How leaves are made</source>
        <translation>Wie Blätter entstehen</translation>
    </message>
    <message>
        <source>The sheet is folded along veins and anti-veins, as a leaf is in its bud; one cut through all layers, and it is unfolded.</source>
        <translation>Das Papier wird an Adern und Gegenadern gefaltet wie ein Blatt in seiner Knospe; ein Schnitt durch alle Lagen, und es wird entfaltet.</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Blätter</translation>
    </message>
    <message>
        <source>Origami</source>
        <translation>Origami</translation>
    </message>
    <message>
        <source>Kirigami</source>
        <translation>Kirigami</translation>
    </message>
    <message>
        <source>Folded, cut through all layers with straight cuts and curves, and unfolded.</source>
        <translation>Gefaltet, mit geraden Schnitten und Kurven durch alle Lagen geschnitten und entfaltet.</translation>
    </message>
    <message>
        <source>Crease patterns</source>
        <translation>Faltmuster</translation>
    </message>
    <message>
        <source>Patterns drawn from their geometry and folded as a whole.</source>
        <translation>Muster, aus ihrer Geometrie gezeichnet und als Ganzes gefaltet.</translation>
    </message>
    <message>
        <source>Species of the thesis, from angles and lengths measured on leaves or taken from descriptions; the margin is one curve, cut through all layers.</source>
        <translation>Arten aus der Arbeit, nach Winkeln und Längen, die an Blättern gemessen oder Beschreibungen entnommen sind; der Rand ist eine einzige Kurve, durch alle Lagen geschnitten.</translation>
    </message>
    <message>
        <source>Folded step by step; where many creases would have to close at once, paper is torn or closes as a whole, and the notes say so.</source>
        <translation>Schritt für Schritt gefaltet; wo sich viele Falten zugleich schließen müssten, wird gerissen oder das Ganze auf einmal geschlossen, und die Notizen sagen es.</translation>
    </message>
    <message>
        <source>One straight cut</source>
        <translation>Ein gerader Schnitt</translation>
    </message>
    <message>
        <source>Folded so that a single straight cut makes the shape: the letters of Figure 7.21, and the star of five points.</source>
        <translation>So gefaltet, dass ein einziger gerader Schnitt die Form ergibt: die Buchstaben aus Figure 7.21 und der fünfzackige Stern.</translation>
    </message>
</context>
<context>
    <name>kiri::desktop</name>
    <message>
        <source>Take a new sheet of paper</source>
        <translation>Ein neues Blatt Papier nehmen</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>Ö&amp;ffnen...</translation>
    </message>
    <message>
        <source>Open a model</source>
        <translation>Ein Modell öffnen</translation>
    </message>
    <message>
        <source>New sheets, recent files and examples</source>
        <translation>Neue Blätter, letzte Dateien und Beispiele</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Speichern &amp;unter...</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>&amp;Exportieren...</translation>
    </message>
    <message>
        <source>Pictures, crease patterns, meshes</source>
        <translation>Bilder, Faltmuster, Netze</translation>
    </message>
    <message>
        <source>&amp;Film...</source>
        <translation>F&amp;ilm...</translation>
    </message>
    <message>
        <source>The whole process as a film or an animated picture</source>
        <translation>Der ganze Vorgang als Film oder bewegtes Bild</translation>
    </message>
    <message>
        <source>&amp;Print...</source>
        <translation>&amp;Drucken...</translation>
    </message>
    <message>
        <source>The crease pattern or the model, in true size</source>
        <translation>Das Faltmuster oder das Modell in wahrer Größe</translation>
    </message>
    <message>
        <source>Paper and &amp;colours...</source>
        <translation>Papier und Far&amp;ben...</translation>
    </message>
    <message>
        <source>Colours and textures of both sides of the paper</source>
        <translation>Farben und Texturen beider Seiten des Papiers</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Do it</source>
        <translation>A&amp;usführen</translation>
    </message>
    <message>
        <source>Make the step that is shown</source>
        <translation>Den gezeigten Schritt ausführen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>Drop what is half done, then the selection</source>
        <translation>Halbfertiges verwerfen, dann die Auswahl</translation>
    </message>
    <message>
        <source>D&amp;elete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Take away the chosen point</source>
        <translation>Den gewählten Punkt wegnehmen</translation>
    </message>
    <message>
        <source>Take the shown step out of the history and replay what follows</source>
        <translation>Den gezeigten Schritt herausnehmen und die folgenden wiederholen</translation>
    </message>
    <message>
        <source>&amp;Previous step</source>
        <translation>&amp;Voriger Schritt</translation>
    </message>
    <message>
        <source>Show the model one step earlier</source>
        <translation>Das Modell einen Schritt früher zeigen</translation>
    </message>
    <message>
        <source>Ne&amp;xt step</source>
        <translation>&amp;Nächster Schritt</translation>
    </message>
    <message>
        <source>Show the model one step later</source>
        <translation>Das Modell einen Schritt später zeigen</translation>
    </message>
    <message>
        <source>&amp;Snap</source>
        <translation>E&amp;inrasten</translation>
    </message>
    <message>
        <source>Points catch corners, edges and angles</source>
        <translation>Punkte rasten an Ecken, Kanten und Winkeln ein</translation>
    </message>
    <message>
        <source>Pre&amp;ferences...</source>
        <translation>Ein&amp;stellungen...</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts...</source>
        <translation>&amp;Tastenkürzel...</translation>
    </message>
    <message>
        <source>&amp;Fold</source>
        <translation>&amp;Falten</translation>
    </message>
    <message>
        <source>Drag paper, or draw a line across it</source>
        <translation>Papier ziehen oder eine Linie darüber zeichnen</translation>
    </message>
    <message>
        <source>Fold &amp;line</source>
        <translation>Falt&amp;linie</translation>
    </message>
    <message>
        <source>Draw or construct the line of a fold</source>
        <translation>Die Linie einer Faltung zeichnen oder konstruieren</translation>
    </message>
    <message>
        <source>Fold an&amp;gle</source>
        <translation>Falt&amp;winkel</translation>
    </message>
    <message>
        <source>Open and close a crease that is there</source>
        <translation>Einen vorhandenen Falz öffnen und schließen</translation>
    </message>
    <message>
        <source>&amp;Add edge</source>
        <translation>&amp;Kante hinzufügen</translation>
    </message>
    <message>
        <source>Crease the paper without folding it</source>
        <translation>Das Papier falzen, ohne es zu falten</translation>
    </message>
    <message>
        <source>&amp;Tear</source>
        <translation>&amp;Reißen</translation>
    </message>
    <message>
        <source>Tear along edges from the border</source>
        <translation>Vom Rand aus an Kanten entlang reißen</translation>
    </message>
    <message>
        <source>M&amp;end</source>
        <translation>Fli&amp;cken</translation>
    </message>
    <message>
        <source>Join torn edges again</source>
        <translation>Gerissene Kanten wieder verbinden</translation>
    </message>
    <message>
        <source>Straight &amp;cut</source>
        <translation>&amp;Gerader Schnitt</translation>
    </message>
    <message>
        <source>Cut along a straight line</source>
        <translation>An einer geraden Linie schneiden</translation>
    </message>
    <message>
        <source>Cut along a smooth curve</source>
        <translation>An einer glatten Kurve schneiden</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>&amp;Auswählen</translation>
    </message>
    <message>
        <source>Pick facets, points, vertices and lines</source>
        <translation>Flächen, Punkte, Eckpunkte und Linien wählen</translation>
    </message>
    <message>
        <source>Lengths and angles on the paper</source>
        <translation>Längen und Winkel auf dem Papier</translation>
    </message>
    <message>
        <source>&amp;Valley</source>
        <translation>&amp;Tal</translation>
    </message>
    <message>
        <source>The fold comes towards you</source>
        <translation>Die Faltung kommt auf Sie zu</translation>
    </message>
    <message>
        <source>&amp;Mountain</source>
        <translation>&amp;Berg</translation>
    </message>
    <message>
        <source>The fold goes away from you</source>
        <translation>Die Faltung geht von Ihnen weg</translation>
    </message>
    <message>
        <source>Turn &amp;over</source>
        <translation>W&amp;enden</translation>
    </message>
    <message>
        <source>Turn the paper over about a vertical line; a step of the model</source>
        <translation>Das Papier um eine senkrechte Linie wenden; ein Schritt des Modells</translation>
    </message>
    <message>
        <source>Turn over top to &amp;bottom</source>
        <translation>&amp;Oben nach unten wenden</translation>
    </message>
    <message>
        <source>Turn the paper over about a horizontal line; a step of the model</source>
        <translation>Das Papier um eine waagerechte Linie wenden; ein Schritt des Modells</translation>
    </message>
    <message>
        <source>Turn the paper in its plane by 90 degrees; a step of the model</source>
        <translation>Das Papier in seiner Ebene um 90 Grad drehen; ein Schritt des Modells</translation>
    </message>
    <message>
        <source>U&amp;nfold all</source>
        <translation>Alles aufkla&amp;ppen</translation>
    </message>
    <message>
        <source>Open all folds; a step of the model</source>
        <translation>Alle Faltungen öffnen; ein Schritt des Modells</translation>
    </message>
    <message>
        <source>Fold again all that was unfolded; a step of the model</source>
        <translation>Alles Aufgeklappte wieder falten; ein Schritt des Modells</translation>
    </message>
    <message>
        <source>Mend everyt&amp;hing</source>
        <translation>Alles &amp;flicken</translation>
    </message>
    <message>
        <source>Join all torn edges whose sides lie together; a step of the model</source>
        <translation>Alle gerissenen Kanten verbinden, deren Seiten beieinanderliegen; ein Schritt des Modells</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>Show all of the model and the sheet</source>
        <translation>Das ganze Modell und das ganze Blatt zeigen</translation>
    </message>
    <message>
        <source>Fro&amp;nt</source>
        <translation>&amp;Vorderseite</translation>
    </message>
    <message>
        <source>Look at the front</source>
        <translation>Von vorn ansehen</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Rückseite</translation>
    </message>
    <message>
        <source>Look at the back</source>
        <translation>Von hinten ansehen</translation>
    </message>
    <message>
        <source>&amp;Angled</source>
        <translation>&amp;Schräg</translation>
    </message>
    <message>
        <source>Look from one side and above</source>
        <translation>Von einer Seite und von oben ansehen</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Perspektive</translation>
    </message>
    <message>
        <source>What is nearer seems larger</source>
        <translation>Näheres erscheint größer</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Ver&amp;größern</translation>
    </message>
    <message>
        <source>Only the flat sheet; again: both panes</source>
        <translation>Nur das flache Blatt; noch einmal: beide Ansichten</translation>
    </message>
    <message>
        <source>&amp;Sheet pane</source>
        <translation>Bla&amp;ttansicht</translation>
    </message>
    <message>
        <source>Show the flat sheet beside the model</source>
        <translation>Das flache Blatt neben dem Modell zeigen</translation>
    </message>
    <message>
        <source>Back of the s&amp;heet</source>
        <translation>Rückseite &amp;des Blattes</translation>
    </message>
    <message>
        <source>The flat sheet from behind</source>
        <translation>Das flache Blatt von hinten</translation>
    </message>
    <message>
        <source>&amp;Creases</source>
        <translation>&amp;Falze</translation>
    </message>
    <message>
        <source>Show creases that lie flat</source>
        <translation>Flach liegende Falze zeigen</translation>
    </message>
    <message>
        <source>&amp;Edges</source>
        <translation>K&amp;anten</translation>
    </message>
    <message>
        <source>Show folded edges</source>
        <translation>Gefaltete Kanten zeigen</translation>
    </message>
    <message>
        <source>Bor&amp;ders</source>
        <translation>&amp;Umrisse</translation>
    </message>
    <message>
        <source>Show the rim of the paper</source>
        <translation>Den Rand des Papiers zeigen</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>Ra&amp;ster</translation>
    </message>
    <message>
        <source>Show a grid on the paper</source>
        <translation>Ein Raster auf dem Papier zeigen</translation>
    </message>
    <message>
        <source>Finer g&amp;rid</source>
        <translation>Fe&amp;ineres Raster</translation>
    </message>
    <message>
        <source>Facets are darker the more they are turned away</source>
        <translation>Flächen sind dunkler, je mehr sie abgewandt sind</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>Vo&amp;llbild</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Abspielen</translation>
    </message>
    <message>
        <source>Show the whole process in motion, or hold it</source>
        <translation>Den ganzen Vorgang in Bewegung zeigen oder anhalten</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Stopp</translation>
    </message>
    <message>
        <source>Leave the film and go on working</source>
        <translation>Den Film verlassen und weiterarbeiten</translation>
    </message>
    <message>
        <source>Step &amp;back</source>
        <translation>Schritt &amp;zurück</translation>
    </message>
    <message>
        <source>To the start of the step before</source>
        <translation>An den Anfang des vorigen Schritts</translation>
    </message>
    <message>
        <source>Step &amp;forward</source>
        <translation>Schritt &amp;vor</translation>
    </message>
    <message>
        <source>To the start of the next step</source>
        <translation>An den Anfang des nächsten Schritts</translation>
    </message>
    <message>
        <source>Slo&amp;wer</source>
        <translation>&amp;Langsamer</translation>
    </message>
    <message>
        <source>F&amp;aster</source>
        <translation>S&amp;chneller</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>S&amp;chleife</translation>
    </message>
    <message>
        <source>Begin again at the end</source>
        <translation>Am Ende von vorn beginnen</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Fold your first &amp;leaf</source>
        <translation>Das erste &amp;Blatt falten</translation>
    </message>
    <message>
        <source>Five steps, each waits for your hand</source>
        <translation>Fünf Schritte, jeder wartet auf Ihre Hand</translation>
    </message>
    <message>
        <source>&amp;About KiriSim</source>
        <translation>&amp;Über KiriSim</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Folds</source>
        <translation>Faltungen</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Letzte öffnen</translation>
    </message>
    <message>
        <source>Exa&amp;mples</source>
        <translation>B&amp;eispiele</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>F&amp;old</source>
        <translation>&amp;Falten</translation>
    </message>
    <message>
        <source>Main bar</source>
        <translation>Hauptleiste</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Ne&amp;w...</source>
        <translation>&amp;Neu...</translation>
    </message>
    <message>
        <source>S&amp;tart page</source>
        <translation>Start&amp;seite</translation>
    </message>
    <message>
        <source>Title and &amp;notes...</source>
        <translation>&amp;Titel und Notizen...</translation>
    </message>
    <message>
        <source>Remo&amp;ve the step</source>
        <translation>Schritt &amp;entfernen</translation>
    </message>
    <message>
        <source>Curve c&amp;ut</source>
        <translation>Kur&amp;venschnitt</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Rotate the paper to the left</source>
        <translation>Papier nach links drehen</translation>
    </message>
    <message>
        <source>Rotate the paper to the right</source>
        <translation>Papier nach rechts drehen</translation>
    </message>
    <message>
        <source>Refol&amp;d all</source>
        <translation>Alles &amp;wieder falten</translation>
    </message>
    <message>
        <source>&amp;Zoom out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>Sheet onl&amp;y</source>
        <translation>Nur das &amp;Blatt</translation>
    </message>
    <message>
        <source>&amp;Model pane</source>
        <translation>&amp;Modellansicht</translation>
    </message>
    <message>
        <source>Coarser grid</source>
        <translation>Gröberes Raster</translation>
    </message>
    <message>
        <source>Soft ligh&amp;t</source>
        <translation>&amp;Weiches Licht</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Working with the paper&lt;/h3&gt;&lt;p&gt;Take up a tool, work in either pane, and press Enter to do what is shown or Esc to drop it. The line at the foot of the window says what to do next.&lt;/p&gt;&lt;p&gt;Drag the background or the right button to turn the model, the middle button or Space to pan, the wheel to zoom. Ctrl suspends snapping; with the wheel it walks through the layers. All keys can be changed in the preferences.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Arbeiten mit dem Papier&lt;/h3&gt;&lt;p&gt;Nehmen Sie ein Werkzeug, arbeiten Sie in einer der Ansichten, und drücken Sie die Eingabetaste, um das Gezeigte auszuführen, oder Esc, um es zu verwerfen. Die Zeile am Fuß des Fensters sagt, was als Nächstes zu tun ist.&lt;/p&gt;&lt;p&gt;Ziehen auf dem Hintergrund oder mit der rechten Taste dreht das Modell, mit der mittleren Taste oder der Leertaste verschiebt es, das Rad vergrößert. Strg setzt das Einrasten aus; mit dem Rad geht es die Lagen durch. Alle Tasten lassen sich in den Einstellungen ändern.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Pane&amp;ls</source>
        <translation>Fenster&amp;teile</translation>
    </message>
    <message>
        <source>P&amp;aste a pattern</source>
        <translation>Faltmuster einf&amp;ügen</translation>
    </message>
    <message>
        <source>A new model from the crease pattern on the clipboard</source>
        <translation>Ein neues Modell aus dem Faltmuster in der Zwischenablage</translation>
    </message>
    <message>
        <source>On to&amp;p</source>
        <translation>Nach &amp;oben</translation>
    </message>
    <message>
        <source>Choose what lies on top, among the folded states of a crease pattern</source>
        <translation>Unter den Faltzuständen eines Faltmusters wählen, was oben liegt</translation>
    </message>
    <message>
        <source>Ne&amp;xt folded state</source>
        <translation>N&amp;ächster Faltzustand</translation>
    </message>
    <message>
        <source>The next state of the chosen component of the crease pattern</source>
        <translation>Der nächste Zustand der gewählten Komponente des Faltmusters</translation>
    </message>
    <message>
        <source>P&amp;revious folded state</source>
        <translation>Vo&amp;riger Faltzustand</translation>
    </message>
    <message>
        <source>The previous state of the chosen component of the crease pattern</source>
        <translation>Der vorige Zustand der gewählten Komponente des Faltmusters</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Faltmuster</translation>
    </message>
    <message>
        <source>Step n&amp;otes</source>
        <translation>Schrittn&amp;otizen</translation>
    </message>
    <message>
        <source>What is done in the step that is shown, below the panes</source>
        <translation>Was im gezeigten Schritt getan wird, unter den Ansichten</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::AboutDialog</name>
    <message>
        <source>About KiriSim</source>
        <translation>Über KiriSim</translation>
    </message>
    <message>
        <source>KiriSim %1</source>
        <translation>KiriSim %1</translation>
    </message>
    <message>
        <source>A virtual-paper laboratory: fold, tear and cut a sheet of paper, unfold it, and see what has become of it.</source>
        <translation>Ein Labor für virtuelles Papier: Falten, reißen und schneiden Sie ein Blatt Papier, klappen Sie es auf und sehen Sie, was daraus geworden ist.</translation>
    </message>
    <message>
        <source>Free software under the MIT licence. The program comes without any warranty.</source>
        <translation>Freie Software unter der MIT-Lizenz. Das Programm kommt ohne jede Gewähr.</translation>
    </message>
    <message>
        <source>Made with %1.</source>
        <translation>Gemacht mit %1.</translation>
    </message>
    <message>
        <source>Copy facts</source>
        <translation>Angaben kopieren</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::AppearanceDialog</name>
    <message>
        <source>Leaf</source>
        <translation>Blatt</translation>
    </message>
    <message>
        <source>Young leaf</source>
        <translation>Junges Blatt</translation>
    </message>
    <message>
        <source>Dark leaf</source>
        <translation>Dunkles Blatt</translation>
    </message>
    <message>
        <source>Autumn</source>
        <translation>Herbst</translation>
    </message>
    <message>
        <source>White paper</source>
        <translation>Weißes Papier</translation>
    </message>
    <message>
        <source>Origami red</source>
        <translation>Origami rot</translation>
    </message>
    <message>
        <source>Origami blue</source>
        <translation>Origami blau</translation>
    </message>
    <message>
        <source>Kraft paper</source>
        <translation>Packpapier</translation>
    </message>
    <message>
        <source>Paper and colours</source>
        <translation>Papier und Farben</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorderseite</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Rückseite</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Farbe…</translation>
    </message>
    <message>
        <source>Image…</source>
        <translation>Bild…</translation>
    </message>
    <message>
        <source>No image</source>
        <translation>Kein Bild</translation>
    </message>
    <message>
        <source>Image of the paper</source>
        <translation>Bild des Papiers</translation>
    </message>
    <message>
        <source>PNG images (*.png)</source>
        <translation>PNG-Bilder (*.png)</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::CaptionBar</name>
    <message>
        <source>Previous step</source>
        <translation>Vorheriger Schritt</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Nächster Schritt</translation>
    </message>
    <message>
        <source>Step by step</source>
        <translation>Schritt für Schritt</translation>
    </message>
    <message>
        <source>About this step</source>
        <translation>Zu diesem Schritt</translation>
    </message>
    <message>
        <source>Begin with the sheet and go through the steps one by one</source>
        <translation>Mit dem Blatt beginnen und einen Schritt nach dem anderen ansehen</translation>
    </message>
    <message>
        <source>1 step</source>
        <translation>1 Schritt</translation>
    </message>
    <message>
        <source>%1 steps</source>
        <translation>%1 Schritte</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::DialogDesk</name>
    <message>
        <source>Your steps cannot be kept safe from crashes: %1</source>
        <translation>Ihre Schritte können nicht vor Abstürzen gesichert werden: %1</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::DialogPrompts</name>
    <message>
        <source>KiriSim models (*.kiri);;All files (*)</source>
        <translation>KiriSim-Modelle (*.kiri);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved.</source>
        <translation>%1 hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>Without saving they are lost.</source>
        <translation>Ohne Speichern gehen sie verloren.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>Das Modell speichern</translation>
    </message>
    <message>
        <source>Models and crease patterns (*.kiri *.fold *.cp *.opx *.svg *.dxf);;KiriSim models (*.kiri);;Crease patterns (*.fold *.cp *.opx *.svg *.dxf);;All files (*)</source>
        <translation>Modelle und Faltmuster (*.kiri *.fold *.cp *.opx *.svg *.dxf);;KiriSim-Modelle (*.kiri);;Faltmuster (*.fold *.cp *.opx *.svg *.dxf);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open a model or a crease pattern</source>
        <translation>Modell oder Faltmuster öffnen</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::EditDesk</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::ExportDialog</name>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>What the file will show</source>
        <translation>Was die Datei zeigen wird</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>The folded model</source>
        <translation>Das gefaltete Modell</translation>
    </message>
    <message>
        <source>The sheet with its creases</source>
        <translation>Das Blatt mit seinen Falzen</translation>
    </message>
    <message>
        <source>&amp;What</source>
        <translation>&amp;Was</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>SVG drawing</source>
        <translation>SVG-Zeichnung</translation>
    </message>
    <message>
        <source>PDF document</source>
        <translation>PDF-Dokument</translation>
    </message>
    <message>
        <source>PNG picture</source>
        <translation>PNG-Bild</translation>
    </message>
    <message>
        <source>FOLD, for origami programs</source>
        <translation>FOLD, für Origami-Programme</translation>
    </message>
    <message>
        <source>Wavefront OBJ</source>
        <translation>Wavefront OBJ</translation>
    </message>
    <message>
        <source>STL, for 3-D printers</source>
        <translation>STL, für 3D-Drucker</translation>
    </message>
    <message>
        <source>glTF, for viewers and the web</source>
        <translation>glTF, für Betrachter und das Web</translation>
    </message>
    <message>
        <source>As on the screen</source>
        <translation>Wie auf dem Bildschirm</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorderseite</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Rückseite</translation>
    </message>
    <message>
        <source>At an angle</source>
        <translation>Schräg</translation>
    </message>
    <message>
        <source>Thesis: mountain blue, valley red</source>
        <translation>Dissertation: Berg blau, Tal rot</translation>
    </message>
    <message>
        <source>Safe for colour-blind eyes</source>
        <translation>Sicher bei Farbenblindheit</translation>
    </message>
    <message>
        <source>Origami programs: mountain red, valley blue</source>
        <translation>Origami-Programme: Berg rot, Tal blau</translation>
    </message>
    <message>
        <source>Printed diagrams: black dashes</source>
        <translation>Gedruckte Anleitungen: schwarz gestrichelt</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>100 %: one millimetre of paper is one millimetre of the picture</source>
        <translation>100 %: Ein Millimeter Papier ist ein Millimeter im Bild</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> dpi</translation>
    </message>
    <message>
        <source>Creases that lie flat</source>
        <translation>Flach liegende Falze</translation>
    </message>
    <message>
        <source>Facets turned away are darker</source>
        <translation>Abgewandte Flächen sind dunkler</translation>
    </message>
    <message>
        <source>Lines only, without the colour of the paper</source>
        <translation>Nur Linien, ohne die Farbe des Papiers</translation>
    </message>
    <message>
        <source>Layers for cutting and scoring machines</source>
        <translation>Ebenen für Schneide- und Ritzmaschinen</translation>
    </message>
    <message>
        <source>Cuts, mountains and valleys in groups and in the colours that cutters and origami programs expect</source>
        <translation>Schnitte, Berge und Täler in Gruppen und in den Farben, die Schneideplotter und Origami-Programme erwarten</translation>
    </message>
    <message>
        <source>White ground instead of none</source>
        <translation>Weißer Grund statt keinem</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>A&amp;nsicht</translation>
    </message>
    <message>
        <source>Creases</source>
        <translation>Falze</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>&amp;Margin</source>
        <translation>&amp;Rand</translation>
    </message>
    <message>
        <source>&amp;Resolution</source>
        <translation>&amp;Auflösung</translation>
    </message>
    <message>
        <source>Unfolded creases count as folded</source>
        <translation>Aufgeklappte Falze gelten als gefaltet</translation>
    </message>
    <message>
        <source>Creases that lie flat again get the angle of their fold, so that the pattern folds in other programs</source>
        <translation>Wieder flache Falze bekommen den Winkel ihrer Faltung, damit sich das Muster in anderen Programmen falten lässt</translation>
    </message>
    <message>
        <source>Triangles for the back as well</source>
        <translation>Dreiecke auch für die Rückseite</translation>
    </message>
    <message>
        <source>All steps in motion</source>
        <translation>Alle Schritte in Bewegung</translation>
    </message>
    <message>
        <source>&amp;Gap between layers</source>
        <translation>A&amp;bstand der Lagen</translation>
    </message>
    <message>
        <source>&amp;Thickness of paper</source>
        <translation>&amp;Dicke des Papiers</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation>%1-Dateien (*.%2)</translation>
    </message>
    <message>
        <source>Writing %1…</source>
        <translation>%1 wird geschrieben…</translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation>Angehalten; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Written: &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt;.</source>
        <translation>Geschrieben: &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt;.</translation>
    </message>
    <message>
        <source>CP, of ORIPA and Oriedita</source>
        <translation>CP, von ORIPA und Oriedita</translation>
    </message>
    <message>
        <source>OPX, of ORIPA</source>
        <translation>OPX, von ORIPA</translation>
    </message>
    <message>
        <source>DXF, for cutters and CAD</source>
        <translation>DXF, für Schneidemaschinen und CAD</translation>
    </message>
    <message>
        <source>This format cannot hold:</source>
        <translation>Dieses Format kann nicht aufnehmen:</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::FieldBar</name>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>The fields that have no room here</source>
        <translation>Die Felder, die hier keinen Platz haben</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::FileDesk</name>
    <message>
        <source>Untitled</source>
        <translation>Ohne Titel</translation>
    </message>
    <message>
        <source>The model cannot be opened</source>
        <translation>Das Modell kann nicht geöffnet werden</translation>
    </message>
    <message>
        <source>The model cannot be saved</source>
        <translation>Das Modell kann nicht gespeichert werden</translation>
    </message>
    <message>
        <source>There is no crease pattern on the clipboard: copy a file (FOLD, CP, OPX, SVG, DXF) or the text of one</source>
        <translation>In der Zwischenablage ist kein Faltmuster: eine Datei (FOLD, CP, OPX, SVG, DXF) oder ihren Text kopieren</translation>
    </message>
    <message>
        <source>the pasted pattern</source>
        <translation>das eingefügte Faltmuster</translation>
    </message>
    <message>
        <source>%1 has the name of a crease pattern. A model is saved as .kiri, with all its steps; use Export to write a crease pattern.</source>
        <translation>%1 heißt wie ein Faltmuster. Ein Modell wird mit allen Schritten als .kiri gespeichert; Faltmuster schreibt „Exportieren“.</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::FilmDialog</name>
    <message>
        <source>Export film</source>
        <translation>Film exportieren</translation>
    </message>
    <message>
        <source>The steps in motion, as the player shows them, seen by a camera that holds still or goes round the model.</source>
        <translation>Die Schritte in Bewegung, wie der Abspieler sie zeigt, von einer Kamera gesehen, die stillhält oder um das Modell geht.</translation>
    </message>
    <message>
        <source>MP4, plays everywhere</source>
        <translation>MP4, läuft überall</translation>
    </message>
    <message>
        <source>GIF, runs by itself on web pages</source>
        <translation>GIF, läuft auf Webseiten von selbst</translation>
    </message>
    <message>
        <source>WebP, without loss</source>
        <translation>WebP, ohne Verlust</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 Pixel</translation>
    </message>
    <message>
        <source>At an angle</source>
        <translation>Schräg</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorderseite</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Rückseite</translation>
    </message>
    <message>
        <source>The camera goes once round the model</source>
        <translation>Die Kamera geht einmal um das Modell</translation>
    </message>
    <message>
        <source>Creases that lie flat</source>
        <translation>Flach liegende Falze</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source> per second</source>
        <translation> je Sekunde</translation>
    </message>
    <message>
        <source>° per second</source>
        <translation>° je Sekunde</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>S&amp;teps</source>
        <translation>S&amp;chritte</translation>
    </message>
    <message>
        <source>F&amp;rames</source>
        <translation>B&amp;ilder</translation>
    </message>
    <message>
        <source>S&amp;peed of folding</source>
        <translation>&amp;Tempo des Faltens</translation>
    </message>
    <message>
        <source>&amp;Rest after each step</source>
        <translation>&amp;Pause nach jedem Schritt</translation>
    </message>
    <message>
        <source>Export film…</source>
        <translation>Film exportieren…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Films are made by the program ffmpeg, which is not installed here. On Debian and Ubuntu: &lt;b&gt;sudo apt install ffmpeg&lt;/b&gt;. Then open this dialog again.</source>
        <translation>Filme macht das Programm ffmpeg, das hier nicht installiert ist. Unter Debian und Ubuntu: &lt;b&gt;sudo apt install ffmpeg&lt;/b&gt;. Öffnen Sie danach diesen Dialog noch einmal.</translation>
    </message>
    <message>
        <source>The model has no steps yet: there is nothing to film.</source>
        <translation>Das Modell hat noch keine Schritte: Es gibt nichts zu filmen.</translation>
    </message>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation>%1-Dateien (*.%2)</translation>
    </message>
    <message>
        <source>Filming %1…</source>
        <translation>%1 wird gefilmt…</translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation>Angehalten; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Written: &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt;.</source>
        <translation>Geschrieben: &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt;.</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::FoldRow</name>
    <message>
        <source>Angle of %1</source>
        <translation>Winkel von %1</translation>
    </message>
    <message>
        <source>This fold line has no hinges left</source>
        <translation>Diese Faltlinie hat keine Falze mehr</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::FoldsPanel</name>
    <message>
        <source>Each fold line gets a slider here.</source>
        <translation>Jede Faltlinie bekommt hier einen Regler.</translation>
    </message>
    <message>
        <source>Together</source>
        <translation>Zusammen</translation>
    </message>
    <message>
        <source>All folds open at once, as leaves do</source>
        <translation>Alle Faltungen öffnen sich zugleich, wie bei Blättern</translation>
    </message>
    <message>
        <source>In order</source>
        <translation>Nacheinander</translation>
    </message>
    <message>
        <source>Folds open one after the other, the last one first</source>
        <translation>Die Faltungen öffnen sich nacheinander, die letzte zuerst</translation>
    </message>
    <message>
        <source>Folded</source>
        <translation>Gefaltet</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Offen</translation>
    </message>
    <message>
        <source>All folds</source>
        <translation>Alle Faltungen</translation>
    </message>
    <message>
        <source>Opens all folds</source>
        <translation>Öffnet alle Faltungen</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::GalleryPart</name>
    <message>
        <source>No example has these words.</source>
        <translation>Kein Beispiel enthält diese Wörter.</translation>
    </message>
    <message>
        <source>Search the examples</source>
        <translation>Beispiele durchsuchen</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Beispiele</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::MainWindow</name>
    <message>
        <source>Saved as %1</source>
        <translation>Gespeichert als %1</translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation>Noch keine Dateien</translation>
    </message>
    <message>
        <source>Forget these</source>
        <translation>Diese vergessen</translation>
    </message>
    <message>
        <source>Take a new sheet, a file or an example, or fold your first leaf; Esc: back to the model</source>
        <translation>Ein neues Blatt, eine Datei oder ein Beispiel wählen oder das erste Blatt falten; Esc: zurück zum Modell</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::ModelPreview</name>
    <message>
        <source>folded</source>
        <translation>gefaltet</translation>
    </message>
    <message>
        <source>half unfolded</source>
        <translation>halb entfaltet</translation>
    </message>
    <message>
        <source>half folded</source>
        <translation>halb gefaltet</translation>
    </message>
    <message>
        <source>unfolded</source>
        <translation>entfaltet</translation>
    </message>
    <message>
        <source>Point at a model to see more of it.</source>
        <translation>Zeigen Sie auf ein Modell, um mehr davon zu sehen.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>More about the model</source>
        <translation>Mehr über das Modell</translation>
    </message>
    <message>
        <source>1 step</source>
        <translation>1 Schritt</translation>
    </message>
    <message>
        <source>%1 steps</source>
        <translation>%1 Schritte</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::ModelView</name>
    <message>
        <source>There is no OpenGL 3.3 or OpenGL ES 3 here, so pictures are made by the program itself and come a little later.</source>
        <translation>Hier gibt es kein OpenGL 3.3 oder OpenGL ES 3; das Programm zeichnet deshalb selbst, und Bilder kommen etwas später.</translation>
    </message>
    <message>
        <source>The graphics card cannot be used (%1), so pictures are made by the program itself and come a little later.</source>
        <translation>Die Grafikkarte kann nicht benutzt werden (%1); das Programm zeichnet deshalb selbst, und Bilder kommen etwas später.</translation>
    </message>
    <message>
        <source>The folded model</source>
        <translation>Das gefaltete Modell</translation>
    </message>
    <message>
        <source>Fold, cut and turn the paper here</source>
        <translation>Hier das Papier falten, schneiden und drehen</translation>
    </message>
    <message>
        <source>the program itself</source>
        <translation>das Programm selbst</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::PageTiles</name>
    <message>
        <source>%1%2 of %3 × %4 pages, true size</source>
        <translation>%1%2 von %3 × %4 Seiten, wahre Größe</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::PatternPanel</name>
    <message>
        <source>Open, paste or drop a crease pattern (FOLD, CP, OPX, SVG, DXF): its faults and its folded states are listed here.</source>
        <translation>Ein Faltmuster (FOLD, CP, OPX, SVG, DXF) öffnen, einfügen oder hierher ziehen: Seine Fehler und Faltzustände stehen dann hier.</translation>
    </message>
    <message>
        <source>Marked in the sheet</source>
        <translation>Im Blatt markiert</translation>
    </message>
    <message>
        <source>Repairs and remarks</source>
        <translation>Reparaturen und Hinweise</translation>
    </message>
    <message>
        <source>Component</source>
        <translation>Komponente</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Components of the folded states</source>
        <translation>Komponenten der Faltzustände</translation>
    </message>
    <message>
        <source>Faults of vertices</source>
        <translation>Fehler an Eckpunkten</translation>
    </message>
    <message>
        <source>Looking for folded states…</source>
        <translation>Faltzustände werden gesucht …</translation>
    </message>
    <message>
        <source>It was not looked for folded states.</source>
        <translation>Nach Faltzuständen wurde nicht gesucht.</translation>
    </message>
    <message>
        <source>The pattern folds flat.</source>
        <translation>Das Muster lässt sich flach falten.</translation>
    </message>
    <message>
        <source>The pattern does not fold flat.</source>
        <translation>Das Muster lässt sich nicht flach falten.</translation>
    </message>
    <message>
        <source>No folded state: these facets cannot be ordered.</source>
        <translation>Kein Faltzustand: Diese Flächen lassen sich nicht ordnen.</translation>
    </message>
    <message>
        <source>1 folded state</source>
        <translation>1 Faltzustand</translation>
    </message>
    <message>
        <source>%1 folded states</source>
        <translation>%1 Faltzustände</translation>
    </message>
    <message>
        <source>Counting folded states…</source>
        <translation>Faltzustände werden gezählt …</translation>
    </message>
    <message>
        <source>Folded states: not counted</source>
        <translation>Faltzustände: nicht gezählt</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Zählen</translation>
    </message>
    <message>
        <source>Previous state</source>
        <translation>Voriger Zustand</translation>
    </message>
    <message>
        <source>Next state</source>
        <translation>Nächster Zustand</translation>
    </message>
    <message>
        <source>%1: %2 facets</source>
        <translation>%1: %2 Flächen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>1 fault of a vertex</source>
        <translation>1 Fehler an einem Eckpunkt</translation>
    </message>
    <message>
        <source>%1 faults of vertices</source>
        <translation>%1 Fehler an Eckpunkten</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::PlayerBar</name>
    <message>
        <source>Play or pause</source>
        <translation>Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>Begin again at the end</source>
        <translation>Am Ende von vorn beginnen</translation>
    </message>
    <message>
        <source>Leave the film</source>
        <translation>Den Film verlassen</translation>
    </message>
    <message>
        <source>To the start of the step before</source>
        <translation>An den Anfang des vorigen Schritts</translation>
    </message>
    <message>
        <source>To the start of the next step</source>
        <translation>An den Anfang des nächsten Schritts</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Time of the film</source>
        <translation>Zeit des Films</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Help for the hand</source>
        <translation>Hilfe für die Hand</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Wie der Desktop</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Thesis: mountain blue, valley red</source>
        <translation>Dissertation: Berg blau, Tal rot</translation>
    </message>
    <message>
        <source>Safe for colour-blind eyes</source>
        <translation>Sicher bei Farbenblindheit</translation>
    </message>
    <message>
        <source>Origami programs: mountain red, valley blue</source>
        <translation>Origami-Programme: Berg rot, Tal blau</translation>
    </message>
    <message>
        <source>Printed diagrams: black dashes</source>
        <translation>Gedruckte Anleitungen: schwarz gestrichelt</translation>
    </message>
    <message>
        <source>What is nearer looks larger</source>
        <translation>Näheres erscheint größer</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Show the start page when the program starts</source>
        <translation>Beim Start des Programms die Startseite zeigen</translation>
    </message>
    <message>
        <source>Show hints</source>
        <translation>Hinweise zeigen</translation>
    </message>
    <message>
        <source>Keep every step safe from crashes</source>
        <translation>Jeden Schritt vor Abstürzen sichern</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>C&amp;reases</source>
        <translation>Fal&amp;ze</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>Another language is shown when the program starts again. All lengths are in millimetres, all angles in degrees.</source>
        <translation>Eine andere Sprache zeigt das Programm beim nächsten Start. Alle Längen sind in Millimetern, alle Winkel in Grad.</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Perspektive</translation>
    </message>
    <message>
        <source>&amp;Field of view</source>
        <translation>&amp;Bildwinkel</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>Points are caught by what is near</source>
        <translation>Punkte rasten bei Nahem ein</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>Middles of edges</source>
        <translation>Mitten von Kanten</translation>
    </message>
    <message>
        <source>Crossings</source>
        <translation>Kreuzungen</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> pixels</source>
        <translation> Pixel</translation>
    </message>
    <message>
        <source>&amp;Snapping</source>
        <translation>E&amp;inrasten</translation>
    </message>
    <message>
        <source>Caught by</source>
        <translation>Einrasten an</translation>
    </message>
    <message>
        <source>&amp;Parts of edges</source>
        <translation>&amp;Teile von Kanten</translation>
    </message>
    <message>
        <source>&amp;Directions every</source>
        <translation>Ri&amp;chtungen alle</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Raster</translation>
    </message>
    <message>
        <source>&amp;Reach</source>
        <translation>Rei&amp;chweite</translation>
    </message>
    <message>
        <source>Holding Ctrl while drawing suspends all of this.</source>
        <translation>Strg beim Zeichnen zu halten setzt all das aus.</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::PrintDialog</name>
    <message>
        <source>Print</source>
        <translation>Drucken</translation>
    </message>
    <message>
        <source>The sheet with its creases</source>
        <translation>Das Blatt mit seinen Falzen</translation>
    </message>
    <message>
        <source>The folded model</source>
        <translation>Das gefaltete Modell</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorderseite</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Rückseite</translation>
    </message>
    <message>
        <source>As on the screen</source>
        <translation>Wie auf dem Bildschirm</translation>
    </message>
    <message>
        <source>In colour</source>
        <translation>In Farbe</translation>
    </message>
    <message>
        <source>Black dashes</source>
        <translation>Schwarz gestrichelt</translation>
    </message>
    <message>
        <source>Upright</source>
        <translation>Hochformat</translation>
    </message>
    <message>
        <source>Lying</source>
        <translation>Querformat</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Lines only</source>
        <translation>Nur Linien</translation>
    </message>
    <message>
        <source>Unfolded creases too</source>
        <translation>Auch aufgeklappte Falze</translation>
    </message>
    <message>
        <source>&amp;What</source>
        <translation>&amp;Was</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Creases</source>
        <translation>&amp;Falze</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>P&amp;aper</source>
        <translation>Pa&amp;pier</translation>
    </message>
    <message>
        <source>&amp;Orientation</source>
        <translation>A&amp;usrichtung</translation>
    </message>
    <message>
        <source>&amp;Glued strip</source>
        <translation>&amp;Klebestreifen</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>Drucken…</translation>
    </message>
    <message>
        <source>Save pages as PDF…</source>
        <translation>Seiten als PDF speichern…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>No printer is set up on this machine; pages can be saved as PDF</source>
        <translation>Auf diesem Rechner ist kein Drucker eingerichtet; Seiten können als PDF gespeichert werden</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>%1, on one page</source>
        <translation>%1, auf einer Seite</translation>
    </message>
    <message>
        <source>%1, on %2 × %3 pages to be glued together</source>
        <translation>%1, auf %2 × %3 Seiten zum Zusammenkleben</translation>
    </message>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Save pages as PDF</source>
        <translation>Seiten als PDF speichern</translation>
    </message>
    <message>
        <source>PDF files (*.pdf)</source>
        <translation>PDF-Dateien (*.pdf)</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>%1 kann nicht geschrieben werden.</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::PropertiesDialog</name>
    <message>
        <source>Title and notes</source>
        <translation>Titel und Notizen</translation>
    </message>
    <message>
        <source>&amp;Title</source>
        <translation>&amp;Titel</translation>
    </message>
    <message>
        <source>&amp;Notes</source>
        <translation>&amp;Notizen</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::RecoveryDialog</name>
    <message>
        <source>A model without a name</source>
        <translation>Ein Modell ohne Namen</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n Schritt</numerusform>
            <numerusform>%n Schritte</numerusform>
        </translation>
    </message>
    <message>
        <source>never saved</source>
        <translation>nie gespeichert</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>KiriSim did not end in order the last time. What you were working on has been kept, up to the last step.</source>
        <translation>KiriSim ist beim letzten Mal nicht ordentlich beendet worden. Woran Sie arbeiteten, ist bis zum letzten Schritt erhalten.</translation>
    </message>
    <message>
        <source>Models that can be recovered</source>
        <translation>Modelle, die wiederhergestellt werden können</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>Discard…</source>
        <translation>Verwerfen…</translation>
    </message>
    <message>
        <source>Your work is safe</source>
        <translation>Ihre Arbeit ist sicher</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Discard what was kept of “%1”? It cannot be brought back.</source>
        <translation>Verwerfen, was von „%1“ erhalten ist? Es lässt sich nicht zurückholen.</translation>
    </message>
    <message>
        <source>An error in KiriSim</source>
        <translation>Ein Fehler in KiriSim</translation>
    </message>
    <message>
        <source>KiriSim has found an error in itself. Your model is as it was before; save it under another name and start the program again.</source>
        <translation>KiriSim hat einen Fehler in sich selbst gefunden. Ihr Modell ist, wie es vorher war; speichern Sie es unter einem anderen Namen, und starten Sie das Programm neu.</translation>
    </message>
    <message>
        <source>A report is in %1.</source>
        <translation>Ein Bericht liegt in %1.</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::SheetDialog</name>
    <message>
        <source>Sheet</source>
        <translation>Blatt</translation>
    </message>
    <message>
        <source>Own size</source>
        <translation>Eigene Größe</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Quadrat</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Disc</source>
        <translation>Scheibe</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Vieleck</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>&amp;Paper</source>
        <translation>&amp;Papier</translation>
    </message>
    <message>
        <source>&amp;Shape</source>
        <translation>&amp;Form</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Höhe</translation>
    </message>
    <message>
        <source>The sheet</source>
        <translation>Das Blatt</translation>
    </message>
    <message>
        <source>&amp;Diameter</source>
        <translation>&amp;Durchmesser</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::SheetView</name>
    <message>
        <source>The flat sheet</source>
        <translation>Das flache Blatt</translation>
    </message>
    <message>
        <source>The crease pattern on the unfolded paper</source>
        <translation>Das Faltmuster auf dem aufgeklappten Papier</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::ShortcutEditor</name>
    <message>
        <source>Search actions and keys</source>
        <translation>Aktionen und Tasten suchen</translation>
    </message>
    <message>
        <source>KiriSim</source>
        <translation>KiriSim</translation>
    </message>
    <message>
        <source>Oriedita</source>
        <translation>Oriedita</translation>
    </message>
    <message>
        <source>Orimath</source>
        <translation>Orimath</translation>
    </message>
    <message>
        <source>Keys as in another program</source>
        <translation>Tasten wie in einem anderen Programm</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Keys as in</source>
        <translation>Tasten wie in</translation>
    </message>
    <message>
        <source>Click here and press the keys</source>
        <translation>Hier klicken und die Tasten drücken</translation>
    </message>
    <message>
        <source>No key</source>
        <translation>Keine Taste</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>%1 has the same keys as %2.</source>
        <translation>%1 hat dieselben Tasten wie %2.</translation>
    </message>
    <message>
        <source>Keys of “%1”</source>
        <translation>Tasten von „%1“</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::StartPage</name>
    <message>
        <source>Recent</source>
        <translation>Zuletzt benutzt</translation>
    </message>
    <message>
        <source>Fold, tear and cut a sheet of paper.</source>
        <translation>Ein Blatt Papier falten, reißen und schneiden.</translation>
    </message>
    <message>
        <source>Fold your first leaf</source>
        <translation>Das erste Blatt falten</translation>
    </message>
    <message>
        <source>Five steps, each waits for your hand</source>
        <translation>Fünf Schritte, jeder wartet auf Ihre Hand</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>New sheet</source>
        <translation>Neues Blatt</translation>
    </message>
    <message>
        <source>Other…</source>
        <translation>Anderes…</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::StatusLine</name>
    <message>
        <source>Stop this work</source>
        <translation>Diese Arbeit anhalten</translation>
    </message>
    <message>
        <source>1 facet</source>
        <translation>1 Fläche</translation>
    </message>
    <message>
        <source>%1 facets</source>
        <translation>%1 Flächen</translation>
    </message>
    <message>
        <source>1 layer</source>
        <translation>1 Lage</translation>
    </message>
    <message>
        <source>%1 layers</source>
        <translation>%1 Lagen</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>1 collision</source>
        <translation>1 Kollision</translation>
    </message>
    <message>
        <source>%1 collisions</source>
        <translation>%1 Kollisionen</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::StepPanel</name>
    <message>
        <source>The untouched sheet. Fold, cut or tear it; each step can be changed here later.</source>
        <translation>Das unberührte Blatt. Falten, schneiden oder reißen Sie es; jeder Schritt kann hier später geändert werden.</translation>
    </message>
    <message>
        <source>Remove this step</source>
        <translation>Diesen Schritt entfernen</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>This step does not apply: %1</source>
        <translation>Dieser Schritt geht nicht: %1</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::StepsList</name>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Show the model here</source>
        <translation>Das Modell hier zeigen</translation>
    </message>
    <message>
        <source>Change this step</source>
        <translation>Diesen Schritt ändern</translation>
    </message>
    <message>
        <source>Remove this step</source>
        <translation>Diesen Schritt entfernen</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::StepsModel</name>
    <message>
        <source>Sheet</source>
        <translation>Blatt</translation>
    </message>
</context>
<context>
    <name>kiri::desktop::TourCard</name>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Führung beenden</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>KiriSim: fold, tear, cut and unfold virtual paper.</source>
        <translation>KiriSim: virtuelles Papier falten, reißen, schneiden und aufklappen.</translation>
    </message>
    <message>
        <source>Draw without the graphics card.</source>
        <translation>Ohne die Grafikkarte zeichnen.</translation>
    </message>
    <message>
        <source>A model (.kiri) or a crease pattern (.fold, .cp, .opx, .svg, .dxf) to open.</source>
        <translation>Ein Modell (.kiri) oder Faltmuster (.fold, .cp, .opx, .svg, .dxf), das geöffnet wird.</translation>
    </message>
</context>
</TS>
