using System;
using System.IO;
using System.Numerics;
using System.Runtime.InteropServices;
using System.Runtime.InteropServices.JavaScript;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Genetics;
using CreatureGen.Gltf;
using CreatureGen.Motion;
using CreatureGen.Repairs;
using CreatureGen.Sampling;

namespace CreatureGen.Lab.Runtime;

/// <summary>What the page can call. Each method throws with a message for people; the worker passes it on.</summary>
internal static partial class Exports
{
    private static readonly Stage stage = new();
    private static Evolving? evolving;
    private static Sketch? sketch;

    private static void Main()
    {
        // A page calls the methods below; there is nothing else to run.
    }

    /// <summary>What a seed would be, without building it: for filters.</summary>
    [JSExport]
    internal static string Glance(string seed, string kind, double strangeness, string individual) => Facts.AtAGlance(DesignText.Sample(seed, kind, strangeness, individual));

    /// <summary>The file of a seed, as the library makes and writes it by default.</summary>
    [JSExport]
    internal static byte[] GlbOfSeed(string seed, string kind)
    {
        using var file = new MemoryStream();
        GlbWriter.Write(CreatureAssembler.Assemble(DesignText.Sample(seed, kind, CreatureOptions.Default.Strangeness, "")), GltfOptions.Default, file);
        return file.ToArray();
    }

    /// <summary>How strange creatures are if nobody says otherwise.</summary>
    [JSExport]
    internal static double UsualStrangeness() => CreatureOptions.Default.Strangeness;

    /// <summary>The sliders.</summary>
    [JSExport]
    internal static string Sliders() => Facts.OfTraits();

    /// <summary>The palette of parts.</summary>
    [JSExport]
    internal static string Palette() => Facts.OfParts();

    /// <summary>Lays the ground: heights as 32-bit floats, row by row along +Z; and the height of the water's surface, infinite in the sea.</summary>
    [JSExport]
    internal static void Ground(byte[] heights, int columns, double cell, double corner, double surface) =>
        stage.Lay(MemoryMarshal.Cast<byte, float>(heights), columns, (float)cell, (float)corner, (float)surface);

    /// <summary>Draws up what <see cref="Grow"/> is about to build. A browser goes over to faster code of the interpreter from one call to the next, never within one: the first creature comes sooner in two calls.</summary>
    [JSExport]
    internal static void Prepare(string seed, string kind, double strangeness, string individual) => sketch = new Sketch(seed, kind, strangeness, individual);

    /// <summary>Grows a creature of a seed with changed traits, and lets it live in a slot; the one that lived there leaves its place to it. What cannot be built is repaired, and the answer tells each change.</summary>
    [JSExport]
    internal static string Grow(int slot, string seed, string kind, double strangeness, string individual, string traits) =>
        Settle(slot, TraitText.Apply(sketch?.Of(seed, kind, strangeness, individual) ?? DesignText.Sample(seed, kind, strangeness, individual), traits));

    /// <summary>The same for a blueprint's text.</summary>
    [JSExport]
    internal static string GrowText(int slot, string blueprint, string traits) => Settle(slot, TraitText.Apply(DesignText.Read(blueprint), traits));

    /// <summary>A child of two creatures, given as blueprints; settled just born or grown.</summary>
    [JSExport]
    internal static string GrowChild(int slot, string first, string second, string seed, double mutation, double age)
    {
        CreatureBlueprint child = ShortNumbers.Of(Breeding.Child(DesignText.Read(first), DesignText.Read(second), DesignText.Seed(seed), BreedingSettings.Default with { Mutation = mutation }).Blueprint);
        RepairReport report = Ageing.At(child, age);
        stage.Settle(slot, report.Creature, child);
        return Facts.Of(slot, stage[slot], report.Changes, report.Violations);
    }

    /// <summary>Makes the creature of a slot sound by building and inspecting it, and settles what comes of it.</summary>
    [JSExport]
    internal static string Mend(int slot)
    {
        RepairReport report = BlueprintRepair.Repair(stage[slot].Design);
        if (report.Changes.Count > 0)
        {
            stage.Settle(slot, report.Creature, report.Blueprint);
        }

        return Facts.Of(slot, stage[slot], report.Changes, report.Violations);
    }

    [JSExport]
    internal static byte[] Mesh(int slot) => MeshBytes.Of(stage[slot].Creature, stage[slot].Creature.Mesh);

    [JSExport]
    internal static byte[] TexturedMesh(int slot) => MeshBytes.Of(stage[slot].Creature, stage[slot].Creature.Mesh.Textured());

    /// <summary>Base colour, then normals: two pictures of four bytes a texel, one after the other.</summary>
    [JSExport]
    internal static byte[] Textures(int slot, int size)
    {
        CreatureTextures textures = CreatureTextures.Bake(stage[slot].Creature, size);
        byte[] texels = new byte[2 * 4 * size * size];
        Widen(textures.BaseColour, texels);
        Widen(textures.Normal, texels.AsSpan(texels.Length / 2));
        return texels;
    }

    /// <summary>The creature's bones' capsules: joint, start, end, radius; eight floats each.</summary>
    [JSExport]
    internal static byte[] Capsules(int slot) => MeshBytes.Capsules(stage[slot].Creature);

    /// <summary>The part of the body that each joint belongs to.</summary>
    [JSExport]
    internal static string Parts(int slot) => BodyParts.Of(stage[slot].Creature);

    /// <summary>The indices of a coarser level of the mesh, 1 to 3, over the same vertices: how many are of the skin, then all, as 32-bit numbers.</summary>
    [JSExport]
    internal static byte[] Level(int slot, int level) => MeshBytes.Level(stage[slot].Creature.Mesh.Lods[level]);

    /// <summary>A blueprint with a part of another creature, found from a seed on; repaired, as the text of the blueprint.</summary>
    [JSExport]
    internal static string GivePart(string blueprint, string part, string seed) => Repaired(PartBox.Give(DesignText.Read(blueprint), PartBox.Find(part), DesignText.Seed(seed)));

    /// <summary>A blueprint without a part.</summary>
    [JSExport]
    internal static string TakePart(string blueprint, string part) => Repaired(PartBox.Find(part).Take(DesignText.Read(blueprint)));

    /// <summary>Begins to breed a population towards a goal; the second founder may be empty. The answer tells where it stands.</summary>
    [JSExport]
    internal static string Evolve(string first, string second, string towards, int population, double mutation, string seed)
    {
        CreatureBlueprint founder = DesignText.Read(first);
        evolving = new Evolving(second.Length > 0 ? [founder, DesignText.Read(second)] : [founder], towards, population, mutation, DesignText.Seed(seed));
        return evolving.State();
    }

    /// <summary>Breeds the next generation.</summary>
    [JSExport]
    internal static string EvolveOn()
    {
        Evolving population = evolving ?? throw new InvalidOperationException("nobody evolves");
        population.Next();
        return population.State();
    }

    /// <summary>The blueprint of the best so far.</summary>
    [JSExport]
    internal static string Fittest() => BlueprintJson.Write(evolving?.Best ?? throw new InvalidOperationException("nobody evolves"));

    [JSExport]
    internal static string Blueprint(int slot) => BlueprintJson.Write(stage[slot].Design);

    [JSExport]
    internal static byte[] Glb(int slot, string what)
    {
        using var file = new MemoryStream();
        GlbWriter.Write(CreatureAssembler.Assemble(stage[slot].Design), DesignText.Files(what, stage[slot]), file);
        return file.ToArray();
    }

    /// <summary>The text of the blueprint that a file holds: a blueprint, a GLB, or a picture in which one was put.</summary>
    [JSExport]
    internal static string Open(byte[] file) => BlueprintJson.Write(CreatureFile.Read(file));

    /// <summary>A picture with the blueprint put into it.</summary>
    [JSExport]
    internal static byte[] Sign(byte[] picture, int slot) => CreatureFile.Sign(picture, stage[slot].Design);

    /// <summary>The blueprint as letters for an address: where it is much like the creature of its own seed, how it differs.</summary>
    [JSExport]
    internal static string Address(int slot)
    {
        CreatureBlueprint design = stage[slot].Design;
        string whole = AddressText.Write(design, null);
        string seed = FormattableString.Invariant($"{design.Seed}.{design.Kind}").ToLowerInvariant();
        string difference = seed + "~" + AddressText.Write(design, OfSeed(seed));
        return difference.Length < whole.Length ? difference : whole;
    }

    /// <summary>The text of the blueprint of such letters.</summary>
    [JSExport]
    internal static string FromAddress(string address)
    {
        int end = address.IndexOf('~', StringComparison.Ordinal);
        return BlueprintJson.Write(end < 0 ? AddressText.Read(address, null) : AddressText.Read(address[(end + 1)..], OfSeed(address[..end])));
    }

    [JSExport]
    internal static void Place(int slot, double x, double y, double z, double yaw) => stage[slot].Place((float)x, (float)y, (float)z, (float)yaw, stage.Land);

    [JSExport]
    internal static void Go(int slot, double x, double z) => stage.Send(slot, (float)x, (float)z);

    [JSExport]
    internal static void Look(int slot, double x, double y, double z) => stage[slot].LookAt((float)x, (float)y, (float)z);

    /// <summary>Pushes it along the ground: 0.3 makes it stagger, 0.7 knocks most over.</summary>
    [JSExport]
    internal static void Push(int slot, int joint, double x, double z, double strength)
    {
        Actor actor = stage[slot];
        actor.Animator.Hit(joint >= 0 ? joint : actor.Chest, Deeds.Impulse(actor, (float)x, (float)z, (float)strength));
        actor.Mind.Feel(actor, new Emotion(0.9f, -0.6f, -0.4f), 3f);
    }

    /// <summary>Lets it go limp; it lies until it is told to get up.</summary>
    [JSExport]
    internal static void Faint(int slot) => stage[slot].Animator.GoLimp();

    [JSExport]
    internal static bool GetUp(int slot) => stage[slot].Animator.GetUp();

    /// <summary>Begins an act of the library. The answer is empty, or tells why not.</summary>
    [JSExport]
    internal static string Perform(int slot, string act) => stage[slot].Deeds.Perform(act, ActTarget.Usual);

    /// <summary>Leaves what lasts, as sitting.</summary>
    [JSExport]
    internal static void GoOn(int slot) => stage[slot].Animator.GoOn();

    /// <summary>Tries an act for some milliseconds, so that others live on meanwhile. Whether all of it is tried: it begins at once then, or is refused.</summary>
    [JSExport]
    internal static bool Rehearse(int slot, string act, double milliseconds) => stage[slot].Deeds.Try(act, milliseconds);

    /// <summary>Food lies there: it comes and eats.</summary>
    [JSExport]
    internal static void Feed(int slot, double x, double y, double z) => stage[slot].Mind.Feed((float)x, (float)y, (float)z);

    /// <summary>What it feels, for some seconds.</summary>
    [JSExport]
    internal static void Feel(int slot, double arousal, double valence, double boldness, double seconds) =>
        stage[slot].Mind.Feel(stage[slot], new Emotion((float)arousal, (float)valence, (float)boldness), (float)seconds);

    /// <summary>Jumps to a place, as far as it can. Whether it does.</summary>
    [JSExport]
    internal static bool Jump(int slot, double x, double z) => stage[slot].Animator.Jump(new Vector3((float)x, stage.Land.HeightAt((float)x, (float)z), (float)z)) == JumpResult.Begun;

    /// <summary>What it does by itself: <c>stay</c>, <c>wander</c>, or <c>march</c> straight on.</summary>
    [JSExport]
    internal static void Habit(int slot, string habit, double x, double z, double radius) => stage[slot].Mind.Take(habit, (float)x, (float)z, (float)radius);

    [JSExport]
    internal static void Remove(int slot) => stage.Remove(slot);

    /// <summary>Moves all on. The answer's length in floats; the numbers are at <see cref="FrameAddress"/> until the next call.</summary>
    [JSExport]
    internal static int Frame(double seconds, int eye) => stage.Frame((float)seconds, eye);

    [JSExport]
    internal static int FrameAddress() => stage.FrameAddress;

    [JSExport]
    internal static string Memory() => FormattableString.Invariant($"{GC.GetTotalMemory(true)}");

    /// <summary>Three bytes a texel become four, as graphics libraries want them.</summary>
    private static void Widen(ReadOnlySpan<byte> colours, Span<byte> texels)
    {
        for (int from = 0, to = 0; from < colours.Length; from += 3, to += 4)
        {
            texels[to] = colours[from];
            texels[to + 1] = colours[from + 1];
            texels[to + 2] = colours[from + 2];
            texels[to + 3] = 255;
        }
    }

    /// <summary>The creature of <c>31.walking</c>.</summary>
    private static CreatureBlueprint OfSeed(string name)
    {
        int point = name.IndexOf('.', StringComparison.Ordinal);
        return DesignText.Sample(name[..Math.Max(point, 0)], name[(point + 1)..], CreatureOptions.Default.Strangeness, "");
    }

    private static string Repaired(CreatureBlueprint design)
    {
        RepairReport report = BlueprintRepair.Repair(design);
        return Facts.OfRepair(report);
    }

    private static string Settle(int slot, CreatureBlueprint design)
    {
        RepairReport? report = null;
        if (BlueprintValidator.Validate(design).Count > 0)
        {
            report = BlueprintRepair.Repair(design);
            design = report.Blueprint;
        }

        stage.Settle(slot, report?.Creature ?? CreatureAssembler.Assemble(design), design);
        return Facts.Of(slot, stage[slot], report?.Changes ?? [], report?.Violations ?? []);
    }
}
