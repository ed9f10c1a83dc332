using System;
using System.IO;
using System.Runtime.InteropServices;
using System.Runtime.InteropServices.JavaScript;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Genetics;
using CreatureGen.Gltf;
using CreatureGen.Repairs;
using CreatureGen.Sampling;

namespace CreatureGen.Lab.Runtime;

/// <summary>What the page can call. Each method throws with a message for people; the worker passes it on.</summary>
internal static partial class Exports
{
    private static readonly Stage stage = new();

    private static void Main()
    {
        // A page calls the methods below; there is nothing else to run.
    }

    /// <summary>What a seed would be, without building it: for filters.</summary>
    [JSExport]
    internal static string Glance(string seed, string kind, double strangeness) => Facts.AtAGlance(DesignText.Sample(seed, kind, strangeness));

    /// <summary>The file of a seed, as the library makes and writes it by default.</summary>
    [JSExport]
    internal static byte[] GlbOfSeed(string seed, string kind)
    {
        using var file = new MemoryStream();
        GlbWriter.Write(CreatureGenerator.Build(DesignText.Sample(seed, kind, CreatureOptions.Default.Strangeness)), GltfOptions.Default, file);
        return file.ToArray();
    }

    /// <summary>The sliders.</summary>
    [JSExport]
    internal static string Sliders() => Facts.OfTraits();

    /// <summary>Lays the ground: heights as 32-bit floats, row by row along +Z.</summary>
    [JSExport]
    internal static void Ground(byte[] heights, int columns, double cell, double corner) => stage.Lay(MemoryMarshal.Cast<byte, float>(heights), columns, (float)cell, (float)corner);

    /// <summary>Grows a creature of a seed with changed traits, and lets it live in a slot; the one that lived there leaves its place to it. What cannot be built is repaired, and the answer tells each change.</summary>
    [JSExport]
    internal static string Grow(int slot, string seed, string kind, double strangeness, string traits) =>
        Settle(slot, TraitText.Apply(DesignText.Sample(seed, kind, strangeness), traits));

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

    [JSExport]
    internal static string Blueprint(int slot) => BlueprintJson.Write(stage[slot].Design);

    [JSExport]
    internal static byte[] Glb(int slot, string what)
    {
        using var file = new MemoryStream();
        GlbWriter.Write(CreatureGenerator.Build(stage[slot].Design), DesignText.Files(what, stage[slot]), file);
        return file.ToArray();
    }

    /// <summary>The text of the blueprint that a file holds: a blueprint, a GLB, or a picture in which one was put.</summary>
    [JSExport]
    internal static string Open(byte[] file) => BlueprintJson.Write(CreatureFile.Read(file));

    /// <summary>A picture with the blueprint put into it.</summary>
    [JSExport]
    internal static byte[] Sign(byte[] picture, int slot) => CreatureFile.Sign(picture, stage[slot].Design);

    /// <summary>The blueprint as letters for an address.</summary>
    [JSExport]
    internal static string Address(int slot) => AddressText.Write(stage[slot].Design);

    [JSExport]
    internal static string FromAddress(string address) => BlueprintJson.Write(AddressText.Read(address));

    [JSExport]
    internal static void Place(int slot, double x, double y, double z, double yaw) => stage[slot].Place((float)x, (float)y, (float)z, (float)yaw, stage.Land);

    [JSExport]
    internal static void Go(int slot, double x, double z) => stage[slot].Mind.GoTo((float)x, (float)z);

    [JSExport]
    internal static void Look(int slot, double x, double y, double z) => stage[slot].LookAt((float)x, (float)y, (float)z);

    [JSExport]
    internal static void Push(int slot, double x, double z) => stage[slot].Mind.Push((float)x, (float)z);

    /// <summary>What it does by itself: <c>stay</c> or <c>wander</c>.</summary>
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
