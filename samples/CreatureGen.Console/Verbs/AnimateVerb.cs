using System;
using System.IO;
using System.Linq;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Console.Text;
using CreatureGen.Console.Working;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Preview.Films;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Png;
using CreatureGen.Preview.Rendering;
using CreatureGen.Sampling;
using CreatureGen.Sounds;

namespace CreatureGen.Console.Verbs;

/// <summary>Makes a moving picture and a film strip of a creature.</summary>
internal sealed class AnimateVerb : IVerb
{
    private const int DefaultSize = 640;
    private const int MinSize = 64;
    private const int MaxSize = 2048;

    private static readonly OptionSyntax ground = new("--ground", "GROUND", "flat (the default) or rough: seeded hills; with --course also stairs, slope, gap, platform, lift, water, stones or pipe");
    private static readonly OptionSyntax course = new("--course", "SCRIPT", "what to do one after the other, such as 'idle 1; walk; run 2; turn left at 1.5; stop': a word, at a speed or rate, seconds");
    private static readonly OptionSyntax camera = new("--camera", "CHOICE", "with --course or --act: still (the default), it keeps its direction so that turns are seen, or along: it turns with the creature so that lean and bend are");
    private static readonly OptionSyntax sound = new("--sound", "FILE", "the WAV file to write as well: footsteps, landings, beats of wings, bites and calls, made by the weight of the creature");
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
            new("animate --seed 42 --act bite --out bite.png", "an attack; bite-strip.png shows its phases"),
            new("animate --seed 42 --speed 4 --out run.png --sound run.wav", "with the sound of its footsteps"),
            new("animate --seed 42 --course \"idle 1; walk; run; turn left; stop\" --ground stairs --out course.png", "starts, turns and stops; course-strip.png shows the transitions"),
        ],
        [SeedOptions.Seed with { Short = "-s" }, MovementArguments.Gait, MovementArguments.Speed, course, ActArguments.Act, ActArguments.Target, ground, camera, sound, CommonOptions.OutFile with { Meaning = "the animated PNG to write; the film strip gets -strip in its name" }, CommonOptions.View, size, CommonOptions.Flat, .. CreatureArguments.Syntax, CommonOptions.Threads, CommonOptions.Quiet]);

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
        int width = arguments.Whole(size.Name, MinSize, MaxSize, DefaultSize);
        MovementArguments.ReadSpeed(arguments);
        var filmOptions = new FilmOptions
        {
            Width = width,
            Height = width * 3 / 4,
            View = CommonOptions.ReadView(arguments),
            Camera = arguments.Choice(camera.Name, WordList<CameraTurn>.Instance, CameraTurn.Still),
            Shading = arguments.Has(CommonOptions.Flat.Name) ? ShadingMode.Faceted : ShadingMode.Smooth,
            Threads = threads,
        };
        Func<MotionProfile, (IFilm Film, string Title)> shoot = arguments.Has(course.Name) ? CourseShooter(arguments, filmOptions)
            : arguments.Has(ActArguments.Act.Name) ? ActShooter(arguments, filmOptions)
            : MovementShooter(arguments, filmOptions);
        var profile = new MotionProfile(CreatureAssembler.Assemble(Growing.Sample(seed, options)));
        FileSet.RequireWritable(path, surroundings);
        FileSet.RequireWritable(stripPath, surroundings);
        string? soundPath = arguments.Value(sound.Name) is string wav ? surroundings.Locate(wav) : null;
        if (soundPath == Surroundings.Standard || soundPath == path || soundPath == stripPath)
        {
            throw arguments.Wrong(sound.Name, soundPath, "a file beside the moving picture and its strip");
        }

        if (soundPath != null)
        {
            FileSet.RequireWritable(soundPath, surroundings);
        }

        surroundings.Cancellation.ThrowIfCancellationRequested();
        (IFilm film, string title) = shoot(profile);
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
        float seconds = film.FrameCount * film.MillisecondsPerFrame / 1000f;
        if (soundPath != null)
        {
            var settings = new SoundSettings(profile.Subject.Mass.Mass, seed);
            float[] samples = EventSounds.Render(film.Events, seconds, settings);
            files.Stage(soundPath, stream => WavWriter.Write(samples, settings.Rate, stream));
        }

        files.Commit();
        surroundings.Out.WriteLine(FormattableString.Invariant($"{path}: {SeedText.Of(seed)} {title}, {width} x {filmOptions.Height} pixels, {Units.Bytes(bytes)}"));
        surroundings.Out.WriteLine(FormattableString.Invariant($"{stripPath}: film strip, {strip.Width} x {strip.Height} pixels, {Units.Bytes(png.Length)}"));
        if (soundPath != null)
        {
            surroundings.Out.WriteLine(FormattableString.Invariant($"{soundPath}: {film.Events.Count} events in {seconds:0.0} s"));
        }

        return ExitCode.Done;
    }

    private static Func<MotionProfile, (IFilm Film, string Title)> MovementShooter(ParsedArguments arguments, FilmOptions options)
    {
        GroundRelief relief = arguments.Choice(ground.Name, WordList<GroundRelief>.Instance, GroundRelief.Flat);
        return profile =>
        {
            Movement movement = MovementArguments.Read(arguments, profile);
            var film = new Film(profile, movement, options with { Ground = relief });
            string pace = film.Slowness > 1.05f ? FormattableString.Invariant($", {film.Slowness:0.0} times slower than life") : "";
            return (film, FormattableString.Invariant($"{movement.GaitName} at {film.Speed:0.00} m/s, cycle of {film.CycleSeconds:0.00} s, {film.FrameCount} frames{pace}"));
        };
    }

    private static Func<MotionProfile, (IFilm Film, string Title)> ActShooter(ParsedArguments arguments, FilmOptions options)
    {
        RefuseBeside(arguments, ActArguments.Act.Name, MovementArguments.Gait.Name, MovementArguments.Speed.Name);
        CourseGround over = arguments.Choice(ground.Name, WordList<CourseGround>.Instance, CourseGround.Flat);
        ActTarget target = ActArguments.ReadTarget(arguments);
        string word = arguments.Required(ActArguments.Act.Name);
        return profile =>
        {
            ActAbility ability = ActArguments.Find(profile, word, expected => arguments.Wrong(ActArguments.Act.Name, word, expected));
            ActStart start = new CreatureAnimator(profile).Perform(ability, target);
            if (start.Reason is string reason)
            {
                throw arguments.Wrong(ActArguments.Target.Name, arguments.Value(ActArguments.Target.Name) ?? "", "a target within reach; " + reason);
            }

            var film = new CourseFilm(profile, ActScript.Of(ability, target), over, options);
            string contact = ability.SecondsToContact is float seconds ? FormattableString.Invariant($", contact after {seconds:0.00} s") : "";
            return (film, FormattableString.Invariant($"{ability.Act.Name} in {ability.Seconds:0.00} s{contact}, {film.FrameCount} frames"));
        };
    }

    private static void RefuseBeside(ParsedArguments arguments, string option, params string[] others)
    {
        foreach (string other in others)
        {
            if (arguments.Has(other))
            {
                throw arguments.Wrong($"{option} and {other}; expected one of them");
            }
        }
    }

    private static Func<MotionProfile, (IFilm Film, string Title)> CourseShooter(ParsedArguments arguments, FilmOptions options)
    {
        RefuseBeside(arguments, course.Name, MovementArguments.Gait.Name, MovementArguments.Speed.Name, ActArguments.Act.Name);

        CourseGround over = arguments.Choice(ground.Name, WordList<CourseGround>.Instance, CourseGround.Flat);
        return profile =>
        {
            try
            {
                CourseScript script = CourseReader.Read(arguments.Required(course.Name), profile);
                var film = new CourseFilm(profile, script, over, options);
                return (film, FormattableString.Invariant($"{script.Commands.Count} commands in {script.Seconds:0.0} s, {film.FrameCount} frames"));
            }
            catch (FormatException problem)
            {
                throw arguments.Wrong(course.Name + ": " + problem.Message);
            }
        };
    }
}
