//! The command as its users meet it: what it prints, what it leaves behind, how it ends.

mod answers;
mod assess;
mod calibration;
mod drawings;
mod drawn;
mod examples;
mod house;
mod interruption;
mod messages;
mod misuse;
mod particles;
mod records;
mod respond;
mod stage;
mod table_1;
mod tiny;
mod twins;
mod update;
mod vary;
mod verdict;
mod walls;
