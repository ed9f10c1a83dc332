using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using CreatureGen.Anatomy;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Working;

namespace CreatureGen.Console.Text;

/// <summary>A page of HTML that shows creatures and leads to their files beside it. It has no script and loads nothing from elsewhere; which kinds are seen is chosen by buttons.</summary>
internal static class GalleryPage
{
    private const string Style = """
        :root{color-scheme:light dark;--line:#8885;--soft:#8881}
        body{font:16px/1.5 system-ui,sans-serif;max-width:90rem;margin:0 auto;padding:1rem}
        h1{font-size:1.5rem;margin:.2rem 0 .6rem}
        fieldset{border:0;padding:0;margin:0 0 1rem}
        label{display:inline-block;padding:.25rem .8rem;margin:0 .4rem .4rem 0;border:1px solid var(--line);border-radius:2rem;cursor:pointer}
        input{position:absolute;opacity:0}
        label:has(:checked){background:CanvasText;color:Canvas}
        label:has(:focus-visible){outline:2px solid Highlight}
        main{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,20rem),1fr));gap:1rem}
        figure{margin:0;border:1px solid var(--line);border-radius:.6rem;overflow:hidden}
        img{display:block;width:100%;height:auto;background:var(--soft)}
        figcaption{padding:.5rem .8rem .8rem}
        figcaption p{margin:.1rem 0;font-size:.9rem;opacity:.85}
        h2{font-size:1.05rem;margin:0}
        a{color:LinkText}
        """;

    /// <summary>The page.</summary>
    /// <param name="creatures">Those that are on it, in their order; their files lie beside the page.</param>
    public static string Of(IReadOnlyList<GeneratedCreature> creatures)
    {
        LocomotionKind[] kinds = creatures.Select(creature => creature.Facts.Kind).Distinct().Order().ToArray();
        var page = new StringBuilder();
        Line(page, "<!doctype html>");
        Line(page, "<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\">");
        Line(page, "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src 'self' file:; style-src 'unsafe-inline'\">");
        Line(page, $"<title>{Units.Count(creatures.Count)} creatures</title>");
        Line(page, "<style>");
        Line(page, Style.ReplaceLineEndings("\n"));
        Line(page, string.Concat(kinds.Select(kind => Word(kind)).Select(kind => $"body:has(#{kind}:checked) figure:not(.{kind}){{display:none}}")));
        Line(page, "</style></head><body>");
        Line(page, $"<h1>{Units.Count(creatures.Count)} creatures</h1>");
        if (kinds.Length > 1)
        {
            Line(page, "<fieldset><legend hidden>Which are shown</legend><label><input type=\"radio\" name=\"kind\" checked>all</label>" + string.Concat(kinds.Select(kind => Word(kind)).Select(kind => $"<label><input type=\"radio\" name=\"kind\" id=\"{kind}\">{kind}</label>")) + "</fieldset>");
        }

        Line(page, "<main>");
        foreach (GeneratedCreature creature in creatures)
        {
            Write(page, creature);
        }

        Line(page, "</main></body></html>");
        return page.ToString();
    }

    private static void Write(StringBuilder page, GeneratedCreature creature)
    {
        CreatureFacts facts = creature.Facts;
        CreatureFile glb = Find(creature, "glb");
        string kind = Word(facts.Kind);
        Line(page, $"<figure class=\"{kind}\"><img src=\"{Name(Find(creature, "png"))}\" alt=\"A {kind} creature, {CreatureText.Plan(facts)}\" loading=\"lazy\"><figcaption>");
        Line(page, $"<h2>{facts.Specimen.Name}: {kind}, {CreatureText.Plan(facts)}</h2>");
        Line(page, $"<p>{CreatureText.Body(facts)}</p>");
        Line(page, $"<p>{Units.Metres(facts.Size.Z)} m long, {Units.Metres(facts.Size.Y)} m high, {Units.Kilograms(facts.Mass)}, {Units.Count(facts.Joints)} joints, {Units.Count(facts.Triangles)} triangles</p>");
        Line(page, $"<p><a href=\"{Name(glb)}\" download>GLB</a> ({Units.Bytes(glb.Bytes)}) · <a href=\"{Name(Find(creature, "json"))}\" download>blueprint</a></p>");
        Line(page, "</figcaption></figure>");
    }

    private static CreatureFile Find(GeneratedCreature creature, string form) => creature.Files.First(file => file.Form == form);

    private static string Name(CreatureFile file) => Path.GetFileName(file.Path);

    private static string Word(LocomotionKind kind) => WordList<LocomotionKind>.Instance[kind];

    private static void Line(StringBuilder page, string text) => page.Append(text).Append('\n');
}
