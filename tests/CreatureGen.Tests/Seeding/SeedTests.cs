using System;
using System.Collections.Generic;
using System.Text;
using CreatureGen.Seeding;
using CreatureGen.Tests.Motion;
using Xunit;

namespace CreatureGen.Tests.Seeding;

public sealed class SeedTests
{
    [Theory]
    [InlineData("", 0xCBF29CE484222325UL)]
    [InlineData("a", 0xAF63DC4C8601EC8CUL)]
    [InlineData("b", 0xAF63DF4C8601F1A5UL)]
    [InlineData("foo", 0xDCB27518FED9D577UL)]
    [InlineData("foobar", 0x85944171F73967E8UL)]
    public void Names_are_hashed_as_the_authors_of_FNV_publish(string text, ulong expected) => Assert.Equal(expected, Seed.Hash(text));

    [Theory]
    [InlineData("Flügel")]
    [InlineData("鱗")]
    [InlineData("🐙 tentacle")]
    [InlineData("\u07FF\u0800\uFFFF")]
    [InlineData("lone \uD83D half")]
    [InlineData("\uDC19")]
    [InlineData("end \uD83D")]
    public void Other_letters_are_hashed_as_their_UTF_8(string text)
    {
        ulong hash = 0xCBF29CE484222325UL;
        foreach (byte b in Encoding.UTF8.GetBytes(text))
        {
            hash = (hash ^ b) * 0x100000001B3UL;
        }

        Assert.Equal(hash, Seed.Hash(text));
    }

    [Theory]
    [InlineData(1234567UL, new[] { 6457827717110365317UL, 3203168211198807973UL, 9817491932198370423UL, 4593380528125082431UL, 16408922859458223821UL })]
    [InlineData(0UL, new[] { 0xE220A8397B1DCDAFUL, 0x6E789E6AA1B965F4UL, 0x06C45D188009454FUL, 0xF88BB8A8724C81ECUL })]
    public void The_mixer_gives_the_published_numbers_of_SplitMix64(ulong seed, ulong[] expected)
    {
        foreach (ulong number in expected)
        {
            seed += Seed.GoldenStep;
            Assert.Equal(number, Seed.Mix(seed));
        }
    }

    [Fact]
    public void Children_are_derived_as_documented()
    {
        ulong step = 0xD1B54A32D192ED03UL;
        ulong golden = 0x9E3779B97F4A7C15UL;
        Assert.Equal(Seed.Mix(42 + (0x85944171F73967E8UL * golden)), new Seed(42).Child("foobar").Value);
        Assert.Equal(Seed.Mix(42 ^ (8 * step)), new Seed(42).Child(7).Value);
        Assert.Equal(Seed.Mix(42 ^ (0x100000000UL * step)), new Seed(42).Child(-1).Value);
    }

    [Fact]
    public void Known_children_keep_their_values()
    {
        Assert.Equal("c8acc7b48dd9e276", new Seed(0).Child("limb").ToString());
        Assert.Equal("5ffc952d4cbdcd84", new Seed(2024).Child("limb").Child("hind").Child(3).ToString());
    }

    [Fact]
    public void A_child_depends_on_its_name_and_its_parent_alone()
    {
        var root = new Seed(42);
        Seed limb = root.Child("limb");
        root.Child("horn").Stream().NextUInt64();
        Assert.Equal(limb, root.Child("limb"));
        Assert.True(limb == root.Child("limb"));
        Assert.True(limb != root.Child("wing"));
        Assert.NotEqual(limb, new Seed(43).Child("limb"));
        Assert.NotEqual(root.Child("a").Child("b"), root.Child("ab"));
        Assert.NotEqual(root.Child("a").Child("b"), root.Child("b").Child("a"));
        Assert.Equal(limb.Stream().NextUInt64(), new Seed(42).Child("limb").Stream().NextUInt64());
    }

    [Fact]
    public void No_two_of_many_nodes_are_the_same()
    {
        var seen = new HashSet<ulong>();
        for (ulong root = 0; root < 200; root++)
        {
            var seed = new Seed(root);
            for (int i = -250; i < 250; i++)
            {
                Assert.True(seen.Add(seed.Child(i).Value));
                Assert.True(seen.Add(seed.Child("part" + i.ToString(System.Globalization.CultureInfo.InvariantCulture)).Value));
            }
        }
    }

    [Fact]
    public void Siblings_and_neighbouring_roots_are_unrelated()
    {
        Unrelated(i => new Seed(5).Child(i), i => new Seed(5).Child(i + 1));
        Unrelated(i => new Seed((ulong)i).Child("limb"), i => new Seed((ulong)i).Child("limc"));
        Unrelated(i => new Seed((ulong)i).Child("body"), i => new Seed((ulong)i + 1).Child("body"));
        Unrelated(i => new Seed((ulong)i), i => new Seed((ulong)i + 1));
        Unrelated(i => new Seed((ulong)i), i => new Seed((ulong)i).Child(0));
        Unrelated(i => new Seed(1UL << (i % 64)).Child(i / 64), i => new Seed(1UL << ((i + 1) % 64)).Child(i / 64));
    }

    [Fact]
    public void Every_bit_of_a_parent_and_of_a_name_turns_half_of_the_childs_bits()
    {
        for (int bit = 0; bit < 64; bit++)
        {
            int byParent = 0;
            int byNumber = 0;
            for (ulong i = 0; i < 500; i++)
            {
                ulong parent = i * 0x123456789UL;
                byParent += System.Numerics.BitOperations.PopCount(new Seed(parent).Child("tail").Value ^ new Seed(parent ^ (1UL << bit)).Child("tail").Value);
                byNumber += System.Numerics.BitOperations.PopCount(new Seed(parent).Child((int)i).Value ^ new Seed(parent).Child((int)i ^ (1 << (bit & 31))).Value);
            }

            // Mean 16 000 of 32 000 flips, deviation 89; 5 deviations.
            Assert.InRange(byParent, 15_555, 16_445);
            Assert.InRange(byNumber, 15_555, 16_445);
        }
    }

    [Fact]
    public void Finding_a_child_allocates_nothing()
    {
        var seed = new Seed(1);
        string other = "Flügel🐙";
        int number = 0;
        Assert.Equal(0, MovingPose.Allocated(() => seed = seed.Child("limb").Child(other).Child(number++), 100));
    }

    [Fact]
    public void A_missing_name_is_refused() => Assert.Throws<ArgumentNullException>(() => new Seed(1).Child(null!));

    /// <summary>The correlation of the first uniform numbers of 20 000 pairs of nodes is within 4.5 of its deviations of nothing.</summary>
    private static void Unrelated(Func<int, Seed> one, Func<int, Seed> other)
    {
        const int Count = 20_000;
        double sum = 0;
        for (int i = 0; i < Count; i++)
        {
            sum += (one(i).Stream().Uniform() - 0.5) * (other(i).Stream().Uniform() - 0.5);
        }

        Assert.InRange(sum * 12 / Math.Sqrt(Count), -4.5, 4.5);
    }
}
