using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Working;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Console.Verbs;

/// <summary>The options that say which pictures are taken of creatures.</summary>
internal static class PictureOptions
{
    private const int MinSide = 16;
    private const int MaxSide = 4096;
    private const int MaxViews = 64;
    private const int DatasetSide = 256;

    /// <summary>Pixels of a picture.</summary>
    public static readonly OptionSyntax Size = new("--picture-size", "WxH", "pixels of a picture, 16x16 to 4096x4096 (default 1024x768)");

    private static readonly OptionSyntax none = new("--no-picture", null, "write no PNG");
    private static readonly OptionSyntax views = new("--views", "LIST", "a picture from each: three-quarter (the default), side, front, back, top, or all") { Words = [.. Array.ConvertAll(Enum.GetValues<View>(), Views.Word), "all"] };
    private static readonly OptionSyntax transparent = new("--transparent", null, "pictures with nothing behind the creature");

    private static readonly OptionSyntax dataset = new("--dataset", "VIEWS", "what training needs, from 1 to 64 sides: pictures of --picture-size (default 256x256), distances, normals and parts of their pixels, joints, poses; with a manifest");

    /// <summary>All of them.</summary>
    public static OptionSyntax[] Syntax { get; } = [none, Size, views, transparent, dataset];

    /// <summary>Whether a data set is wanted.</summary>
    public static bool WantsDataset(ParsedArguments arguments) => arguments.Has(dataset.Name);

    /// <summary>Which data set is wanted, if any.</summary>
    /// <exception cref="UsageError">A value is out of its range.</exception>
    public static DatasetOrder ReadDataset(ParsedArguments arguments)
    {
        int count = arguments.Whole(dataset.Name, 1, MaxViews, 0);
        (int width, int height) = ReadSize(arguments, (DatasetSide, DatasetSide));
        return count == 0 ? DatasetOrder.None : new DatasetOrder(count, width, height);
    }

    /// <summary>What was asked for.</summary>
    /// <exception cref="UsageError">A value is none of the known ones, or there is to be no picture of that size.</exception>
    public static PictureOrder Read(ParsedArguments arguments)
    {
        if (arguments.Has(none.Name))
        {
            OptionSyntax? other = new[] { Size, views, transparent }.FirstOrDefault(option => !arguments.Has(dataset.Name) && arguments.Has(option.Name));
            return other is null ? PictureOrder.None : throw arguments.Wrong($"{none.Name} and {other.Name}; expected one of them");
        }

        (int width, int height) = ReadSize(arguments, (PictureOrder.Portrait.Width, PictureOrder.Portrait.Height));
        return new PictureOrder(
            arguments.Value(views.Name) is string list ? ViewsOf(arguments, list) : PictureOrder.Portrait.Views,
            width,
            height,
            arguments.Has(transparent.Name) ? BackdropKind.Transparent : BackdropKind.Studio);
    }

    /// <summary>Pixels of a picture.</summary>
    /// <exception cref="UsageError">There is to be no picture of that size.</exception>
    public static (int Width, int Height) ReadSize(ParsedArguments arguments, (int Width, int Height) otherwise) => arguments.Value(Size.Name) is string text ? SizeOf(arguments, text) : otherwise;

    private static (int Width, int Height) SizeOf(ParsedArguments arguments, string text)
    {
        string[] sides = text.Split('x', 3);
        return sides.Length == 2 && Side(sides[0]) is int width && Side(sides[1]) is int height
            ? (width, height)
            : throw arguments.Wrong(Size.Name, text, FormattableString.Invariant($"width x height, each {MinSide}..{MaxSide}, such as 512x512"));
    }

    private static int? Side(string text) => int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int side) && side is >= MinSide and <= MaxSide ? side : null;

    private static View[] ViewsOf(ParsedArguments arguments, string list)
    {
        View[] all = Enum.GetValues<View>();
        if (list == "all")
        {
            return all;
        }

        string[] known = Array.ConvertAll(all, Views.Word);
        var found = new List<View>();
        foreach (string word in list.Split(',').Select(word => word.Trim()))
        {
            View view = Views.TryParse(word, out View read) ? read : throw arguments.Wrong(views.Name, word, $"all, or of {string.Join(", ", known)}{Suggestion.For(word, known)}");
            if (found.Contains(view))
            {
                throw arguments.Wrong(views.Name, list, word + " once");
            }

            found.Add(view);
        }

        return found.ToArray();
    }
}
