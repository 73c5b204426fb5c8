using System;
using System.Collections.Generic;
using System.Text;

namespace FastPoints.Tests
{
    static class Damage
    {
        static readonly string[] s_words =
        {
            "0", "-1", "4", "99999999999999999999", "18446744073709551615", "4294967296", "nan", "inf", "1e308", "1e-400",
            "x", "z", ",", ";", "\t", "\r", "\n", " ", "\"", "#", ".", "-", "{", "}", "[", "]", "<", ">", "vertex", "property",
            "element", "",
        };

        /// <param name="place">Where a change is, of so many bytes; null for half of them near the start, where most of what says
        /// what the rest is lies.</param>
        /// <param name="words">What stands in texts of the format; null for what stands in most.</param>
        public static byte[] Of(byte[] sound, Random random, Func<int, int> place = null, string[] words = null)
        {
            var bytes = new List<byte>(sound);
            for (int change = random.Next(1, 4); change > 0 && bytes.Count > 0; change--)
            {
                int at = place != null ? place(bytes.Count)
                    : random.Next(2) == 0 ? random.Next(Math.Min(bytes.Count, 600)) : random.Next(bytes.Count);
                Once(bytes, at, words ?? s_words, random);
            }
            return bytes.ToArray();
        }

        static void Once(List<byte> bytes, int at, string[] words, Random random)
        {
            int length = Math.Min(random.Next(1, 40), bytes.Count - at);
            byte[] word = Encoding.ASCII.GetBytes(words[random.Next(words.Length)]);
            switch (random.Next(10))
            {
                case 0:
                    bytes[at] ^= (byte)(1 << random.Next(8));
                    break;
                case 1:
                    bytes[at] = (byte)random.Next(256);
                    break;
                case 2:
                    if (random.Next(3) == 0)
                        bytes.RemoveRange(at, bytes.Count - at);
                    break;
                case 3:
                    bytes.RemoveRange(at, length);
                    break;
                case 4:
                    bytes.InsertRange(at, bytes.GetRange(at, length));
                    break;
                case 5:
                    bytes.InsertRange(at, word);
                    break;
                case 6:
                    ReplaceWord(bytes, at, word);
                    break;
                case 7:
                    // What follows keeps its place.
                    for (int i = 0; i < word.Length && at + i < bytes.Count; i++)
                        bytes[at + i] = word[i];
                    break;
                default:
                    byte extreme = (byte)(random.Next(2) * 255);
                    int width = 1 << random.Next(4);
                    for (int b = at; b < at + width && b < bytes.Count; b++)
                        bytes[b] = b == at + width - 1 && random.Next(2) == 0 ? (byte)127 : extreme;
                    break;
            }
        }

        static void ReplaceWord(List<byte> bytes, int at, byte[] word)
        {
            int start = at, end = at;
            while (start > 0 && bytes[start - 1] > ' ' && at - start < 20)
                start--;
            while (end < bytes.Count && bytes[end] > ' ' && end - at < 20)
                end++;
            bytes.RemoveRange(start, end - start);
            bytes.InsertRange(start, word);
        }
    }
}
