#include "core/sizes/bucket_queue.h"

#include <queue>
#include <random>
#include <utility>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

using Item = std::pair<float, std::uint32_t>;
using Reference = std::priority_queue<Item, std::vector<Item>, std::greater<>>;

/// Takes from both and pushes zero to two more, as a search would, until `pushes` are done.
void compare(BucketQueue& queue, float longest_step, int pushes, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> step(0.0F, longest_step);
  Reference reference;
  const auto push = [&](float key) {
    const auto value = static_cast<std::uint32_t>(random());
    queue.push(key, value);
    reference.emplace(key, value);
  };
  push(0.0F);
  while (!reference.empty()) {
    ASSERT_FALSE(queue.empty());
    const BucketQueue::Item item = queue.take();
    ASSERT_EQ(Item(item.key, item.value), reference.top());
    reference.pop();
    const std::uint32_t more = reference.empty() ? 1 : random() % 3;
    for (std::uint32_t i = 0; i < more && pushes > 0; ++i, --pushes)
      push(item.key + (random() % 8 == 0 ? 0.0F : random() % 8 == 1 ? longest_step : step(random)));
  }
  EXPECT_TRUE(queue.empty());
}

TEST(BucketQueue, TakesTheLeastFirstAndOfEqualKeysTheLesserValue) {
  for (const float longest_step : {1e-3F, 0.7F, 1.7320508F, 350.0F}) {
    BucketQueue queue(longest_step);
    compare(queue, longest_step, 20000, 1);
  }
}

TEST(BucketQueue, StaysInOrderWhereNearlyAllStepsAreFarShorterThanTheLongest) {
  BucketQueue queue(1e6);
  std::mt19937 random(4);
  Reference reference;
  const auto push = [&](float key) {
    const auto value = static_cast<std::uint32_t>(random());
    queue.push(key, value);
    reference.emplace(key, value);
  };
  push(0.0F);
  for (int taken = 0; taken < 20000; ++taken) {
    const BucketQueue::Item item = queue.take();
    ASSERT_EQ(Item(item.key, item.value), reference.top());
    reference.pop();
    for (int i = 0; i < 2; ++i) push(item.key + static_cast<float>(random() % 1000) / 500);
    if (random() % 100 == 0) push(item.key + 1e6F);
  }
}

TEST(BucketQueue, ForgetsWhatItHeldWhenCleared) {
  BucketQueue queue(2.0);
  compare(queue, 2.0F, 500, 2);
  for (int i = 0; i < 50; ++i) queue.push(0.03F * static_cast<float>(i), 1);
  queue.take();
  queue.clear();
  EXPECT_TRUE(queue.empty());
  compare(queue, 2.0F, 500, 3);
}

}  // namespace
}  // namespace isoloop
