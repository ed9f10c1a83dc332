using System;
using System.IO;
using System.Linq;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Console.Text;
using CreatureGen.Console.Working;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Preview.Films;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Png;
using CreatureGen.Preview.Rendering;
using CreatureGen.Sampling;

namespace CreatureGen.Console.Verbs;

/// <summary>Makes a moving picture and a film strip of a creature.</summary>
internal sealed class AnimateVerb : IVerb
{
    private const int DefaultSize = 640;
    private const int LeastSize = 64;
    private const int MostSize = 2048;

    private static readonly OptionSyntax ground = new("--ground", "GROUND", "flat (the default) or rough: seeded hills");
    private static readonly OptionSyntax size = new("--size", "PIXELS", "width of the moving picture, 64 to 2048 (default 640)");

    /// <inheritdoc/>
    public VerbSyntax Syntax { get; } = new(
        "animate",
        null,
        "write one cycle of a creature's motion as an animated PNG that loops, and as a film strip",
        [
            new("animate --seed 42 --gait trot --speed 1.5 --ground rough --out walk.png", "walk.png moves; walk-strip.png shows 8 frames, contacts and the gait"),
            new("animate --seed 7 --kind flying --out fly.png", "a flier's wing beat"),
            new("animate --seed 7 --kind flying --gait land --out land.png", "how it comes down and folds its wings"),
            new("animate --seed 4 --kind swimming --gait c-start --out dart.png", "a startled fish"),
            new("animate --seed 42 --out slow.png --speed 0.5 --view side --size 400", "the gait that suits the speed, from the side"),
        ],
        [SeedOptions.Seed, MovementArguments.Gait, MovementArguments.Speed, ground, CommonOptions.OutFile with { Meaning = "the animated PNG to write; the film strip gets -strip in its name" }, CommonOptions.View, size, CommonOptions.Flat, .. CreatureArguments.Syntax, CommonOptions.Threads]);

    /// <inheritdoc/>
    public int Run(ParsedArguments arguments, Surroundings surroundings)
    {
        string path = surroundings.Locate(arguments.Required(CommonOptions.OutFile.Name));
        if (path == Surroundings.Standard)
        {
            throw arguments.Wrong(CommonOptions.OutFile.Name, path, "a file, for the film strip is written beside it");
        }

        string stripPath = Path.Combine(Path.GetDirectoryName(path) ?? "", Path.GetFileNameWithoutExtension(path) + "-strip" + Path.GetExtension(path));
        ulong seed = SeedOptions.ReadOne(arguments);
        CreatureOptions options = CreatureArguments.Read(arguments, surroundings);
        int threads = CommonOptions.ReadThreads(arguments);
        int width = arguments.Whole(size.Name, LeastSize, MostSize, DefaultSize);
        MovementArguments.ReadSpeed(arguments);
        var filmOptions = new FilmOptions
        {
            Width = width,
            Height = width * 3 / 4,
            View = CommonOptions.ReadView(arguments),
            Ground = arguments.Choice(ground.Name, WordList<GroundRelief>.Instance, GroundRelief.Flat),
            Shading = arguments.Has(CommonOptions.Flat.Name) ? ShadingMode.Faceted : ShadingMode.Smooth,
            Threads = threads,
        };
        var profile = new MotionProfile(CreatureAssembler.Assemble(Growing.Sample(seed, options)));
        Movement movement = MovementArguments.Read(arguments, profile);
        FileSet.RequireWritable(path, surroundings);
        FileSet.RequireWritable(stripPath, surroundings);
        surroundings.Cancellation.ThrowIfCancellationRequested();
        var film = new Film(profile, movement, filmOptions);
        using var files = new FileSet(surroundings);
        long bytes = 0;
        using (var progress = new ProgressLine(surroundings, "frames", (UInt128)film.FrameCount, ProgressKind.Shown))
        {
            files.Stage(path, stream =>
            {
                var writer = new AnimatedPngWriter(stream, film.FrameCount, film.MillisecondsPerFrame);
                OrderedWork<int, Picture>.Run(Enumerable.Range(0, film.FrameCount), threads, film.Frame, frame =>
                {
                    writer.Add(frame);
                    progress.Step();
                }, surroundings.Cancellation);
                bytes = stream.Length;
            });
        }

        Picture strip = film.Strip(surroundings.Cancellation);
        byte[] png = PngWriter.ToBytes(strip);
        files.Stage(stripPath, stream => stream.Write(png));
        files.Commit();
        string pace = film.Slowness > 1.05f ? FormattableString.Invariant($", {film.Slowness:0.0} times slower than life") : "";
        surroundings.Out.WriteLine(FormattableString.Invariant(
            $"{path}: {SeedText.Of(seed)} {movement.GaitName} at {film.Speed:0.00} m/s, cycle of {film.CycleSeconds:0.00} s, {film.FrameCount} frames{pace}, {width} x {filmOptions.Height} pixels, {Units.Bytes(bytes)}"));
        surroundings.Out.WriteLine(FormattableString.Invariant($"{stripPath}: film strip, {strip.Width} x {strip.Height} pixels, {Units.Bytes(png.Length)}"));
        return ExitCode.Done;
    }
}
