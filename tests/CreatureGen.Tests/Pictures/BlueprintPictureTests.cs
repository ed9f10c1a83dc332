using System;
using System.IO;
using System.Linq;
using CreatureGen.Blueprints;
using CreatureGen.Pictures;
using CreatureGen.Png;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Pictures;

public sealed class BlueprintPictureTests
{
    private static readonly CreatureBlueprint blueprint = BlueprintSampler.Sample(7);

    [Fact]
    public void A_picture_gives_back_the_blueprint_that_was_put_into_it()
    {
        BlueprintReading reading = BlueprintPicture.Read(new MemoryStream(Signed(Picture(), blueprint)));

        Assert.Empty(reading.Problems);
        Assert.Equal(blueprint, reading.Blueprint);
    }

    [Fact]
    public void A_picture_holds_the_last_blueprint_that_was_put_into_it_and_no_other()
    {
        CreatureBlueprint other = BlueprintSampler.Sample(8);

        byte[] signed = Signed(Signed(Picture(), blueprint), other);

        Assert.Equal(Signed(Picture(), other), signed);
        Assert.Equal(other, BlueprintPicture.Read(new MemoryStream(signed)).Blueprint);
    }

    [Fact]
    public void All_other_chunks_of_a_picture_stay_as_they_are()
    {
        byte[] picture = Picture();
        byte[] signed = Signed(picture, blueprint);
        int data = picture.AsSpan().IndexOf("IDAT"u8) - 4;

        Assert.Equal(picture[..data], signed[..data]);
        Assert.Equal(picture[data..], signed[^(picture.Length - data)..]);
    }

    [Fact]
    public void A_picture_without_a_blueprint_is_told()
    {
        BlueprintReading reading = BlueprintPicture.Read(new MemoryStream(Picture()));

        Assert.Null(reading.Blueprint);
        Assert.Equal("a PNG file in which CreatureGen put one", Assert.Single(reading.Problems).Expectation);
    }

    [Fact]
    public void A_picture_that_is_cut_off_anywhere_holds_no_blueprint_and_takes_none()
    {
        byte[] signed = Signed(Picture(), blueprint);
        int text = signed.AsSpan().IndexOf("iTXt"u8) - 4;
        int length = signed.AsSpan().IndexOf("IDAT"u8) - 4 - text;
        foreach (int end in Enumerable.Range(0, 60).Append(text + (length / 2)).Append(text + length - 1))
        {
            Assert.Null(BlueprintPicture.Read(new MemoryStream(signed[..end])).Blueprint);
            Assert.Throws<InvalidDataException>(() => BlueprintPicture.Write(new MemoryStream(signed[..end]), blueprint, Stream.Null));
        }
    }

    [Fact]
    public void Text_that_was_changed_on_its_way_is_not_believed()
    {
        byte[] signed = Signed(Picture(), blueprint);
        signed[signed.AsSpan().IndexOf("iTXt"u8) + 200] ^= 1;

        Assert.Null(BlueprintPicture.Read(new MemoryStream(signed)).Blueprint);
    }

    [Fact]
    public void A_length_that_lies_reserves_no_memory()
    {
        byte[] signed = Signed(Picture(), blueprint);
        int text = signed.AsSpan().IndexOf("iTXt"u8) - 4;
        new byte[] { 0x7F, 0xFF, 0xFF, 0xFF }.CopyTo(signed, text);
        long before = GC.GetAllocatedBytesForCurrentThread();

        Assert.Throws<InvalidDataException>(() => BlueprintPicture.Write(new MemoryStream(signed), blueprint, Stream.Null));

        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 4_000_000);
    }

    private static byte[] Picture()
    {
        using var picture = new MemoryStream();
        PngEncoder.Write(Enumerable.Range(0, 3 * 5 * 4).Select(i => (byte)i).ToArray(), 5, 4, PngPixels.Rgb, picture);
        return picture.ToArray();
    }

    private static byte[] Signed(byte[] picture, CreatureBlueprint blueprint)
    {
        using var signed = new MemoryStream();
        BlueprintPicture.Write(new MemoryStream(picture), blueprint, signed);
        return signed.ToArray();
    }
}
