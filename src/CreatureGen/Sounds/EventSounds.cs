using System;
using System.Collections.Generic;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Seeding;

namespace CreatureGen.Sounds;

/// <summary>Events of a motion as sound, so that its timing can be heard: footsteps, landings, beats of wings, whooshes, bites, splashes and calls, made of noise and damped tones. The same events and settings give the same samples.</summary>
/// <remarks>Pitches fall with the cube root of mass, as lengths of bodies grow. Based on: P. R. Cook, "Real sound synthesis for interactive applications" (2002), chapters 4 and 12.</remarks>
public static class EventSounds
{
    /// <summary>Kilograms at which pitches are as they are written here.</summary>
    private const double UsualMass = 30;

    /// <summary>Seconds after the last event for it to die away.</summary>
    private const float Tail = 1f;

    /// <summary>Level that the loudest sample is brought down to.</summary>
    private const float Loudest = 0.9f;

    /// <summary>Makes the sound of events.</summary>
    /// <param name="events">With the names of baked clips and of rules: <c>footstep</c>, <c>land</c>, <c>flap</c>, <c>whoosh</c>, <c>bite</c>, <c>splash</c>, <c>call</c>, <c>stuff</c>; <c>liftoff</c> and others are silent.</param>
    /// <param name="seconds">Length of the motion, 0 to 600; the sound lasts a second longer.</param>
    /// <param name="settings">Whose.</param>
    /// <returns>One channel, −1..1.</returns>
    /// <exception cref="ArgumentNullException">There is no list.</exception>
    /// <exception cref="ArgumentException">The length is not finite or out of its range, an event is null or after the end, or the settings were not made by their constructor.</exception>
    public static float[] Render(IReadOnlyList<ClipEvent> events, float seconds, in SoundSettings settings)
    {
        _ = events ?? throw new ArgumentNullException(nameof(events));
        Finite.RequireWithin(seconds, 0f, 600f, nameof(seconds));
        if (settings.Rate == 0)
        {
            throw new ArgumentException("settings without a rate; expected settings made by their constructor", nameof(settings));
        }

        float[] samples = new float[(int)Math.Ceiling((seconds + Tail) * settings.Rate)];
        double size = PortableMath.Cbrt(settings.Mass / UsualMass);
        Seed seed = new Seed(settings.Seed).Child("sounds");
        for (int i = 0; i < events.Count; i++)
        {
            ClipEvent one = events[i] ?? throw new ArgumentException(FormattableString.Invariant($"event {i} is null; expected an event"), nameof(events));
            if (one.Time > seconds + Tail)
            {
                throw new ArgumentException(FormattableString.Invariant($"event {one.Name} at {one.Time} s; expected 0 to {seconds + Tail}"), nameof(events));
            }

            var voice = new Voice(samples.AsSpan((int)(one.Time * settings.Rate)), settings.Rate, seed.Child(i).Stream());
            Play(one, size, voice);
        }

        Level(samples);
        return samples;
    }

    private static void Play(ClipEvent one, double size, Voice voice)
    {
        double strength = Math.Min(Math.Sqrt(one.Strength), 2);
        double level = strength * Scalar.Clamp(Math.Sqrt(size), 0.2, 2);
        switch (one.Name)
        {
            case "footstep":
                // The thud of the ground under a weight, and the scuff of the sole.
                voice.Tone(0.5 * level, 95 / size, 60 / size, 0.002, 0.05 * Math.Sqrt(size));
                voice.Noise(0.25 * level, 900 / Math.Sqrt(size), 0.001, 0.03 * Math.Sqrt(size));
                break;
            case "land":
                voice.Tone(0.9 * level, 70 / size, 38 / size, 0.003, 0.13 * Math.Sqrt(size));
                voice.Noise(0.45 * level, 500 / Math.Sqrt(size), 0.002, 0.09 * Math.Sqrt(size));
                break;
            case "flap":
                voice.Noise(0.4 * level, 420 / size, 0.035 * Math.Sqrt(size), 0.07 * Math.Sqrt(size));
                break;
            case "whoosh":
                voice.Noise(0.3 * strength, 1300 / Math.Sqrt(size), 0.08, 0.12);
                break;
            case "bite":
                voice.Noise(0.7 * strength, 2600, 0.0005, 0.012);
                voice.Tone(0.4 * strength, 620 / Math.Sqrt(size), 380 / Math.Sqrt(size), 0.001, 0.03);
                break;
            case "splash":
                voice.Noise(0.6 * level, 1700, 0.006, 0.22);
                voice.Tone(0.15 * level, 380 / size, 900 / size, 0.02, 0.08);
                break;
            case "call":
                Call(size, strength, voice);
                break;
            case "stuff":
                voice.Noise(0.12 * strength, 3200, 0.02, 0.05);
                break;
            default:
                break;
        }
    }

    /// <summary>A voice: a tone that rises and falls, with overtones that weaken, and some breath.</summary>
    private static void Call(double size, double strength, Voice voice)
    {
        double pitch = 260 / size;
        for (int overtone = 1; overtone <= 5; overtone++)
        {
            voice.Tone(0.5 * strength / (overtone * overtone), 1.15 * pitch * overtone, 0.85 * pitch * overtone, 0.12, 0.3);
        }

        voice.Noise(0.08 * strength, 3 * pitch, 0.1, 0.3);
    }

    /// <summary>Brings the whole down where its loudest sample is beyond what a file holds.</summary>
    private static void Level(float[] samples)
    {
        float max = 0f;
        foreach (float sample in samples)
        {
            max = Math.Max(max, Math.Abs(sample));
        }

        if (max > Loudest)
        {
            for (int i = 0; i < samples.Length; i++)
            {
                samples[i] *= Loudest / max;
            }
        }
    }
}
