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
    private static readonly OptionSyntax mass = new("--mass", "KG", "what the character weighs, kilograms (default: what flesh within its skin weighs)");

    private static readonly OptionSyntax unit = new("--unit", "METRES", "metres in a unit of the file (default: 1, as files should have it); 0.01 for a character in centimetres");

    /// <inheritdoc/>
    public VerbSyntax Syntax { get; } = new(
        "teach",
        "FILE",
        "add to a skinned character on legs, of any program, the motion of creatures as clips",
        [
            new("teach hero.glb --out hero-moves.glb", "everything that a body like this does"),
            new("teach wolf.glb --clips idle,walk,trot,jump --mass 40 --out wolf-moves.glb", "four things, by a body of forty kilograms"),
            new("teach fox.glb --unit 0.01 --out fox-moves.glb", "a fox whose file is in centimetres"),
        ],
        [ExportOptions.Clips, mass, unit, CommonOptions.OutFile, CommonOptions.Quiet]);

    /// <inheritdoc/>
    public int Run(ParsedArguments arguments, Surroundings surroundings)
    {
        string from = surroundings.Locate(arguments.Operand);
        string to = surroundings.Locate(arguments.Required(CommonOptions.OutFile.Name));
        ClipChoice choice = ExportOptions.ReadClips(arguments, ClipChoice.All);
        float? weight = ReadPositive(arguments, mass, "kilograms");
        float scale = ReadPositive(arguments, unit, "metres") ?? 1f;
        FileSet.RequireWritable(to, surroundings);
        SkinnedModel model = ModelFile.Read(from, surroundings);
        RiggedBody body = Body(model, weight, scale, from);
        var names = new HashSet<string>(model.Clips.Select(clip => clip.Name), StringComparer.Ordinal);
        Clip[] clips = choice == ClipChoice.None ? [] : [.. choice.Bake(new MotionProfile(body.Subject), surroundings.Cancellation).Select(clip => body.Bring(clip, Free(clip.Name, names)))];
        using var bytes = new MemoryStream();
        ModelWriter.Write(model, clips, bytes);
        FileSet.Write(to, stream => bytes.WriteTo(stream), surroundings);
        if (!arguments.Has(CommonOptions.Quiet.Name))
        {
            surroundings.Out.WriteLine(FormattableString.Invariant($"{to}  {clips.Length} clips added: {string.Join(", ", clips.Select(clip => clip.Name))}"));
        }

        return ExitCode.Done;
    }

    private static float? ReadPositive(ParsedArguments arguments, OptionSyntax option, string of) =>
        arguments.Value(option.Name) is not string text ? null
            : float.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out float number) && number > 0f && float.IsFinite(number) ? number
            : throw arguments.Wrong(option.Name, text, $"a positive number of {of}");

    private static RiggedBody Body(SkinnedModel model, float? weight, float scale, string from)
    {
        try
        {
            return new RiggedBody(model.Skeleton, mass: weight, unit: scale, skin: model.RestMesh());
        }
        catch (ArgumentException lack)
        {
            throw new UsageError($"cannot teach '{from}': {lack.Message}");
        }
    }

    /// <summary>The name, with a number behind it if the model has a clip of that name.</summary>
    private static string Free(string name, HashSet<string> taken)
    {
        string free = name;
        for (int number = 2; !taken.Add(free); number++)
        {
            free = FormattableString.Invariant($"{name}_{number}");
        }

        return free;
    }
}
