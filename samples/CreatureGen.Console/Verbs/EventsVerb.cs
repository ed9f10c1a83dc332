using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Console.Text;
using CreatureGen.Console.Working;
using CreatureGen.Events;
using CreatureGen.Gltf.Models;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Png;

namespace CreatureGen.Console.Verbs;

/// <summary>Finds footsteps, whooshes and the like in the clips of a file.</summary>
internal sealed class EventsVerb : IVerb
{
    private static readonly OptionSyntax preset = new("--preset", "RULE", "what to look for: " + string.Join(", ", AngularRules.All.Select(rule => rule.Name)) + " (default footstep)") { Words = AngularRules.All.Select(rule => rule.Name).ToArray() };
    private static readonly OptionSyntax plot = new("--plot", "FILE", "a PNG to write: the curve of each joint with its events");

    /// <inheritdoc/>
    public VerbSyntax Syntax { get; } = new(
        "events",
        "FILE",
        "find moments for sounds in the clips of a .glb, by how bones turn",
        [
            new("events creature-42.glb --preset footstep --plot steps.png", "when feet come down, and the curves that tell it"),
            new("events hero.glb --preset whoosh --json", "any skinned character, as JSON"),
        ],
        [preset, plot, CommonOptions.Json]);

    /// <inheritdoc/>
    public int Run(ParsedArguments arguments, Surroundings surroundings)
    {
        string path = surroundings.Locate(arguments.Operand);
        AngularRule rule = ReadRule(arguments);
        string? picture = arguments.Value(plot.Name) is { } to ? surroundings.Locate(to) : null;
        if (picture != null)
        {
            FileSet.RequireWritable(picture, surroundings);
        }

        SkinnedModel model = ModelFile.Read(path, surroundings);
        (IClip Clip, AngularFinding Finding)[] clips = model.Clips.Select(clip => ((IClip)clip, AngularEventDetector.Find(clip, model.Skeleton, rule))).ToArray();
        if (clips.Length == 0)
        {
            throw new UsageError($"'{path}' has no clips; expected a file with animations, as generate --clips all writes them");
        }

        if (picture != null)
        {
            byte[] png = PngWriter.ToBytes(EventPlot.Draw(clips));
            FileSet.Write(picture, stream => stream.Write(png), surroundings);
        }

        if (arguments.Has(CommonOptions.Json.Name))
        {
            WriteJson(surroundings.Out, clips);
        }
        else
        {
            WriteText(surroundings.Out, clips);
        }

        return ExitCode.Done;
    }

    private static AngularRule ReadRule(ParsedArguments arguments)
    {
        string name = arguments.Value(preset.Name) ?? AngularRules.Footstep.Name;
        return AngularRules.All.FirstOrDefault(rule => rule.Name == name) ?? throw arguments.Wrong(preset.Name, name, "one of " + string.Join(", ", preset.Words) + Suggestion.For(name, preset.Words));
    }

    private static void WriteText(TextWriter output, IReadOnlyList<(IClip Clip, AngularFinding Finding)> clips)
    {
        foreach ((IClip clip, AngularFinding finding) in clips)
        {
            output.WriteLine(FormattableString.Invariant($"{clip.Name}  {clip.Duration:0.00} s, {finding.Events.Count} events"));
            foreach (ClipEvent one in finding.Events)
            {
                output.WriteLine(FormattableString.Invariant($"  {one.Time,7:0.000}  {one.Name}  {one.Joint}  x{one.Strength:0.0}"));
            }
        }
    }

    private static void WriteJson(TextWriter output, IReadOnlyList<(IClip Clip, AngularFinding Finding)> clips) => output.Write(JsonText.Document(json =>
    {
        json.WriteStartObject();
        json.WriteStartArray("clips");
        foreach ((IClip clip, AngularFinding finding) in clips)
        {
            json.WriteStartObject();
            json.WriteString("name", clip.Name);
            json.WriteStartArray("events");
            foreach (ClipEvent one in finding.Events)
            {
                json.WriteStartObject();
                json.WriteNumber("time", one.Time);
                json.WriteString("name", one.Name);
                json.WriteString("joint", one.Joint);
                json.WriteNumber("strength", one.Strength);
                json.WriteEndObject();
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }));
}
