using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Gltf.Models;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;

namespace CreatureGen.Console.Verbs;

/// <summary>Gives a skinned character of another program the motion of creatures.</summary>
internal sealed class TeachVerb : IVerb
{
    private static readonly OptionSyntax mass = new("--mass", "KG", "what the character weighs, kilograms (default: what flesh around its bones weighs)");

    /// <inheritdoc/>
    public VerbSyntax Syntax { get; } = new(
        "teach",
        "FILE",
        "add to a skinned character on legs, of any program, the motion of creatures as clips",
        [
            new("teach hero.glb --out hero-moves.glb", "everything that a body like this does"),
            new("teach wolf.glb --clips idle,walk,trot,jump --mass 40 --out wolf-moves.glb", "four things, by a body of forty kilograms"),
        ],
        [ExportOptions.Clips, mass, CommonOptions.OutFile, CommonOptions.Quiet]);

    /// <inheritdoc/>
    public int Run(ParsedArguments arguments, Surroundings surroundings)
    {
        string from = surroundings.Locate(arguments.Operand);
        string to = surroundings.Locate(arguments.Required(CommonOptions.OutFile.Name));
        ClipChoice choice = ExportOptions.ReadClips(arguments, ClipChoice.All);
        float? weight = ReadMass(arguments);
        FileSet.RequireWritable(to, surroundings);
        SkinnedModel model = ModelFile.Read(from, surroundings);
        RiggedBody body = Body(model, weight, from);
        Clip[] clips = choice == ClipChoice.None ? [] : [.. choice.Bake(new MotionProfile(body.Subject), surroundings.Cancellation).Select(body.Bring)];
        RequireNew(model, clips, from);
        using var bytes = new MemoryStream();
        ModelWriter.Write(model, clips, bytes);
        FileSet.Write(to, stream => bytes.WriteTo(stream), surroundings);
        if (!arguments.Has(CommonOptions.Quiet.Name))
        {
            surroundings.Out.WriteLine(FormattableString.Invariant($"{to}  {clips.Length} clips added: {string.Join(", ", clips.Select(clip => clip.Name))}"));
        }

        return ExitCode.Done;
    }

    private static float? ReadMass(ParsedArguments arguments)
    {
        if (arguments.Value(mass.Name) is not string text)
        {
            return null;
        }

        return float.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out float kilograms) && kilograms > 0f && float.IsFinite(kilograms) ? kilograms : throw arguments.Wrong(mass.Name, text, "a positive number of kilograms");
    }

    private static RiggedBody Body(SkinnedModel model, float? weight, string from)
    {
        try
        {
            return new RiggedBody(model.Skeleton, mass: weight);
        }
        catch (ArgumentException lack)
        {
            throw new UsageError($"cannot teach '{from}': {lack.Message}");
        }
    }

    private static void RequireNew(SkinnedModel model, IReadOnlyList<Clip> clips, string from)
    {
        string[] taken = [.. clips.Select(clip => clip.Name).Intersect(model.Clips.Select(clip => clip.Name), StringComparer.Ordinal)];
        if (taken.Length > 0)
        {
            throw new UsageError($"'{from}' has clips of these names already: {string.Join(", ", taken)}; expected others, by --clips");
        }
    }
}
