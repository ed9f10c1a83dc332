using System;
using System.IO;
using CreatureGen.Blueprints;
using CreatureGen.Png;

namespace CreatureGen.Pictures;

/// <summary>Pictures that hold the creature they show: a PNG file with its blueprint as text, of keyword <c>creaturegen</c>. Programs that know nothing of it show the picture.</summary>
public static class BlueprintPicture
{
    private const string Keyword = "creaturegen";

    /// <summary>Copies a picture and puts a blueprint into it, in place of one that it may hold.</summary>
    /// <param name="picture">A PNG file, read from the stream's position to its end; is not closed.</param>
    /// <param name="blueprint">What it is to hold.</param>
    /// <param name="destination">Where to write; is not closed.</param>
    /// <exception cref="ArgumentNullException">Something is null.</exception>
    /// <exception cref="InvalidDataException">The picture is no whole PNG file. Part of it may have been written.</exception>
    public static void Write(Stream picture, CreatureBlueprint blueprint, Stream destination)
    {
        _ = picture ?? throw new ArgumentNullException(nameof(picture));
        _ = destination ?? throw new ArgumentNullException(nameof(destination));
        if (!PngText.Insert(picture, Keyword, BlueprintJson.Write(blueprint), destination))
        {
            throw new InvalidDataException("the picture is cut off or damaged; expected a whole PNG file");
        }
    }

    /// <summary>Reads the blueprint that a picture holds and validates it. Whatever the bytes are, the answer is a blueprint or a report.</summary>
    /// <param name="picture">A PNG file, read from the stream's position; is not closed.</param>
    /// <exception cref="ArgumentNullException">The stream is null.</exception>
    public static BlueprintReading Read(Stream picture)
    {
        string? text = PngText.Find(picture ?? throw new ArgumentNullException(nameof(picture)), Keyword, 2 * BlueprintJson.MaximumBytes);
        return text != null ? BlueprintJson.Read(text) : new BlueprintReading(null, [new Problem("picture", "no blueprint", "a PNG file in which CreatureGen put one")]);
    }
}
